"""The tab's part of the demonstration: a board that no device file knows is taught from a log."""

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.errors import LinkError
from core.samples.block import Channel
from drivers.checksums import Checksum, ChecksumSpec, CrcSpec
from drivers.fields import write_raw
from drivers.profile import load_profile
from drivers.profile_types import FieldSpec, FrameSpec
from drivers.rawlog import RawLog
from drivers.virtual.truth import Compared
from gui.frames.tab import FramesTab
from gui.measuring.demonstrating import Stage, Told

TITLE = "Teach a board"
_RATE = 200
_FRAMES = 1200
_CRC = ChecksumSpec(
    "crc16", 0, -2, -2, 2, "big", crc=CrcSpec(16, 0xA097, init=0x1D3B, xorout=0x5AA5)
)
_SYNC = b"\x9c\xd1"
_LENGTH = 17
_GARBAGE = 0.05


@dataclass(frozen=True, slots=True)
class _Number:
    """A number of the board: its type, place, middle and scatter in codes."""

    name: str
    type: str
    at: int
    middle: float
    scatter: float


_NUMBERS = (
    _Number("acc_x", "i24", 4, 4_100.0, 900.0),
    _Number("acc_y", "i24", 7, -21_500.0, 900.0),
    _Number("acc_z", "i24", 10, 1_049_000.0, 900.0),
    _Number("temp", "i16", 13, 6_420.0, 6.0),
)


def play(stage: Stage) -> Told:
    """Find the layout, name the numbers, save the device file."""
    tab = stage.show(TITLE)
    if not isinstance(tab, FramesTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    presenter = tab.presenter
    log = tab.source.raw_folder / "invented-board.calrec"
    _record(log)
    tab.load(log)
    stage.until(lambda: presenter.state.sure, "the layout was not found")
    stage.picture("teach-found")
    for place, field in enumerate(presenter.state.fields):
        known = next(
            (one for one in _NUMBERS if field.place.startswith(f"{one.at}\N{EN DASH}")), None
        )
        if known is not None and known.name.startswith("acc"):
            presenter.rename(place, known.name, "m/s^2", known.name.replace("_", "."))
            presenter.rescale(place, "9.80665/2**20", "0")
        elif known is not None:
            presenter.rename(place, known.name, "degC", "temp")
            presenter.rescale(place, "1/256", "0")
    presenter.describe("Invented board", "accel")
    presenter.edit(1)
    stage.picture("teach-named")
    path = presenter.save()
    if path is None:
        raise LinkError(str(log), "the device file could not be saved", presenter.state.doubt)
    stage.keep(path)
    spec = load_profile(path).stream
    if not isinstance(spec, FrameSpec):
        raise TypeError(f"{path} describes {type(spec).__name__}")
    told = [
        Compared(
            "Invented board",
            "length",
            "bytes",
            spec.shortest,
            0.0,
            _LENGTH,
            spec.shortest == _LENGTH,
        )
    ]
    for one in _NUMBERS:
        at = next((f.at for f in spec.fields if f.channels[0].name == one.name), -1)
        told.append(Compared("Invented board", one.name, "byte", at, 0.0, one.at, at == one.at))
    return Told(TITLE, tuple(told), path.parent)


def _record(path: Path) -> None:
    """Write what such a board would send in six seconds."""
    rng = np.random.default_rng(7)
    rows = np.zeros((_FRAMES, _LENGTH), np.uint8)
    rows[:, :2] = np.frombuffer(_SYNC, np.uint8)
    rows[:, 2] = _LENGTH - 5
    rows[:, 3] = np.arange(_FRAMES) % 256
    for one in _NUMBERS:
        codes = np.rint(one.middle + one.scatter * rng.standard_normal(_FRAMES)).astype(np.int64)
        field = FieldSpec((Channel(one.name, "code"),), one.type, one.at, endian="big")
        write_raw(rows, field, codes.reshape(-1, 1))
    Checksum(_CRC).stamp(rows)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    log = RawLog(path, {"device": "invented board"})
    zero = time.monotonic()
    for first in range(0, _FRAMES, 8):
        data = b"".join(
            row.tobytes() + (rng.bytes(4) if rng.random() < _GARBAGE else b"")
            for row in rows[first : first + 8]
        )
        log.write(data, zero + (first + 8) / _RATE)
    log.close()
