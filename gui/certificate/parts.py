"""Parts of a results page as HTML that a browser and Qt's text engine show alike."""

import base64
import re
from html import escape

from PySide6.QtCore import QBuffer, QByteArray, QCoreApplication, QIODevice, QSize, Qt
from PySide6.QtGui import QImage, QImageWriter, QPainter

from core.errors import Note, Severity
from gui.measuring.page import CurveState, Part
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.states import MatrixState, ResidualState, TableState
from gui.widgets.theme import paper_look

_SYMBOL = re.compile(r"\b([A-Za-zα-ωΑ-Ω])(?:_([a-z0-9]{1,3})|(0))\b")
_PICTURE = QSize(660, 260)
_SHARP = 3
"""Dots of a picture to one of the screen: 288 dpi on paper."""


def part_html(part: Part) -> str:
    """One part of a page; plots of curves stand in the window alone."""
    if isinstance(part, TableState):
        return table_html(part)
    if isinstance(part, ResidualState):
        return residual_html(part)
    if isinstance(part, Note):
        return note_html(part)
    if isinstance(part, CurveState):
        return curve_html(part)
    cells = "".join(f'<td valign="middle">{matrix_html(matrix)}</td>' for matrix in part)
    return f'<table cellspacing="0" cellpadding="0"><tr>{cells}</tr></table>'


def table_html(table: TableState) -> str:
    """A table with its title and equation above; numbers flush right."""
    head = "".join(
        f'<th align="{"left" if column < table.words else "right"}">{escape(name)}</th>'
        for column, name in enumerate(table.header)
    )
    rows = "".join(
        "<tr>"
        + "".join(
            f"<td>{symbols(escape(text))}</td>"
            if column < table.words
            else f'<td align="right">{escape(text)}</td>'
            for column, text in enumerate(row)
        )
        + "</tr>"
        for row in table.rows
    )
    equation = f"<p><i>{symbols(escape(table.equation))}</i></p>" if table.equation else ""
    return (
        f"<h3>{escape(table.title)}</h3>{equation}"
        f'<table class="grid" border="1" cellspacing="0" cellpadding="4" width="100%">'
        f"<tr>{head}</tr>{rows}</table>"
    )


def matrix_html(matrix: MatrixState) -> str:
    """A matrix with its equation beside it; uncertainties small below the values."""
    names = ""
    if matrix.columns:
        names = "<tr>" + "".join(f"<th>{escape(name)}</th>" for name in matrix.columns) + "</tr>"
    rows = "".join(
        "<tr>"
        + "".join(
            f'<td align="right" style="white-space: nowrap">{escape(value)}'
            + (f"<br/><small>± {escape(half)}</small>" if half else "")
            + "</td>"
            for value, half in row
        )
        + "</tr>"
        for row in matrix.cells
    )
    equation = "<br/>".join(symbols(escape(line)) for line in matrix.equation.split("\n"))
    return (
        '<table cellspacing="0" cellpadding="6"><tr>'
        f'<td valign="middle"><b>{symbols(escape(matrix.symbol))}</b></td>'
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


def curve_html(state: CurveState) -> str:
    """The points of a curve as a table: paper is read by digits."""
    header = (state.x_label, *(name for name, *_ in state.series))
    places = sorted({x for _, xs, *_ in state.series for x in xs})
    values = [dict(zip(xs, ys, strict=True)) for _, xs, ys, _ in state.series]
    rows = tuple(
        (f"{x:.6g}", *(f"{found[x]:.6g}" if x in found else "" for found in values)) for x in places
    )
    return table_html(TableState(f"{state.title}, {state.y_label}", "", header, rows, 0))


def note_html(note: Note) -> str:
    """A doubt."""
    words = {
        Severity.INFO: QCoreApplication.translate("Certificate", "Remark"),
        Severity.WARNING: QCoreApplication.translate("Certificate", "Warning"),
        Severity.ERROR: QCoreApplication.translate("Certificate", "Error"),
    }
    return f"<p><b>{escape(words[note.severity])}:</b> {escape(note.text)}</p>"


def symbols(text: str) -> str:
    """Write the indices of symbols, ``k_zx`` or ``U0``, below the line."""
    return _SYMBOL.sub(r"\1<sub>\2\3</sub>", text)


def _picture(plot: ResidualPlot) -> str:
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
