"""Records as text: columns of numbers with or without a head, and run files of a record.

A head may hold the names of the columns, with units (``Gyro Z [deg/s]``, ``temp_degC``), and lines
``# rate_hz = 100``, ``# unit = deg/s``, ``# device = CVG 25-143``. A column of time (``t``,
``time_s``, ``time_ms``) tells the rate; so does the first column without a name if it increases
steadily.
"""

import io
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError, Note, Severity
from core.records.run_file import parse_run
from core.records.run_head import is_run_file
from core.records.series import Series, distinct, named_channel
from core.records.text import decode, lines_of, read_bytes
from core.samples.block import Channel
from core.samples.run import Run

MAX_BYTES = 2**31
HEAD_LINES = 200
_COMMENT = ("#", "%", "//")
_NUMBER = re.compile(r"^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$|^[+-]?(nan|inf)$", re.IGNORECASE)
_TIME = re.compile(r"^(t|time|timestamp|час|время)(?:$|[\s_,(\[]+\(?(s|ms|us|ns|sec|с|мс))", re.I)
_COUNTER = re.compile(r"^(n|no|index|counter|sample)\b", re.IGNORECASE)
_SECONDS = {"s": 1.0, "sec": 1.0, "с": 1.0, "ms": 1e-3, "мс": 1e-3, "us": 1e-6, "ns": 1e-9}
_RATES = ("rate", "rate_hz", "fs", "fs_hz", "sample_rate_hz", "sampling_rate_hz", "frequency_hz")


def read_text_series(path: Path) -> Series:
    """Read a record from text.

    Raises
    ------
    FormatError
        It is no text of numbers; with line and column.
    """
    return parse_text_series(decode(read_bytes(path, max_bytes=MAX_BYTES), path), str(path))


def parse_text_series(text: str, path: str) -> Series:
    """Read the text of a record; `path` stands in messages.

    Raises
    ------
    FormatError
        As `read_text_series`.
    """
    if is_run_file(text[:4096]):
        return of_run(parse_run(text, path), path)
    head = _read_head(text, path)
    table = _numbers(text, head, path)
    columns = tuple(frozen(column) for column in table.T)
    channels = _channels(head, len(columns))
    axis = _axis(head, columns)
    if axis is not None:
        kept = [other for other in range(len(columns)) if other != axis.place]
        columns = tuple(columns[other] for other in kept)
        channels = tuple(channels[other] for other in kept)
        if not columns:
            raise FormatError(path, "holds time stamps only, no column of samples")
    return Series(
        path=path,
        device=head.told.get("device", Path(path).stem),
        channels=channels,
        columns=columns,
        n=len(columns[0]),
        rate=_rate(head.told),
        index=None if axis is None else axis.index,
        time=None if axis is None else axis.time,
        notes=() if axis is None else axis.notes,
    )


def of_run(run: Run, path: str) -> Series:
    """Return the record that a run file of the test ``record`` holds.

    Raises
    ------
    FormatError
        The run is of another test: its rows are means, no samples.
    """
    if run.test != "record":
        raise FormatError(path, f"holds a test {run.test!r}: rows of means, no record of samples")
    kind = "rate." if run.sensor == "gyro" else "acc."
    channels = [
        Channel(name, run.unit, f"{kind}{axis or 'z'}")
        for name, axis in zip(run.channels, run.axes, strict=True)
    ]
    columns = [frozen(run.y[:, place]) for place in range(run.y.shape[1])]
    if np.any(np.isfinite(run.temperature_c)):
        channels.append(Channel("temperature", "degC", "temp"))
        columns.append(run.temperature_c)
    for name, column in run.extra.items():
        channels.append(named_channel(name))
        columns.append(column)
    timed = bool(np.all(np.isfinite(run.t_s)))
    stated = run.conditions.sample_rate_hz
    return Series(
        path=path,
        device=run.device,
        channels=distinct(tuple(channels)),
        columns=tuple(columns),
        n=len(run),
        rate=stated if stated > 0.0 and not timed else 0.0,
        time=run.t_s if timed else None,
        notes=run.notes,
    )


@dataclass(frozen=True, slots=True)
class _Head:
    """What stands before the numbers.

    Parameters
    ----------
    lines : number of lines before the first row
    separator : between cells; None for white space
    comma : the decimal mark is a comma
    titles : of the columns; empty for none
    told : what comments of the form ``key = value`` say
    """

    lines: int
    separator: str | None
    comma: bool
    titles: tuple[str, ...]
    told: Mapping[str, str]


def _read_head(text: str, path: str) -> _Head:
    lines = lines_of(text[: 1 << 16])
    told: dict[str, str] = {}
    title = ""
    for place, line in enumerate(lines[:HEAD_LINES]):
        stripped = line.strip()
        bare = stripped.lstrip("#%/ \t")
        if not stripped:
            continue
        if not stripped.startswith(_COMMENT):
            separator, comma = _separator(stripped, title)
            cells = _cells(stripped, separator, comma)
            if all(_NUMBER.match(cell) or not cell for cell in cells) and any(cells):
                titles = _titles(title, separator, len(cells))
                return _Head(place, separator, comma, titles, told)
        match = re.match(r"^([\w ]+?)\s*[=:]\s*(.+)$", bare)
        if match is not None:
            told[match[1].strip().lower().replace(" ", "_")] = match[2].strip().strip('"')
        else:
            title = bare
    if not lines:
        raise FormatError(path, "is empty: no samples")
    raise FormatError(
        path, f"no row of numbers in the first {min(len(lines), HEAD_LINES)} lines; is it a record?"
    )


