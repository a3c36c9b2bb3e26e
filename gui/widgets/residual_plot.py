"""Residuals by position: bars that should stay inside the band of their uncertainty."""

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPen
from PySide6.QtWidgets import QToolTip, QWidget

from gui.languages.shown import shown, shown_number
from gui.widgets.chart_scale import nice_step, tick_text, ticks
from gui.widgets.number_text import significant
from gui.widgets.painted_view import PaintedView
from gui.widgets.states import ResidualSeries, ResidualState, Tone
from gui.widgets.theme import current_theme


class ResidualPlot(PaintedView):
    """Bars of every sensor at every position; a bar out of its band is marked by a sign."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((40, 14), (16, 8), parent)
        self._state = ResidualState((), ())
        self._places: list[tuple[QRectF, str]] = []

    def render(self, state: ResidualState) -> None:
        """Show residuals."""
        self._state = state
        outside = [
            f"{series.name} {label} {significant(value, 3)}"
            for series in state.series
            for number, (label, value) in enumerate(
                zip(state.positions, series.values, strict=True)
            )
            if _outside(series, number)
        ]
        self.setAccessibleName(self.tr("Residuals by position"))
        self.setAccessibleDescription(", ".join(outside))
        self.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        theme = current_theme()
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        unit = metrics.height()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.window))
        left = 10 * metrics.horizontalAdvance("0") + 6
        plot = QRectF(left, 2.2 * unit, size.width() - left - unit, size.height() - 4.0 * unit)
        painter.fillRect(plot, QColor(theme.base))
        reach = self._reach()
        scale = plot.height() / (2.0 * reach)
        self._ground(painter, plot, reach, scale)
        self._legend(painter, QRectF(plot.left(), 0, plot.width(), 2 * unit))
        self._places = []
        each = plot.width() / max(1, len(self._state.positions))
        for number, label in enumerate(self._state.positions):
            group = QRectF(plot.left() + number * each, plot.top(), each, plot.height())
            painter.setPen(QColor(theme.muted))
            painter.drawText(
                QRectF(group.left() - each, plot.bottom() + 3, 3 * each, unit),
                Qt.AlignmentFlag.AlignCenter,
                shown(label),
            )
            self._group(painter, group, number, scale)
        painter.setPen(QColor(theme.muted))
        painter.drawLine(
            QPointF(plot.left(), plot.center().y()), QPointF(plot.right(), plot.center().y())
        )

    def _reach(self) -> float:
        """Half of the range of values, the same up and down."""
        sizes = [
            abs(value)
            for series in self._state.series
            for value in (*series.values, *series.u95)
            if math.isfinite(value)
        ]
        return 1.12 * max(sizes, default=0.0) or 1.0

    def _ground(self, painter: QPainter, plot: QRectF, reach: float, scale: float) -> None:
        theme = current_theme()
        unit = painter.fontMetrics().height()
        step = nice_step(2 * reach, max(2, int(plot.height() / (2 * unit))))
        for value in ticks(-reach, reach, step):
            y = plot.center().y() - value * scale
            painter.setPen(QColor(theme.grid))
            painter.drawLine(QPointF(plot.left(), round(y)), QPointF(plot.right(), round(y)))
            painter.setPen(QColor(theme.muted))
            painter.drawText(
                QRectF(0, y - unit, plot.left() - 5, 2 * unit),
                Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                shown_number(tick_text(value, step)),
            )
        painter.setPen(QColor(theme.line))
        painter.drawRect(plot)

    def _legend(self, painter: QPainter, place: QRectF) -> None:
        theme = current_theme()
        metrics = painter.fontMetrics()
        unit = metrics.height()
        x = place.left()
        middle = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        for number, series in enumerate(self._state.series):
            painter.fillRect(
                QRectF(x, place.center().y() - 0.35 * unit, 0.7 * unit, 0.7 * unit),
                QColor(theme.curves[number % len(theme.curves)]),
            )
            x += unit
            painter.setPen(QColor(theme.text))
            painter.drawText(
                QRectF(x, place.top(), place.width(), place.height()), middle, series.name
            )
            x += metrics.horizontalAdvance(series.name) + 1.2 * unit
        painter.setPen(QColor(theme.muted))
        note = self.tr("residual, {unit}; band: ±U (95 %)").format(unit=shown(self._state.unit))
        painter.drawText(place, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, note)

    def _group(self, painter: QPainter, group: QRectF, number: int, scale: float) -> None:
        theme = current_theme()
        count = max(1, len(self._state.series))
        width = min(0.7 * group.width() / count, 3.0 * painter.fontMetrics().height())
        left = group.center().x() - 0.5 * width * count
        zero = group.center().y()
        for place, series in enumerate(self._state.series):
            value = series.values[number]
            bar = QRectF(left + place * width, group.top(), width, group.height())
            self._places.append((bar, self._words(series, number)))
            if series.u95 and math.isfinite(series.u95[number]):
                self._band(painter, bar, zero, series.u95[number] * scale)
            if not math.isfinite(value):
                continue
            shade = QColor(theme.curves[place % len(theme.curves)])
            solid = QRectF(bar.left() + 0.2 * width, zero, 0.6 * width, -value * scale).normalized()
            painter.fillRect(solid, shade)
            if _outside(series, number):
                painter.setPen(QColor(theme.tones[Tone.BAD]))
                unit = painter.fontMetrics().height()
                at = solid.top() - unit if value > 0 else solid.bottom()
                painter.drawText(
                    QRectF(bar.left() - unit, at, width + 2 * unit, unit),
                    Qt.AlignmentFlag.AlignCenter,
                    "▲" if value > 0 else "▼",
                )

    def _band(self, painter: QPainter, bar: QRectF, zero: float, half: float) -> None:
        """The band in which 95 % of the residuals should lie."""
        theme = current_theme()
        band = QRectF(bar.left() + 0.08 * bar.width(), zero - half, 0.84 * bar.width(), 2 * half)
        painter.fillRect(band, QColor(theme.grid))
        painter.setPen(QPen(QColor(theme.muted), 1))
        painter.drawLine(band.topLeft(), band.topRight())
        painter.drawLine(band.bottomLeft(), band.bottomRight())

    def _words(self, series: ResidualSeries, number: int) -> str:
        text = f"{self._state.positions[number]}, {series.name}: "
        text += f"{significant(series.values[number], 4)} {self._state.unit}"
        if series.u95:
            text += f" (±{significant(series.u95[number], 2)})"
        return text

    def words_at(self, at: QPointF) -> str:
        """Return position, sensor and value of the bar at a point; empty beside the bars."""
        return next((words for bar, words in self._places if bar.contains(at)), "")

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), self.words_at(QPointF(event.pos())), self)
            return True
        return super().event(event)


def _outside(series: ResidualSeries, number: int) -> bool:
    return bool(series.u95) and abs(series.values[number]) > series.u95[number]
