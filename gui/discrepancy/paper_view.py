"""Ladder and plots as pictures on paper, white whatever the screen wears."""

import base64
import os
import sys
from collections.abc import Callable
from html import escape

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QImage, QImageWriter, QPainter
from PySide6.QtWidgets import QApplication

from gui.discrepancy.cause_view import paint_cause
from gui.discrepancy.ladder_view import GapBar, largest_of
from gui.discrepancy.plots_view import RowsPlot
from gui.discrepancy.state import PictureState, RungState
from gui.languages.shown import shown
from gui.widgets.theme import FAMILY, current_theme, load_fonts, paper_look

_SHARP = 3
"""Dots of a picture to one of the screen: 288 dpi on paper."""
_LINE = 15.0


def an_application() -> QApplication:
    """The application that pictures need: that of the window, or one without a screen.

    It must be kept as long as anything is drawn.
    """
    there = QApplication.instance()
    if isinstance(there, QApplication):
        return there
    screens = (os.environ.get("DISPLAY"), os.environ.get("WAYLAND_DISPLAY"))
    if sys.platform.startswith("linux") and not any(screens):
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    made = QApplication(["calrig"])
    load_fonts()
    return made


def ladder_picture(rungs: tuple[RungState, ...]) -> str:
    """All bars of the ladder, as HTML."""
    row = 2.9 * _LINE
    size = QSize(660, round(row * len(rungs)))

    def paint(painter: QPainter) -> None:
        largest = largest_of(rungs)
        for place, rung in enumerate(rungs):
            painter.setPen(QColor(current_theme().text))
            plus, _, name = rung.title.rpartition("+ ")
            title = shown(name) if rung.title == name else f"{plus}+ {shown(name)}"
            painter.drawText(QPointF(0, place * row + _LINE), title)
            painter.save()
            painter.translate(0, place * row + 1.3 * _LINE)
            GapBar(rung, largest).paint(painter, QSize(660, round(1.4 * _LINE)))
            painter.restore()

    return _image(size, paint, "")


def plot_picture(picture: PictureState) -> str:
    """The residual against its regressor with the band, as HTML."""
    size = QSize(660, 300)

    def paint(painter: QPainter) -> None:
        plot = RowsPlot()
        plot.resize(size)
        plot.draw_residual(picture)
        # A plot that was never seen has no layout yet.
        plot.grab()
        plot.grab()
        plot.paint(painter, size)
        plot.close()

    return _image(size, paint, picture.title)


def cause_picture(effect: str, name: str) -> str:
    """The picture of an effect, as HTML."""
    size = QSize(78, 60)
    return _image(size, lambda painter: paint_cause(painter, QRectF(0, 0, 78, 60), effect), name)


def _image(size: QSize, paint: Callable[[QPainter], None], name: str) -> str:
    image = QImage(size * _SHARP, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(_SHARP)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    font = QFont(FAMILY)
    font.setPixelSize(12)
    painter.setFont(font)
    try:
        with paper_look():
            paint(painter)
    finally:
        painter.end()
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    data = base64.b64encode(buffer.data().data()).decode("ascii")
    return (
        f'<img alt="{escape(name, quote=True)}" width="{size.width()}" height="{size.height()}"'
        f' src="data:image/png;base64,{data}"/>'
    )
