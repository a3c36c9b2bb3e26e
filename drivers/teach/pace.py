"""How many frames or lines a board sends in a second, and whether that can be told.

The rate of the bytes tells it where they came as the board sent them. A log of the simulated rig or
of a recording that was played fast has other times; then a number of the frames that counts
milliseconds or microseconds may tell it, and if none does, it is not told.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from urllib.parse import parse_qs, urlsplit

import numpy as np

from core.arrays import FloatArray
from core.samples.block import SampleBlock
from drivers.fields import read_raw
from drivers.line import LineDecoder
from drivers.profile_types import TYPES, FrameSpec, LineSpec
from drivers.teach.rows import frames_in

USUAL_HZ = (
    1, 2, 5, 10, 20, 25, 40, 50, 60, 80, 100, 120, 125, 200, 240, 250, 256, 300, 400, 500, 512,
    600, 800, 1000, 1024, 1600, 2000, 4000,
)  # fmt: skip
_NEAR = 0.015
_SLOWEST, _FASTEST = 5.0, 4000.0
"""Between these a step is a time in one unit only: the units lie a thousand apart."""
_UNITS = (
    ("the time in seconds", 1.0),
    ("the time in milliseconds", 1e3),
    ("the time in microseconds", 1e6),
)
_BITS_A_BYTE = 10
_CARRIED = 1.1
_EVEN = 0.25
_MOST = 0.8
_FEWEST = 20


@dataclass(frozen=True, slots=True)
class Pace:
    """How fast frames or lines come.

    Parameters
    ----------
    hz : a second; 0 where it cannot be told
    why : where it is from if not from the clock, or why it is not known; empty if from the clock
    """

    hz: float = 0.0
    why: str = ""


def clock_doubt(address: str, baud: int = 0, bytes_per_s: float = 0.0) -> str:
    """Return why the times of some bytes are not those of the board; empty where they may be.

    Parameters
    ----------
    address : of the port that they came from
    baud : its speed; 0 if unknown, or if it is no wire that could be too slow
    bytes_per_s : how fast they came
    """
    parts = urlsplit(address)
    speed = parse_qs(parts.query).get("speed", ["1"])[0]
    if parts.scheme in ("sim", "replay") and speed not in ("1", "1.0"):
        return f"{address} does not run in real time"
    if baud > 0 and bytes_per_s > _CARRIED * baud / _BITS_A_BYTE:
        return f"its bytes came faster than {baud} baud can carry"
    return ""


def pace_of(data: bytes, stream: FrameSpec | LineSpec, clock_hz: float, doubt: str = "") -> Pace:
    """Return how fast frames or lines come.

    Parameters
    ----------
    data : bytes of the stream
    stream : what they are
    clock_hz : by the times at which they came; 0 if unknown
    doubt : why those times are not the board's; empty where they are
    """
    if clock_hz > 0.0 and not doubt:
        return Pace(usual_rate(clock_hz))
    doubt = doubt or "no times of its bytes are known"
    for name, values in _numbers(data, stream):
        found = _by_time(values)
        if found is not None:
            hz, unit = found
            return Pace(hz, f"{doubt}; {name} is {unit}, by which it is {hz:g} a second")
    return Pace(0.0, f"{doubt}, and none of its numbers is the time")


def usual_rate(hz: float) -> float:
    """Return the round rate that a measured one stands for, or the measured one in three digits."""
    near = min(USUAL_HZ, key=lambda usual: abs(usual - hz))
    return float(near) if abs(near - hz) <= _NEAR * hz else float(f"{hz:.3g}")


def _by_time(values: FloatArray) -> tuple[float, str] | None:
    """Return rate and unit if a number is the time; None if it is none that can be told."""
    if len(values) < _FEWEST or not np.isfinite(values).all():
        return None
    steps = np.diff(values)
    step = float(np.median(steps))
    whole = bool(np.all(values == np.rint(values)))
    # What counts by one counts frames.
    if step <= 0.0 or (whole and step < 2.0):
        return None
    slack = max(_EVEN * step, 1.0) if whole else _EVEN * step
    even = steps[np.abs(steps - step) <= slack]
    if len(even) < _MOST * len(steps):
        return None
    for unit, parts in _UNITS:
        hz = parts / float(even.mean())
        if _SLOWEST <= hz <= _FASTEST and usual_rate(hz) in USUAL_HZ:
            return usual_rate(hz), unit
    return None


def _numbers(data: bytes, stream: FrameSpec | LineSpec) -> Iterable[tuple[str, FloatArray]]:
    """Yield the numbers that may be a time, by their names."""
    if isinstance(stream, LineSpec):
        events = LineDecoder(stream, 0.0).feed(data)
        blocks = [event.data for event in events if isinstance(event, SampleBlock)]
        if blocks:
            yield from zip(
                (one.name for one in stream.channels), np.concatenate(blocks).T, strict=True
            )
        return
    rows, _, _ = frames_in(data, stream)
    for field in stream.fields:
        if TYPES[field.type] > 1 and len(rows):
            numbers = read_raw(rows, field)[:, 0].astype(np.float64)
            yield field.channels[0].name, numbers if math.isfinite(numbers[0]) else numbers[:0]
