"""A plot of one quantity over another, in the colours of the look, for the analysis tabs.

On a logarithmic axis every item is given logarithms here, because bands, points and error bars of
pyqtgraph do not follow its own log mode.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from core.arrays import FloatArray
from gui.languages.shown import shown
from gui.widgets.colours import Theme, blend
from gui.widgets.fast_axis import FastAxis
from gui.widgets.theme import current_theme

_NO_LINE = Qt.PenStyle.NoPen
_BAND_SHARE = 0.25
_FINE = 5000
"""Up to so many points a curve is drawn smooth; wide smooth lines of more take seconds."""


class Plot(pg.PlotWidget):
    """Curves, points with error bars, and bands; Home, or a double click, shows everything.

    Parameters
    ----------
    x_label, y_label : with units
    log_x, log_y : whether an axis is logarithmic; what is not positive is left out there
    """

    def __init__(
        self,
        x_label: str = "",
        y_label: str = "",
        *,
        log_x: bool = False,
        log_y: bool = False,
        parent: QWidget | None = None,
    ) -> None:
        theme = current_theme()
        self._axes: dict[str, Any] = {s: FastAxis(s, theme) for s in ("left", "bottom")}
        # No context menu: its picture export fails, and its panels outlive the plot as windows.
        box = pg.ViewBox(enableMenu=False)
        super().__init__(
            parent, background=theme.base, axisItems=self._axes, viewBox=box, enableMenu=False
        )
        for axis in self._axes.values():
            # Beneath the box of the curves, whose own place is -100.
            axis.setZValue(-101)
        self._log = (log_x, log_y)
        self._items: list[_Item] = []
        self._legend: list[_Entry] = []
        self._plot: Any = self.getPlotItem()
        self._axes["bottom"].setLogMode(x=log_x)
        self._axes["left"].setLogMode(y=log_y)
        self._plot.hideButtons()
        self.set_labels(x_label, y_label)
        self._wear(theme)

    def set_labels(self, x_label: str, y_label: str) -> None:
        """Write what the axes hold."""
        colour = current_theme().muted
        self._labels = (x_label, y_label)
        self._plot.setLabel("bottom", shown(x_label), color=colour)
        self._plot.setLabel("left", shown(y_label), color=colour)
        self.setAccessibleName(f"{shown(y_label)} / {shown(x_label)}")

    def add_curve(
        self, x: FloatArray, y: FloatArray, colour: int, name: str = "", *, dashed: bool = False
    ) -> None:
        """Draw a line in the curve colour of that number."""
        x, y = self._placed(x, y)
        fine = x.size <= _FINE
        item = pg.PlotCurveItem(x, y, connect="finite", antialias=fine)
        style = Qt.PenStyle.DashLine if dashed else Qt.PenStyle.SolidLine
        width = 1.6 if fine else 1.0

        def wear(theme: Theme) -> None:
            item.setPen(pg.mkPen(_curve(theme, colour), style=style, width=width))

        self._add(item, wear)
        self._entitle(name, colour, style)

    def add_band(self, x: FloatArray, low: FloatArray, high: FloatArray, colour: int) -> None:
        """Fill between two lines in a light shade of a curve colour, opaque."""
        edges = [pg.PlotCurveItem(*self._placed(x, edge), pen=None) for edge in (low, high)]
        item = pg.FillBetweenItem(edges[0], edges[1])
        item.setZValue(-10)

        def wear(theme: Theme) -> None:
            item.setBrush(pg.mkBrush(blend(_curve(theme, colour), theme.base, _BAND_SHARE)))

        self._add(item, wear)

    def add_points(
        self,
        x: FloatArray,
        y: FloatArray,
        colour: int,
        name: str = "",
        *,
        low: FloatArray | None = None,
        high: FloatArray | None = None,
    ) -> None:
        """Draw points, with bars from `low` to `high` where they are given."""
        px, py = self._placed(x, y)
        if low is not None and high is not None:
            bottom, top = (self._placed(x, edge)[1] for edge in (low, high))
            bars = pg.ErrorBarItem(x=px, y=py, bottom=py - bottom, top=top - py)
            self._add(bars, lambda theme: bars.setData(pen=pg.mkPen(_curve(theme, colour))))
        points = pg.ScatterPlotItem(px, py, size=6, pen=None)
        self._add(points, lambda theme: points.setBrush(pg.mkBrush(_curve(theme, colour))))
        self._entitle(name, colour, None)

    def add_text(self, x: float, y: float, text: str) -> None:
        """Write a note at a point."""
        item = pg.TextItem(shown(text), anchor=(0, 1))
        px, py = self._placed(np.array([x]), np.array([y]))
        item.setPos(float(px[0]), float(py[0]))
        self._add(item, lambda theme: item.setColor(theme.text))

    def clear_items(self) -> None:
        """Take everything out but the axes."""
        for kept in self._items:
            self._plot.removeItem(kept.item)
        self._items.clear()
        self._legend.clear()
        self.viewport().update()

    def show_everything(self) -> None:
        """Fit the ranges to what is drawn."""
        self._plot.enableAutoRange()

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw on any painter, for export."""
        whole = self.sceneRect()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(current_theme().base))
        target = QRectF(0, 0, size.width(), size.height())
        self.scene().render(painter, target, whole, Qt.AspectRatioMode.IgnoreAspectRatio)
        painter.scale(size.width() / whole.width(), size.height() / whole.height())
        self._paint_legend(painter)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Home:
            self.show_everything()
            return
        super().keyPressEvent(event)

    def mouseDoubleClickEvent(self, event: Any) -> None:
        super().mouseDoubleClickEvent(event)
        self.show_everything()

    def close(self) -> bool:
        # pyqtgraph's own fails when it is called twice.
        if self.getPlotItem() is not None:
            super().close()
        return True

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        # pyqtgraph empties a plot that is closed; Qt also asks before the plot has been built.
        built = getattr(self, "_legend", None) is not None and self.getPlotItem() is not None
        if built and event.type() == QEvent.Type.PaletteChange:
            self._wear(current_theme())
        elif built and event.type() == QEvent.Type.LanguageChange:
            self.set_labels(*self._labels)

    def _placed(self, x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Coordinates in the plane of the plot; NaN for what a logarithmic axis cannot show."""
        return _scaled(x, self._log[0]), _scaled(y, self._log[1])

    def _add(self, item: Any, wear: Callable[[Theme], None]) -> None:
        self._items.append(_Item(item, wear))
        wear(current_theme())
        self._plot.addItem(item)

    def _entitle(self, name: str, colour: int, line: Qt.PenStyle | None) -> None:
        if name:
            self._legend.append(_Entry(name, colour, line))

    def drawForeground(self, painter: QPainter, rect: QRectF | QRect) -> None:
        super().drawForeground(painter, rect)
        self._paint_legend(painter)

    def _paint_legend(self, painter: QPainter) -> None:
        """Names of the curves in the upper right corner."""
        theme = current_theme()
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        unit = metrics.height()
        area = self._plot.getViewBox().sceneBoundingRect()
        longest = max((metrics.horizontalAdvance(shown(e.name)) for e in self._legend), default=0)
        left = area.right() - longest - 3.2 * unit
        for row, entry in enumerate(self._legend):
            y = area.top() + (1.0 + 1.25 * row) * unit
            painter.setPen(QPen(QColor(_curve(theme, entry.colour)), 2, entry.line or _NO_LINE))
            painter.drawLine(QPointF(left, y), QPointF(left + 1.8 * unit, y))
            if entry.line is None:
                painter.setBrush(QColor(_curve(theme, entry.colour)))
                painter.drawEllipse(QPointF(left + 0.9 * unit, y), 3, 3)
            painter.setPen(QColor(theme.text))
            painter.drawText(
                QRectF(left + 2.2 * unit, y - unit, longest + unit, 2 * unit),
                Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
                shown(entry.name),
            )

    def _wear(self, theme: Theme) -> None:
        self.setBackground(theme.base)
        for axis in self._axes.values():
            axis.wear(theme)
        for kept in self._items:
            kept.wear(theme)
        self.set_labels(*self._labels)


@dataclass(frozen=True, slots=True)
class _Entry:
    """A line of the legend; `line` is None for points."""

    name: str
    colour: int
    line: Qt.PenStyle | None


@dataclass(frozen=True, slots=True)
class _Item:
    item: Any
    wear: Callable[[Theme], None]


def _curve(theme: Theme, number: int) -> str:
    return theme.curves[number % len(theme.curves)]


def _scaled(values: FloatArray, logarithmic: bool) -> FloatArray:
    if not logarithmic:
        return values
    positive = np.where(values > 0.0, values, np.nan)
    return np.log10(positive)