def _separator(line: str, title: str) -> tuple[str | None, bool]:
    """Return what stands between the cells, and whether the decimal mark is a comma."""
    if title.count(",") == line.count(",") > 0 and not set(";\t") & set(line):
        return ",", False
    if ";" in line:
        return ";", "," in line
    if "\t" in line:
        return "\t", "," in line and "." not in line
    words = line.split()
    if len(words) > 1 and not any(word.endswith(",") for word in words):
        return None, "," in line and "." not in line
    # 1,5 alone on a line is a decimal comma; 1,5,2 and 1.5,2 are cells.
    if line.count(",") == 1 and "." not in line and len(words) == 1:
        return None, True
    return ("," if "," in line else None), False


def _cells(line: str, separator: str | None, comma: bool) -> list[str]:
    cells = [cell.strip() for cell in line.split(separator)]
    if separator is not None and len(cells) > 1 and not cells[-1]:
        cells.pop()
    return [cell.replace(",", ".") for cell in cells] if comma else cells


def _titles(line: str, separator: str | None, count: int) -> tuple[str, ...]:
    for mark in (separator, ",", ";", "\t", None):
        cells = [cell.strip() for cell in line.split(mark)]
        if len(cells) == count and all(cells):
            return tuple(cells)
    return ()


def _numbers(text: str, head: _Head, path: str) -> FloatArray:
    """Return the (n, c) numbers below the head."""
    body = io.StringIO(text, newline=None)
    for _ in range(head.lines):
        body.readline()
    rest = body.read()
    if head.comma:
        rest = rest.replace(",", ".")
    try:
        return np.loadtxt(io.StringIO(rest), delimiter=head.separator, ndmin=2, comments=None)
    except ValueError:
        return _slowly(rest, head, path)


def _slowly(rest: str, head: _Head, path: str) -> FloatArray:
    """Read row by row; an empty cell is a lost sample, what is no number is refused."""
    rows: list[list[float]] = []
    separator = head.separator
    last = 0
    lines = lines_of(rest)
    for number, line in enumerate(lines, start=1):
        if line.strip():
            last = number
    for number, line in enumerate(lines, start=1):
        stripped = line.strip()
        if not stripped:
            continue
        cells = [cell.strip() for cell in stripped.split(separator)]
        if rows and len(cells) == len(rows[0]) + 1 and not cells[-1]:
            cells.pop()
        row: list[float] = []
        for column, cell in enumerate(cells, start=1):
            try:
                row.append(float(cell) if cell else np.nan)
            except ValueError as error:
                raise FormatError(
                    path, f"{cell[:40]!r} is no number", line=head.lines + number, column=column
                ) from error
        if rows and len(row) != len(rows[0]):
            if number == last and len(row) < len(rows[0]):
                break  # a record that was cut off while its last row was written
            why = f"{len(row)} cells, the rows before have {len(rows[0])}"
            raise FormatError(path, why, line=head.lines + number)
        rows.append(row)
    return np.array(rows)


def _channels(head: _Head, count: int) -> tuple[Channel, ...]:
    titles = head.titles or tuple(f"column {place}" for place in range(1, count + 1))
    channels = distinct(tuple(named_channel(title) for title in titles))
    unit = head.told.get("unit", "")
    if unit:
        stated = named_channel(f"x [{unit}]").unit
        channels = tuple(
            replace(one, unit=stated) if one.unit == "code" and one.role != "temp" else one
            for one in channels
        )
    return channels


def _rate(told: Mapping[str, str]) -> float:
    for key in _RATES:
        if key in told:
            try:
                return max(float(told[key].split()[0].replace(",", ".")), 0.0)
            except ValueError:
                return 0.0
    return 0.0


@dataclass(frozen=True, slots=True, eq=False)
class _Axis:
    """The column that counts or times the samples; `index` or `time` is None."""

    place: int
    index: IntArray | None
    time: FloatArray | None
    notes: tuple[Note, ...] = ()


def _axis(head: _Head, columns: tuple[FloatArray, ...]) -> _Axis | None:
    """Find the column of time or of sample numbers."""
    for place, title in enumerate(head.titles):
        match = _TIME.match(title)
        if match is not None:
            seconds = _SECONDS[(match[2] or "s").lower()]
            return _Axis(place, None, frozen(columns[place] * seconds))
        if _COUNTER.match(title) and _counts(columns[place]):
            return _Axis(place, frozen_int(columns[place]), None)
    if head.titles or len(columns) < 2 or len(columns[0]) < 3:
        return None
    if _counts(columns[0]):
        return _Axis(0, frozen_int(columns[0]), None)
    steps = np.diff(columns[0])
    if np.all(steps > 0.0) and float(np.ptp(steps)) < 0.5 * float(np.median(steps)):
        text = (
            f"the first column has no name and increases by {float(np.median(steps)):.6g} each row:"
            " it is taken for the time in seconds"
        )
        return _Axis(0, None, columns[0], (Note(Severity.INFO, "time", text),))
    return None


def _counts(column: FloatArray) -> bool:
    """Whether a column holds sample numbers: whole, increasing, mostly by one."""
    if not np.all(np.isfinite(column)) or len(column) < 2:
        return False
    steps = np.diff(column)
    whole = bool(np.array_equal(column, np.rint(column)))
    return whole and bool(np.all(steps >= 1.0)) and float(np.median(steps)) == 1.0
