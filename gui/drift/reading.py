"""Files and folders -> turn-ons; no Qt, since ``calrig drift`` reads the same way."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.errors import FitError
from core.procedures.drift.turn_on import TurnOn, turn_ons_of
from core.records.open import read_any
from core.records.run_head import is_run_file
from core.records.series_run import turn_on_of
from drivers.series import read_series

_HEAD = 4096
SUFFIXES = (".calrec", ".csv", ".txt", ".dat")


@dataclass(frozen=True, slots=True)
class How:
    """What a file may not tell.

    Parameters
    ----------
    channel, temperature : name, role or number of the output and of the chip's temperature
    rate : samples per second; 0 for that of the file
    scale_factor : output for 1 deg/s; 0 for that of the file
    """

    channel: str = ""
    temperature: str = ""
    rate: float = 0.0
    scale_factor: float = 0.0


def read_turn_ons(
    path: Path, how: How, ambient_c: float = float("nan")
) -> tuple[tuple[TurnOn, ...], str]:
    """Read a record that began with switching on, or a run file of several; and their unit.

    Parameters
    ----------
    ambient_c : temperature of the chamber; NaN for that of the file or of the chip

    Raises
    ------
    FormatError, FitError
        It holds no turn-on.
    """
    with path.open("rb") as file:
        head = file.read(_HEAD).decode("utf-8-sig", errors="replace")
    if not is_run_file(head):
        one, unit = turn_on_of(
            read_series(path),
            how.channel,
            how.temperature,
            ambient_c=ambient_c,
            rate=how.rate,
            scale_factor=how.scale_factor,
        )
        return (one,), unit
    run = read_any(path)
    if run.test != "record":
        raise FitError(f"{path}: holds a test {run.test!r}, no record since switching on")
    if how.channel and how.channel not in run.channels:
        raise FitError(f"{path}: no output {how.channel!r}; there are: {', '.join(run.channels)}")
    place = run.channels.index(how.channel) if how.channel else 0
    found = turn_ons_of(run, place)
    if np.isfinite(ambient_c):
        found = tuple(replace(one, ambient_c=ambient_c) for one in found)
    return found, run.unit


def files_of(paths: Sequence[Path]) -> list[Path]:
    """The files meant: of a folder all records in it, by name."""
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            inside = (one for one in path.iterdir() if one.suffix.lower() in SUFFIXES)
            found += sorted(one for one in inside if one.is_file())
        else:
            found.append(path)
    return found
