"""Parts of a results page as JSON and back: a certificate keeps what was printed on it."""

from collections.abc import Iterable

from core.certificates.measured import Printed
from core.errors import Note, Severity
from core.records.json_fields import Fields, Json, numbers_to_json
from gui.measuring.page import CurveState, LogCurveState, Part
from gui.widgets.states import MatrixState, ResidualSeries, ResidualState, TableState

_OF_LOG = ("x", "y", "low", "high")
"""Points of a curve with logarithmic axes."""


def printed_of(parts: Iterable[Part]) -> tuple[Printed, ...]:
    """The parts as JSON objects."""
    return tuple(map(_printed, parts))


def parts_of(printed: Iterable[Printed], path: str = "") -> tuple[Part, ...]:
    """The parts of JSON objects; `path` stands in messages.

    Raises
    ------
    FormatError
        A part is of no known kind, or a member is missing.
    """
    return tuple(
        _part(Fields(path, f"printed[{place}]", dict(one))) for place, one in enumerate(printed)
    )


def _printed(part: Part) -> dict[str, Json]:
    if isinstance(part, TableState):
        return {
            "kind": "table",
            "title": part.title,
            "equation": part.equation,
            "header": list(part.header),
            "rows": [list(row) for row in part.rows],
            "words": part.words,
        }
    if isinstance(part, ResidualState):
        return {
            "kind": "residuals",
            "positions": list(part.positions),
            "series": [
                {
                    "name": one.name,
                    "values": numbers_to_json(one.values),
                    "u95": numbers_to_json(one.u95),
                }
                for one in part.series
            ],
            "unit": part.unit,
        }
    if isinstance(part, CurveState):
        return {
            "kind": "curve",
            "title": part.title,
            "x_label": part.x_label,
            "y_label": part.y_label,
            "series": [
                {
                    "name": name,
                    "x": numbers_to_json(x),
                    "y": numbers_to_json(y),
                    "u95": numbers_to_json(u95),
                }
                for name, x, y, u95 in part.series
            ],
            "joined": part.joined,
        }
    if isinstance(part, LogCurveState):
        return {
            "kind": "log_curve",
            "title": part.title,
            "x_label": part.x_label,
            "y_label": part.y_label,
            **{name: numbers_to_json(getattr(part, name)) for name in _OF_LOG},
            "lines": [
                {"name": name, "x": numbers_to_json(x), "y": numbers_to_json(y)}
                for name, x, y in part.lines
            ],
        }
    if isinstance(part, Note):
        return {
            "kind": "note",
            "severity": part.severity.value,
            "subject": part.subject,
            "text": part.text,
        }
    return {
        "kind": "matrices",
        "matrices": [
            {
                "symbol": one.symbol,
                "cells": [[list(cell) for cell in row] for row in one.cells],
                "unit": one.unit,
                "equation": one.equation,
                "columns": list(one.columns),
            }
            for one in part
        ],
    }


def _part(found: Fields) -> Part:
    kind = found.text("kind")
    if kind not in _PARTS:
        raise found.wrong("kind", " or ".join(_PARTS), kind)
    return _PARTS[kind](found)


def _table(found: Fields) -> TableState:
    return TableState(
        found.text("title"),
        found.text("equation"),
        found.texts("header"),
        tuple(_row(found, row) for row in found.items("rows")),
        found.integer("words"),
    )


def _row(found: Fields, row: Json) -> tuple[str, ...]:
    return Fields(found.path, found.where, {"rows": row}).texts("rows")


def _residuals(found: Fields) -> ResidualState:
    return ResidualState(
        found.texts("positions"),
        tuple(
            ResidualSeries(
                one.text("name"),
                tuple(one.numbers("values").tolist()),
                tuple(one.numbers("u95").tolist()),
            )
            for one in found.objects("series")
        ),
        found.text("unit"),
    )


def _curve(found: Fields) -> CurveState:
    return CurveState(
        found.text("title"),
        found.text("x_label"),
        found.text("y_label"),
        tuple(
            (
                one.text("name"),
                tuple(one.numbers("x").tolist()),
                tuple(one.numbers("y").tolist()),
                tuple(one.numbers("u95").tolist()),
            )
            for one in found.objects("series")
        ),
        found.flag("joined"),
    )


def _log_curve(found: Fields) -> LogCurveState:
    count = len(found.items("x"))
    x, y, low, high = (tuple(found.numbers(name, count).tolist()) for name in _OF_LOG)
    return LogCurveState(
        found.text("title"),
        found.text("x_label"),
        found.text("y_label"),
        x,
        y,
        low,
        high,
        tuple(
            (one.text("name"), tuple(one.numbers("x").tolist()), tuple(one.numbers("y").tolist()))
            for one in found.objects("lines")
        ),
    )


def _note(found: Fields) -> Note:
    word = found.text("severity")
    if word not in {severity.value for severity in Severity}:
        raise found.wrong("severity", "info, warning or error", word)
    return Note(Severity(word), found.text("subject"), found.text("text"))


def _matrices(found: Fields) -> tuple[MatrixState, ...]:
    return tuple(
        MatrixState(
            one.text("symbol"),
            tuple(_cells(one, row) for row in one.items("cells")),
            one.text("unit"),
            one.text("equation"),
            one.texts("columns"),
        )
        for one in found.objects("matrices")
    )


def _cells(found: Fields, row: Json) -> tuple[tuple[str, str], ...]:
    cells: list[tuple[str, str]] = []
    for cell in Fields(found.path, found.where, {"cells": row}).items("cells"):
        texts = _row(found, cell)
        if len(texts) != 2:
            raise found.wrong("cells", "pairs of value and uncertainty", cell)
        cells.append((texts[0], texts[1]))
    return tuple(cells)


_PARTS = {
    "table": _table,
    "residuals": _residuals,
    "curve": _curve,
    "log_curve": _log_curve,
    "note": _note,
    "matrices": _matrices,
}
"""How each kind of part is read."""
