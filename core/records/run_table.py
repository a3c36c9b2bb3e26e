"""The table of a run file: column names, then rows."""

import csv
import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError

LABELS = "labels "
"""Key in `meta` of the texts of a column that holds texts: this and the column's name."""


@dataclass(frozen=True, slots=True)
class Output:
    """Columns of one output: its means, their standard errors, and what tells it from others."""

    y: str
    se: str
    suffix: str


@dataclass(frozen=True, slots=True)
class Table:
    """Cells of a run file.

    Parameters
    ----------
    path : the file, for messages
    cells : texts (n,) by column name
    lines : (n,) line of each row
    decimal : decimal mark
    """

    path: str
    cells: Mapping[str, list[str]]
    lines: list[int]
    decimal: str

    def __len__(self) -> int:
        return len(self.lines)

    def outputs(self, channels: tuple[str, ...]) -> list[Output]:
        """The columns of outputs: ``y``, or ``y_x``, ``y_y``...; ``y_se_x`` or ``y_x_se`` with it.

        Parameters
        ----------
        channels : names of the channels where the head tells them

        Raises
        ------
        FormatError
            There are none, or not as many as channels.
        """
        if "y" in self.cells:
            found = [Output("y", "y_se", "")]
        else:
            names = [name for name in self.cells if name.startswith("y_")]
            errors = {f"y_se_{name[2:]}" for name in names} | {f"{name}_se" for name in names}
            named = [f"y_{channel}" for channel in channels]
            if not named or not set(named) <= set(names):
                named = [name for name in names if name not in errors]
            found = [Output(name, self._error_of(name[2:]), name[2:]) for name in named]
        if not found:
            raise FormatError(self.path, "no column of outputs: y, or y_x, y_y, y_z")
        if channels and len(channels) != len(found):
            raise FormatError(
                self.path, f"{len(channels)} channels are named, {len(found)} outputs found"
            )
        return found

    def _error_of(self, suffix: str) -> str:
        return f"y_se_{suffix}" if f"y_se_{suffix}" in self.cells else f"y_{suffix}_se"

    def texts(self, name: str) -> tuple[str, ...]:
        """A column of texts, empty where there is none."""
        return tuple(self.cells.get(name, [""] * len(self)))

    def numbers(self, name: str, *, needed: bool = False) -> FloatArray:
        """A column of numbers; NaN where a cell is empty or the column is missing.

        Raises
        ------
        FormatError
            A cell holds no number, or none where one is needed.
        """
        if name not in self.cells:
            return frozen(np.full(len(self), np.nan))
        values = self._numbers(self.cells[name])
        wrong = np.isinf(values) | (np.isnan(values) if needed else False)
        for row in np.flatnonzero(wrong | self._unreadable(name, values)).tolist():
            cell = self.cells[name][row]
            raise self._wrong(name, row, f"{cell!r} is no number" if cell else f"{name} is missing")
        return frozen(values)

    def integers(self, name: str, default: FloatArray) -> IntArray:
        """A column of whole numbers.

        Raises
        ------
        FormatError
            A cell holds none.
        """
        if name not in self.cells:
            return frozen_int(default)
        values = self.numbers(name, needed=True)
        for row, value in enumerate(values.tolist()):
            if value != round(value) or abs(value) > 2**53:
                raise self._wrong(name, row, f"{self.cells[name][row]!r} is no whole number")
        return frozen_int(values)

    def others(self, used: set[str]) -> tuple[dict[str, FloatArray], dict[str, str]]:
        """The columns that are not `used`; those of texts as places in a list of their labels."""
        columns: dict[str, FloatArray] = {}
        labels: dict[str, str] = {}
        for name, cells in self.cells.items():
            if name in used:
                continue
            values = self._numbers(cells)
            if self._unreadable(name, values).any():
                different = {cell: place for place, cell in enumerate(dict.fromkeys(cells))}
                values = np.array([different[cell] for cell in cells], dtype=np.float64)
                labels[LABELS + name] = json.dumps(list(different), ensure_ascii=False)
            columns[name] = frozen(values)
        return columns, labels

    def _numbers(self, cells: list[str]) -> FloatArray:
        """Numbers of cells, NaN where one is empty or holds none."""
        if self.decimal == ",":
            cells = [cell.replace(",", ".") for cell in cells]
        try:
            return np.array(list(map(float, cells)))
        except ValueError:
            return np.array([_number(cell) for cell in cells])

    def _unreadable(self, name: str, values: FloatArray) -> NDArray[np.bool_]:
        """Which cells hold something that is no number."""
        found = np.isnan(values)
        for row in np.flatnonzero(found).tolist():
            found[row] = self.cells[name][row].lower() not in ("", "nan")
        return found

    def _wrong(self, name: str, row: int, why: str) -> FormatError:
        return FormatError(
            self.path,
            f"column {name!r}: {why}",
            line=self.lines[row],
            column=list(self.cells).index(name) + 1,
        )


def read_table(lines: list[str], first: int, path: str) -> Table:
    """Read a table whose column names stand in the first of `lines`, line `first` of the file.

    Raises
    ------
    FormatError
        It is no CSV, a row has another number of cells, or there are no rows.
    """
    # A spreadsheet on a Ukrainian computer writes semicolons and decimal commas.
    separators = re.sub(r'"[^"]*"|[^,;]', "", lines[0])
    mark = separators[:1] or ","
    reader = csv.reader((line + "\n" for line in lines), delimiter=mark, strict=True)
    names: list[str] = []
    rows: list[list[str]] = []
    places: list[int] = []
    try:
        for cells in reader:
            line = first + reader.line_num - 1
            stripped = [cell.strip() for cell in cells]
            if not names:
                names = stripped
                _check_names(names, path, line)
            elif any(stripped):
                if len(stripped) != len(names):
                    why = f"{len(stripped)} cells, the names have {len(names)}"
                    raise FormatError(path, why, line=line)
                rows.append(stripped)
                places.append(line)
    except csv.Error as error:
        raise FormatError(path, f"no CSV: {error}", line=first + reader.line_num - 1) from error
    if not rows:
        raise FormatError(path, "holds no rows")
    columns = dict(zip(names, map(list, zip(*rows, strict=True)), strict=True))
    return Table(path, columns, places, "," if mark == ";" else ".")


def _number(cell: str) -> float:
    try:
        return float(cell)
    except ValueError:
        return math.nan


def _check_names(names: list[str], path: str, line: int) -> None:
    for place, name in enumerate(names, start=1):
        if not name:
            raise FormatError(path, "a column has no name", line=line, column=place)
        if names.index(name) != place - 1:
            raise FormatError(path, f"column {name!r} comes twice", line=line, column=place)
