"""Parts of a results page as HTML that a browser and Qt's text engine show alike."""

import base64
import math
import re
from collections.abc import Mapping
from html import escape

from PySide6.QtCore import QBuffer, QByteArray, QCoreApplication, QIODevice, QSize, Qt
from PySide6.QtGui import QImage, QImageWriter, QPainter

from core.errors import Note, Severity
from gui.certificate.log_plot_view import LogPlot
from gui.languages.shown import shown, shown_number
from gui.measuring.page import CurveState, LogCurveState, Part
from gui.widgets.number_text import MINUS, aligned, value_and_uncertainty
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.states import MatrixState, ResidualState, TableState
from gui.widgets.theme import paper_look

_SYMBOL = re.compile(r"\b([A-Za-zα-ωΑ-Ω])(?:_([a-z0-9]{1,3})|(0))\b")
_COLUMNS = 10
"""So many stand beside each other on a sheet."""
_PICTURE = QSize(660, 260)
_SHARP = 3
"""Dots of a picture to one of the screen: 288 dpi on paper."""


def part_html(part: Part) -> tuple[str, ...]:
    """One part of a page in pieces; a table that is too wide for paper goes on below itself."""
    if isinstance(part, TableState):
        return tuple(map(table_html, _narrow(part)))
    if isinstance(part, ResidualState):
        return (residual_html(part),)
    if isinstance(part, Note):
        return (note_html(part),)
    if isinstance(part, CurveState):
        return tuple(map(table_html, _narrow(_table_of(part))))
    if isinstance(part, LogCurveState):
        return (f"<h3>{escape(shown(part.title))}</h3>{_picture(LogPlot(part))}",)
    cells = "".join(f'<td valign="middle">{matrix_html(matrix)}</td>' for matrix in part)
    return (f'<table cellspacing="0" cellpadding="0"><tr>{cells}</tr></table>',)


def table_html(table: TableState) -> str:
    """A table with its title and equation above; the points of its numbers stand in one column."""
    head = "".join(
        f'<th align="{"left" if column < table.words else "right"}">{escape(shown(name))}</th>'
        for column, name in enumerate(table.header)
    )
    columns = [
        list(texts) if place < table.words else aligned(texts)
        for place, texts in enumerate(zip(*table.rows, strict=True))
    ]
    rows = "".join(
        "<tr>"
        + "".join(
            f"<td>{symbols(escape(shown(text)))}</td>"
            if place < table.words
            else f'<td align="right" style="white-space: pre">{escape(shown_number(text))}</td>'
            for place, text in enumerate(row)
        )
        + "</tr>"
        for row in zip(*columns, strict=True)
    )
    title = f"<h3>{escape(shown(table.title))}</h3>" if table.title else ""
    equation = f"<p><i>{symbols(escape(shown(table.equation)))}</i></p>" if table.equation else ""
    return (
        f'{title}{equation}<table class="grid" border="1" cellspacing="0" cellpadding="3"'
        f' width="100%"><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>'
    )


