"""Positions decoded again from their raw bytes, beside what was stored."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FormatError, LabError
from core.records.session.events import Position
from core.records.session.record import SessionRecord
from core.samples.accumulate import Accumulation, accumulation_of
from core.samples.block import Channel, SampleBlock

Decode = Callable[[Path], Sequence[SampleBlock]]
"""Decodes the bytes of a raw log from its beginning, so that samples have their old numbers."""

SUFFIX = ".calrec"
_SAME = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Redone:
    """One position.

    Parameters
    ----------
    position : as it is stored
    channels : (k,) that both have
    stored, again : (k,) means
    ratio : (k,) difference over the stored standard error; NaN where that is unknown
    n : samples found again
    why_not : why it could not be decoded; empty if it could
    """

    position: Position
    channels: tuple[Channel, ...]
    stored: FloatArray
    again: FloatArray
    ratio: FloatArray
    n: int
    why_not: str = ""

    @property
    def same(self) -> bool:
        """Whether the same samples gave the same means."""
        return (
            not self.why_not
            and self.n == self.position.accumulation.n
            and bool(np.allclose(self.again, self.stored, rtol=_SAME, atol=_SAME))
        )

    @property
    def largest(self) -> float:
        """The largest difference in standard errors; NaN where there is none."""
        known = self.ratio[np.isfinite(self.ratio)]
        return float(np.abs(known).max()) if known.size else math.nan


def reprocess(record: SessionRecord, raw: Path, decode: Decode) -> tuple[Redone, ...]:
    """Decode the positions of a session that count again, and compare their means.

    Parameters
    ----------
    record : the session
    raw : folder of raw logs that are not in the session's own folder
    decode : today's decoder
    """
    return tuple(_redo(record, position, raw, decode) for position in record.positions)


def _redo(record: SessionRecord, position: Position, raw: Path, decode: Decode) -> Redone:
    path = _log_of(record, position, raw)
    if path is None:
        return _failed(position, "its raw bytes were not recorded")
    if not path.exists():
        return _failed(position, f"its raw log {path.name} is not there")
    try:
        again = _accumulated(path, decode(path), position, record)
    except LabError as error:
        return _failed(position, str(error))
    return _compared(position, again)


def _log_of(record: SessionRecord, position: Position, raw: Path) -> Path | None:
    """The raw log of a position: the one that it names, or the only one in the session's folder."""
    if position.raw is None:
        logs = list(record.folder.glob(f"*{SUFFIX}"))
        return logs[0] if len(logs) == 1 else None
    beside = record.folder / position.raw.name
    return beside if beside.exists() else raw / position.raw.name


def _accumulated(
    path: Path, blocks: Sequence[SampleBlock], position: Position, record: SessionRecord
) -> Accumulation:
    """Mean of the samples with the numbers that were accumulated."""
    old = position.accumulation
    blocks = [block for block in blocks if len(block.index)]
    if not blocks:
        raise FormatError(path, "its bytes hold no samples")
    channels = blocks[-1].channels
    blocks = [block for block in blocks if block.channels == channels]
    index = np.concatenate([block.index for block in blocks])
    data = np.concatenate([block.data for block in blocks])
    ours = (index >= old.first) & (index < old.first + old.n + old.lost)
    if not ours.any():
        raise FormatError(
            path, f"holds the samples {index[0]} to {index[-1]}, and {old.first} was accumulated"
        )
    index, data = index[ours], data[ours]
    t = (index - index[0]) / record.start.rate
    return accumulation_of(channels, t, data, first=int(index[0]), lost=old.lost)


def _compared(position: Position, again: Accumulation) -> Redone:
    old = position.accumulation
    names = [channel.name for channel in again.channels]
    common = [
        (i, names.index(channel.name))
        for i, channel in enumerate(old.channels)
        if channel.name in names and channel.role not in ("counter", "time", "status")
    ]
    if not common:
        return _failed(position, "today's decoder names none of its channels")
    before, after = [i for i, _ in common], [i for _, i in common]
    stored, now, se = old.mean[before], again.mean[after], old.se[before]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(se > 0.0, (now - stored) / se, np.nan)
    channels = tuple(old.channels[i] for i in before)
    return Redone(position, channels, frozen(stored), frozen(now), frozen(ratio), again.n)


def _failed(position: Position, why: str) -> Redone:
    nothing = frozen([])
    return Redone(position, (), nothing, nothing, nothing, 0, why)
