"""Which numbers the varying bytes of frames hold.

Each way of cutting the bytes into numbers has a length in bits at which the frames could be written
down: a number costs about the logarithm of how far it moves around its middle or from one frame to
the next. A wrong byte order or a cut through the middle of a number puts the noise of its low byte
into a high place and costs some eight bits a frame more, so the shortest description is the right
one wherever the low bytes move. A number whose high bytes never move cannot be told from a shorter
one; the prices of `_PRICES` say what is then believed.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.samples.block import Channel
from drivers.fields import read_raw
from drivers.profile_types import TYPES, FieldSpec
from drivers.shape import ByteArray

_PRICES = {
    "u8": 3.0, "i8": 3.2, "u16": 1.05, "i16": 1.0, "u24": 1.35, "i24": 1.3,
    "u32": 1.45, "i32": 1.4, "f32": -0.5, "f64": -1.0,
}  # fmt: skip
_SKIP, _SKIP_ODD = 0.5, 1.5
_DULL = (0x00, 0xFF)
_ALIKE = 0.7
_ENDIANS = ("little", "big")
_COUNTED = 0.8
_WRAP, _COUNTER = 6.0, 0.1
_MOST = 200
_SMALLEST, _LARGEST = 1e-5, 1e6
_TOO_SMALL, _TOO_LARGE = 1e-20, 1e9
_FEWEST = 8


@dataclass(frozen=True, slots=True)
class Hint:
    """What a field looks like.

    Parameters
    ----------
    kind : ``"counter"``, ``"constant"``, ``"noise"``, ``"ramp"``, ``"flags"``
    step : of a counter, else 0
    """

    kind: str
    step: int = 0


def field_of(name: str, type_: str, at: int, endian: str) -> FieldSpec:
    """Return a field of one plain number."""
    return FieldSpec((Channel(name, "code"),), type_, at, endian=endian)


def guess_fields(rows: ByteArray, first: int, stop: int) -> tuple[str, list[FieldSpec]]:
    """Return the byte order and the fields between two places of frames.

    Parameters
    ----------
    rows : (n, length) uint8, whole frames in their order
    first, stop : place of the first byte, and the one after the last
    """
    rows = np.ascontiguousarray(rows[-_MOST:])
    if len(rows) < _FEWEST or stop <= first:
        return "little", []
    plans = [(*_cheapest(rows, first, stop, endian), endian) for endian in _ENDIANS]
    _, cut, endian = min(plans, key=lambda plan: plan[0])
    return endian, [field_of(f"b{at}", type_, at, endian) for at, type_ in cut]


def bits_of(rows: ByteArray, first: int, stop: int) -> float:
    """Return the bits a frame of the shortest description between two places of frames."""
    rows = np.ascontiguousarray(rows[-_MOST:])
    if len(rows) < _FEWEST:
        return 8.0 * (stop - first)
    return min(_cheapest(rows, first, stop, endian)[0] for endian in _ENDIANS)


def _cheapest(
    rows: ByteArray, first: int, stop: int, endian: str
) -> tuple[float, list[tuple[int, str]]]:
    """Return the bits a frame of the shortest description, and its numbers in order."""
    still = np.all(rows == rows[0], axis=0)
    table = _table(rows, endian)
    # By place and by the type of the number before it: bits from there on, and what comes next.
    best: list[dict[str, tuple[float, str]]] = [{} for _ in range(stop + 1)]
    best[stop] = dict.fromkeys(("", *_PRICES), (0.0, ""))
    for at in range(stop - 1, first - 1, -1):
        dull = int(rows[0, at]) in _DULL
        skipped = (_SKIP if dull else _SKIP_ODD) if still[at] else 8.0 + _PRICES["u8"]
        skip = skipped + best[at + 1][""][0]
        costs: dict[str, float] = {}
        for type_, price in _PRICES.items():
            end = at + TYPES[type_]
            if end <= stop and not still[at:end].all():
                costs[type_] = price + float(table[type_][at]) + best[end][type_][0]
        for before in ("", *_PRICES):
            choice = (skip, "")
            for type_, cost in costs.items():
                choice = min(choice, (cost - (_ALIKE if type_ == before else 0.0), type_))
            best[at][before] = choice
    cut: list[tuple[int, str]] = []
    at, before = first, ""
    while at < stop:
        before = best[at][before][1]
        if before:
            cut.append((at, before))
        at += TYPES[before] if before else 1
    return best[first][""][0], cut


def _table(rows: ByteArray, endian: str) -> dict[str, FloatArray]:
    """Return the bits a frame of a number of each type at each place; infinite where none fits."""
    return {type_: _bits(rows, type_, endian) for type_ in _PRICES}


def _bits(rows: ByteArray, type_: str, endian: str) -> FloatArray:
    size = TYPES[type_]
    length = rows.shape[1]
    costs = np.full(length + 1, np.inf)
    places = length - size + 1
    if places < 1:
        return costs
    windows = np.lib.stride_tricks.sliding_window_view(rows, size, axis=1)
    every = np.ascontiguousarray(windows).reshape(len(rows), places * size)
    names = (Channel("", "code"),) * places
    numbers = read_raw(every, FieldSpec(names, type_, 0, endian=endian))
    if type_[0] == "f":
        costs[:places] = _float_bits(numbers, 8 * size)
        return costs
    top = 8 * size
    values = numbers.astype(np.int64)
    steps = np.diff(values, axis=0)
    level = _spread(values - np.median(values, axis=0))
    plain = np.minimum(np.minimum(level, _spread(steps)), top)
    step, share = _steps(steps, top)
    breaks = (steps - step) % (1 << top) != 0
    narrow = np.zeros(places, dtype=np.bool_)
    for bits in range(8, top, 8):
        narrow |= np.any(breaks & (steps == step - (1 << bits)), axis=0)
    counting = (
        (0.3 if type_[0] == "i" else 0.1)
        + np.mean(breaks, axis=0) * top
        + np.where(narrow, _WRAP, 0.0)
    )
    costs[:places] = np.where((step != 0) & (share >= _COUNTED), counting, plain)
    return costs


def _steps(steps: NDArray[np.int64], bits: int) -> tuple[NDArray[np.int64], FloatArray]:
    """Return the commonest step of each column, 0 for what does not count, and its share.

    What counts by most of its steps has them in the middle of all. A number whose lowest byte
    never moves is no counter: the one is there without that byte.
    """
    if not len(steps):
        columns = int(steps.shape[1])
        return np.zeros(columns, dtype=np.int64), np.zeros(columns)
    turned: NDArray[np.int64] = steps % (1 << bits)
    middle: NDArray[np.int64] = np.partition(turned, len(turned) // 2, axis=0)[len(turned) // 2]
    share: FloatArray = np.asarray(np.mean(turned == middle, axis=0), dtype=np.float64)
    high = (middle >= 1 << (bits - 1)) | ((middle % 256 == 0) & (bits > 8))
    middle[high] = 0
    return middle, share


def _spread(residuals: FloatArray | NDArray[np.int64]) -> FloatArray:
    """Return the bits of integers about zero, by a code that knows no distribution; by column."""
    bits = 1.0 + np.mean(np.log2(1.0 + 2.0 * np.abs(residuals)), axis=0)
    return np.where(np.any(residuals, axis=0), bits, 0.0)


def _float_bits(numbers: FloatArray, top: int) -> FloatArray:
    """Return the bits of floating-point numbers, infinite where they are none; by column."""
    finite = np.isfinite(numbers).all(axis=0)
    finite &= np.max(np.abs(np.where(finite, numbers, np.inf)), axis=0) < _TOO_LARGE
    values = np.where(finite, numbers, 0.0).astype(np.float64)
    sizes = np.abs(values)
    usual = np.median(sizes, axis=0)
    least = np.min(np.where(sizes > 0.0, sizes, np.inf), axis=0)
    good = finite & (usual > _SMALLEST) & (usual < _LARGEST)
    good &= least > _TOO_SMALL
    values, usual = np.where(good, values, 0.0), np.where(good, usual, 1.0)
    finest = np.exp2(np.floor(np.log2(usual)) - (23.0 if top == 32 else 52.0))
    level = _spread((values - np.median(values, axis=0)) / finest)
    change = _spread(np.diff(values, axis=0) / finest)
    return np.where(good, np.minimum(np.minimum(level, change), top), np.inf)


def counted(values: NDArray[np.int64], bits: int) -> tuple[int, float]:
    """Return the commonest step of a counter of so many bits, and the share of steps that are it.

    The step is 0 for what does not count.
    """
    step, share = _steps(np.diff(values).reshape(-1, 1), bits)
    return int(step[0]), float(share[0])


def hint_of(rows: ByteArray, spec: FieldSpec) -> Hint:
    """Return what a field looks like in these frames."""
    numbers = read_raw(rows, spec)[:, 0]
    if len(numbers) < 2 or not np.any(numbers != numbers[0]):
        return Hint("constant")
    if spec.type[0] != "f":
        values = numbers.astype(np.int64)
        bits = 8 * TYPES[spec.type]
        step, share = counted(values, bits)
        if step and share >= _COUNTED:
            return Hint("counter", step)
        if len(np.unique(values)) <= 4 and np.mean(np.diff(values) != 0) < 0.2:
            return Hint("flags")
    finite = numbers.astype(np.float64)
    finite = finite[np.isfinite(finite)]
    if len(finite) < _FEWEST:
        return Hint("noise")
    moves = np.diff(finite)
    ramp = abs(finite[-1] - finite[0]) > 4.0 * np.sum(np.abs(moves)) / np.sqrt(len(moves))
    return Hint("ramp" if ramp else "noise")