def _narrow(table: TableState) -> tuple[TableState, ...]:
    """The table in as many as its columns need, the leading columns repeated in each."""
    lead = max(1, table.words)
    numbers = len(table.header) - lead
    most = max(1, _COLUMNS - lead)
    if numbers <= most:
        return (table,)
    pieces: list[TableState] = []
    count = -(-numbers // most)
    for piece in range(count):
        chosen = [
            *range(lead),
            *range(lead + numbers * piece // count, lead + numbers * (piece + 1) // count),
        ]
        title = table.title
        if piece:
            words = QCoreApplication.translate("Certificate", "{title}, further columns")
            title = words.format(title=shown(table.title))
        pieces.append(
            TableState(
                title,
                "" if piece else table.equation,
                tuple(table.header[place] for place in chosen),
                tuple(tuple(row[place] for place in chosen) for row in table.rows),
                table.words,
            )
        )
    return tuple(pieces)


def matrix_html(matrix: MatrixState) -> str:
    """A matrix with its equation beside it; uncertainties small below the values."""
    names = ""
    if matrix.columns:
        names = (
            "<tr>" + "".join(f"<th>{escape(shown(name))}</th>" for name in matrix.columns) + "</tr>"
        )
    rows = "".join(
        "<tr>"
        + "".join(
            f'<td align="right" style="white-space: nowrap">{escape(shown_number(value))}'
            + (f"<br/><small>± {escape(shown_number(half))}</small>" if half else "")
            + "</td>"
            for value, half in row
        )
        + "</tr>"
        for row in matrix.cells
    )
    equation = "<br/>".join(symbols(escape(line)) for line in matrix.equation.split("\n"))
    return (
        '<table cellspacing="0" cellpadding="6"><tr>'
        '<td valign="middle" style="white-space: nowrap">'
        f"<b>{symbols(escape(matrix.symbol))}</b></td>"
        '<td><table border="1" cellspacing="0" cellpadding="5">'
        f"{names}{rows}</table></td>"
        f'<td valign="middle" style="white-space: nowrap">{escape(matrix.unit)}</td>'
        f'<td valign="middle"><i>{equation}</i></td></tr></table>'
    )


def residual_html(state: ResidualState) -> str:
    """The residuals as a picture with its words."""
    plot = ResidualPlot()
    plot.render(state)
    title = QCoreApplication.translate("Certificate", "Residuals by position")
    return f"<h3>{escape(title)}</h3>{_picture(plot)}"


def _table_of(state: CurveState) -> TableState:
    """The points of a curve as a table: paper is read by digits."""
    places = sorted({x for _, xs, *_ in state.series for x in xs})
    header, columns = [state.x_label], [[plain(x) for x in places]]
    for name, xs, ys, u95 in state.series:
        halves = u95 or (math.nan,) * len(xs)
        known = dict(zip(xs, zip(ys, halves, strict=True), strict=True))
        header.append(name)
        columns.append([_point(known, x)[0] for x in places])
        if u95:
            header.append("±U")
            columns.append([_point(known, x)[1] for x in places])
    rows = tuple(zip(*columns, strict=True))
    return TableState(f"{state.title}, {state.y_label}", "", tuple(header), rows, 0)


def _point(known: Mapping[float, tuple[float, float]], x: float) -> tuple[str, str]:
    """Value and uncertainty of a curve at a place; empty where it has no point."""
    if x not in known:
        return "", ""
    value, half = known[x]
    return (
        value_and_uncertainty(value, half) if half > 0 else (f"{value:.4g}".replace("-", MINUS), "")
    )


def plain(value: float) -> str:
    """A number that was set, without digits that nobody stated."""
    return f"{value:.10g}".replace("-", MINUS)


def note_html(note: Note) -> str:
    """A doubt."""
    words = {
        Severity.INFO: QCoreApplication.translate("Certificate", "Remark"),
        Severity.WARNING: QCoreApplication.translate("Certificate", "Warning"),
        Severity.ERROR: QCoreApplication.translate("Certificate", "Error"),
    }
    return f"<p><b>{escape(words[note.severity])}:</b> {escape(shown(note.text))}</p>"


def symbols(text: str) -> str:
    """Write the indices of symbols, ``k_zx`` or ``U0``, below the line."""
    return _SYMBOL.sub(r"\1<sub>\2\3</sub>", text)


def _picture(plot: ResidualPlot | LogPlot) -> str:
    image = QImage(_PICTURE * _SHARP, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(_SHARP)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    try:
        with paper_look():
            plot.paint(painter, _PICTURE)
    finally:
        painter.end()
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    data = base64.b64encode(buffer.data().data()).decode("ascii")
    alt = escape(plot.accessibleName(), quote=True)
    return (
        f'<p><img alt="{alt}" width="{_PICTURE.width()}" height="{_PICTURE.height()}"'
        f' src="data:image/png;base64,{data}"/></p>'
    )
