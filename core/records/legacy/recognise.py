"""Which layout a file has: by the number of its columns and by their content, never by asking.

A layout is taken when every row can be one of its rows. If several are possible, which happens
in files of a row or two, the beginning of the file's name decides; if it does not either, or if
it speaks against the only possible layout, the file is refused. Where no layout takes every row,
the one that takes most of them names the fault.
"""

import math
from collections import Counter
from pathlib import PurePath

import numpy as np

from core.errors import FormatError
from core.records.legacy.layout import LEGACY_FORMATS, LegacyLayout
from core.records.legacy.rows import TextRow, number_of, why_no_number


def recognise(path: str, rows: list[TextRow]) -> LegacyLayout:
    """Return the layout of the rows.

    Raises
    ------
    FormatError
        No layout takes all rows, or more than one does.
    """
    takes = {layout.id: _taken(layout, rows) for layout in LEGACY_FORMATS.values()}
    whole = [layout for layout in LEGACY_FORMATS.values() if all(takes[layout.id])]
    named = [layout for layout in whole if PurePath(path).name.startswith(layout.stem + "_")]
    if len(named) == 1:
        return named[0]
    if len(whole) == 1:
        return _unless_named_otherwise(path, whole[0])
    if whole:
        readings = " and ".join(
            f"{layout.title} with the name {rows[0].name(len(layout.columns))!r}"
            for layout in (named or whole)
        )
        raise FormatError(
            path,
            f"the rows fit {readings}; keep the beginning of the file's name"
            " (OpticalDividingHead_, RotationTable_, Accuracy_) or part the columns by tabs",
            line=rows[0].line,
        )
    raise _refusal(path, rows, takes)


def _unless_named_otherwise(path: str, layout: LegacyLayout) -> LegacyLayout:
    """A table that lost a column everywhere can pass for another one; its name then tells."""
    name = PurePath(path).name
    for other in LEGACY_FORMATS.values():
        if name.startswith(other.stem + "_") and other.stem != layout.stem:
            raise FormatError(
                path,
                f"the columns are those of {layout.title}, the name is that of {other.title}: a"
                " damaged file, or a wrong name",
            )
    return layout


def _taken(layout: LegacyLayout, rows: list[TextRow]) -> list[bool]:
    numbers = len(layout.columns)
    fitting = [i for i, row in enumerate(rows) if row.fits(numbers)]
    taken = [False] * len(rows)
    if fitting:
        values = np.array([rows[i].tail[-numbers:] for i in fitting])
        for i, valid in zip(fitting, layout.valid(values), strict=True):
            taken[i] = bool(valid)
    return taken


def _refusal(path: str, rows: list[TextRow], takes: dict[str, list[bool]]) -> FormatError:
    name = PurePath(path).name
    family = [x for x in LEGACY_FORMATS.values() if name.startswith(x.stem + "_")]
    family = family or list(LEGACY_FORMATS.values())
    best = max(family, key=lambda layout: sum(takes[layout.id]))
    if 2 * sum(takes[best.id]) >= len(rows):
        place = takes[best.id].index(False)
        other = next((k for k in takes if takes[k][place]), None)
        if other is None:
            return _fault(path, rows[place], best)
        return FormatError(
            path,
            f"a row of another layout, {LEGACY_FORMATS[other].title}, among rows of"
            f" {best.title}; a file holds one layout",
            line=rows[place].line,
        )
    width = Counter(len(row.cells) for row in rows).most_common(1)[0][0]
    row = next(row for row in rows if len(row.cells) == width)
    near = min(family, key=lambda layout: _distance(layout, row))
    if _distance(near, row) < (2, 0):
        return _fault(path, row, near)
    known = sorted({layout.width for layout in LEGACY_FORMATS.values()})
    hint = "; this looks like columns parted by commas" if row.cells[0].count(",") > 3 else ""
    return FormatError(
        path,
        f"no table of means: {width} columns, the known layouts have"
        f" {', '.join(map(str, known))}{hint}",
        line=row.line,
    )


def _distance(layout: LegacyLayout, row: TextRow) -> tuple[int, int]:
    """How far a row that no layout takes is from one: columns first, then doubtful numbers."""
    numbers = len(layout.columns)
    wrong_width = abs(len(row.cells) - layout.width)
    if wrong_width or not row.fits(numbers):
        return wrong_width, numbers
    doubts = sum(
        bool(column.doubt(value))
        for column, value in zip(layout.columns, row.tail[-numbers:], strict=True)
    )
    return 0, doubts


def _fault(path: str, row: TextRow, layout: LegacyLayout) -> FormatError:
    """What keeps a row out of a layout."""
    numbers = len(layout.columns)
    if row.fits(numbers):
        column, why = layout.first_doubt(np.array(row.tail[-numbers:]))
        return FormatError(path, f"{why} in {layout.title}", line=row.line, column=column)
    missing = layout.width - len(row.cells)
    if missing > 0:
        name = " (the device's name may be the missing one)" if missing == 1 else ""
        return FormatError(
            path,
            f"{len(row.cells)} columns, {layout.title} has {layout.width}{name}",
            line=row.line,
        )
    for place, cell in enumerate(row.cells[-numbers:]):
        if math.isnan(number_of(cell)):
            return FormatError(path, why_no_number(cell), line=row.line, column=place + 2)
    return FormatError(
        path, f"{len(row.cells)} columns, {layout.title} has {layout.width}", line=row.line
    )
