"""Lines of a legacy file as tokens and numbers.

A device name may hold blanks and even end with a number, so that the numbers of a row are counted
from the right. Where tabs or semicolons part the columns, the name is whatever the first one holds.
"""

import math
import re
from dataclasses import dataclass

from core.errors import FormatError

MAX_NUMBERS = 24
"""No layout has more numbers in a row; what stands further left belongs to the name."""

_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?", re.ASCII)
_PLAIN = re.compile(r"[0-9.+\-eE]*", re.ASCII)
_SEPARATOR = re.compile(r"\s*;\s*|\s+")


@dataclass(frozen=True, slots=True)
class TextRow:
    """One line that is not blank.

    Parameters
    ----------
    line : its number in the file, 1-based
    cells : its columns
    tail : the numbers at its right end, at most `MAX_NUMBERS`
    sure : whether the separators tell where the name ends
    """

    line: int
    cells: list[str]
    tail: list[float]
    sure: bool

    def fits(self, numbers: int) -> bool:
        """Whether the row can be a name and this many numbers."""
        extra = len(self.cells) - numbers
        if extra < 1 or len(self.tail) < numbers:
            return False
        if self.sure:
            return extra == 1
        # A name may end with a serial number, never with something like -0.5.
        return all(cell.isalnum() for cell in self.cells[len(self.cells) - len(self.tail) : extra])

    def name(self, numbers: int) -> str:
        """The device's name, left of this many numbers."""
        return " ".join(self.cells[: len(self.cells) - numbers])


def number_of(cell: str) -> float:
    """Return the number in a cell, NaN if it holds none; ``.`` or ``,`` is the decimal mark."""
    if _NUMBER.fullmatch(cell) is None:
        return math.nan
    value = float(cell.replace(",", "."))
    return value if math.isfinite(value) else math.nan


def text_rows(lines: list[str]) -> list[TextRow]:
    """Return the rows of the lines that are not blank."""
    rows: list[TextRow] = []
    for number, line in enumerate(lines, start=1):
        cells, sure = _cells(line)
        if not any(cells):
            continue
        rows.append(TextRow(number, cells, _tail(cells), sure))
    return rows


def _tail(cells: list[str]) -> list[float]:
    """The numbers at the right end of a row."""
    last = cells[-MAX_NUMBERS:]
    tail = _plain_numbers(last[1:])
    if not tail:
        for cell in reversed(last):
            value = number_of(cell)
            if math.isnan(value):
                break
            tail.append(value)
        return tail[::-1]
    first = number_of(last[0])
    return tail if math.isnan(first) else [first, *tail]


def _plain_numbers(cells: list[str]) -> list[float]:
    """Numbers of an undamaged row with decimal points, quickly; empty for any other."""
    if _PLAIN.fullmatch("".join(cells)) is None:
        return []
    try:
        numbers = list(map(float, cells))
    except ValueError:
        return []
    return numbers if all(map(math.isfinite, numbers)) else []


def why_no_number(cell: str) -> str:
    """What is wrong with a cell that should hold a number."""
    if not cell:
        return "the column is empty"
    shown = cell if len(cell) <= 40 else cell[:40] + "..."
    if cell.lower().lstrip("+-") in ("nan", "inf", "infinity", "1.#qnan", "1.#ind", "-nan(ind)"):
        return f"{shown!r} is no measurement"
    return f"{shown!r} is no number"


def check_decimal_marks(path: str, rows: list[TextRow], numbers: int) -> None:
    """Refuse a file that uses both ``.`` and ``,``: one of them may part thousands.

    Raises
    ------
    FormatError
        At the first number with the other mark.
    """
    first = ""
    if not any("," in cell for row in rows for cell in row.cells[-numbers:]):
        return
    for row in rows:
        for place, cell in enumerate(row.cells[-numbers:]):
            mark = "." if "." in cell else "," if "," in cell else ""
            first = first or mark
            if mark and mark != first:
                raise FormatError(
                    path,
                    f"{cell!r} has the decimal mark {mark!r}, the numbers before it have {first!r};"
                    " use one of them throughout",
                    line=row.line,
                    column=place + 2,
                )


def _cells(line: str) -> tuple[list[str], bool]:
    """The columns of a line, and whether its separators tell where the name ends."""
    for mark in ("\t", ";"):
        if mark in line:
            cells = [cell.strip() for cell in line.rstrip().rstrip(mark).split(mark)]
            # Runs of tabs, or blanks between numbers: the separators were not meant strictly.
            strict = all(cells) or mark == ";"
            columns = "|".join(cells[1:])
            if strict and len(columns.split()) < 2 and ";" not in columns:
                return cells, True
    text = line.strip()
    return (_SEPARATOR.split(text) if ";" in text else text.split()), False
