"""The graph of an accuracy check: points with their intervals over the set angle, and limits."""

import math
from itertools import pairwise

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QToolTip, QWidget

from gui.accuracy.state import GraphState, Series
from gui.languages.shown import shown, shown_number
from gui.widgets.chart_scale import nice_step, tick_text, ticks
from gui.widgets.number_text import significant
from gui.widgets.painted_view import PaintedView
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme

_ANGLE_STEPS = (5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0)
_LIMIT_FAR = 6.0
"""A limit this many times beyond the data is told instead of drawn: it would flatten them."""
_NEAR_PX = 10.0


class ErrorGraph(PaintedView):
    """Shows a `GraphState`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__((40, 18), (20, 9), parent)
        self._state = GraphState()
        self._points: list[tuple[QPointF, str]] = []

    def render(self, state: GraphState) -> None:
        """Show a page."""
        if state == self._state:
            return
        self._state = state
        self.setAccessibleName(state.title)
        self.setAccessibleDescription(", ".join(series.name for series in state.series))
        self.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        theme = current_theme()
        painter.setFont(self.font())
        unit = painter.fontMetrics().height()
        painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(theme.window))
        left = 9 * painter.fontMetrics().horizontalAdvance("0") + 6
        plot = QRectF(left, 2.0 * unit, size.width() - left - unit, size.height() - 4.6 * unit)
        painter.fillRect(plot, QColor(theme.base))
        self._points = []
        if plot.height() < 2 * unit or not self._drawn:
            painter.setPen(QColor(theme.muted))
            painter.drawText(plot, Qt.AlignmentFlag.AlignCenter, shown(self._state.hint))
            painter.drawRect(plot)
            return
        scale = _Scale(plot, self._state)
        self._ground(painter, scale)
        self._legend(painter, QRectF(plot.left(), 0, plot.width(), 1.9 * unit), scale)
        painter.save()
        painter.setClipRect(plot.adjusted(-unit, -1, unit, 1))
        self._limits(painter, scale)
        for series in self._state.series:
            self._trace(painter, scale, series)
        painter.restore()

    @property
    def _drawn(self) -> bool:
        values = (value for series in self._state.series for value in series.y)
        return any(math.isfinite(value) for value in values)

    def _ground(self, painter: QPainter, scale: "_Scale") -> None:
        theme = current_theme()
        plot = scale.plot
        metrics = painter.fontMetrics()
        unit = metrics.height()
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        step = nice_step(scale.high - scale.low, max(2, int(plot.height() / (2 * unit))))
        for value in ticks(scale.low, scale.high, step):
            y = round(scale.y(value))
            painter.setPen(QColor(theme.muted if value == 0.0 else theme.grid))
            painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y))
            painter.setPen(QColor(theme.muted))
            label = QRectF(0, y - unit, plot.left() - 5, 2 * unit)
            painter.drawText(label, right, shown_number(tick_text(value, step)))
        most = max(2, int(plot.width() / (3.2 * metrics.horizontalAdvance("000"))))
        span = self._state.high - self._state.low
        across = next((s for s in _ANGLE_STEPS if span / s <= most), _ANGLE_STEPS[-1])
        for angle in ticks(self._state.low, self._state.high, across):
            x = round(scale.x(angle))
            painter.setPen(QColor(theme.grid))
            painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()))
            painter.setPen(QColor(theme.muted))
            label = QRectF(x - 3 * unit, plot.bottom() + 2, 6 * unit, unit)
            painter.drawText(label, Qt.AlignmentFlag.AlignCenter, tick_text(angle, across))
        painter.drawText(
            QRectF(plot.left(), plot.bottom() + 1.2 * unit, plot.width(), 1.2 * unit),
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
            self.tr("set angle, deg"),
        )
        painter.setPen(QColor(theme.line))
        painter.drawRect(plot)

    def _legend(self, painter: QPainter, place: QRectF, scale: "_Scale") -> None:
        theme = current_theme()
        metrics = painter.fontMetrics()
        unit = metrics.height()
        middle = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        x = place.left()
        for series in self._state.series:
            painter.setPen(QPen(_colour(series.colour), 1))
            painter.drawLine(QPointF(x, place.center().y()), QPointF(x + unit, place.center().y()))
            _symbol(painter, QPointF(x + unit / 2, place.center().y()), series.colour, unit)
            x += 1.4 * unit
            painter.setPen(QColor(theme.text))
            painter.drawText(QRectF(x, place.top(), place.width(), place.height()), middle,
                             shown(series.name))  # fmt: skip
            x += metrics.horizontalAdvance(shown(series.name)) + 1.2 * unit
        words = shown(self._state.title)
        if self._state.limit > 0 and not scale.limit_drawn:
            words = self.tr("{title}; limit ±{limit} lies outside").format(
                title=words, limit=shown_number(significant(self._state.limit, 3))
            )
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        room = QRectF(x, place.top(), place.right() - x, place.height())
        if metrics.horizontalAdvance(words) > room.width():
            # Many traces leave no room beside them: below the plot there is some.
            room = QRectF(place.left(), scale.plot.bottom() + 1.2 * unit, place.width(), 1.2 * unit)
        painter.setPen(QColor(theme.muted))
        painter.drawText(room, right, words)

    def _limits(self, painter: QPainter, scale: "_Scale") -> None:
        theme = current_theme()
        plot = scale.plot
        unit = painter.fontMetrics().height()
        if scale.limit_drawn:
            painter.setPen(QPen(QColor(theme.tones[Tone.BAD]), 1, Qt.PenStyle.DashLine))
            for limit in (self._state.limit, -self._state.limit):
                y = round(scale.y(limit))
                painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y))
            line = scale.y(self._state.limit)
            above = line - 1.15 * unit
            # A low plot has no room over the line.
            top = above if above >= plot.top() else line + 0.15 * unit
            room = QRectF(plot.right() - 12 * unit, top, 11.6 * unit, unit)
            painter.drawText(
                room,
                Qt.AlignmentFlag.AlignRight,
                self.tr("limit ±{limit}°").format(
                    limit=shown_number(significant(self._state.limit, 3))
                ),
            )
        if math.isfinite(self._state.level):
            painter.setPen(QPen(QColor(theme.accent), 1))
            y = round(scale.y(self._state.level))
            painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y))
            painter.drawText(
                QRectF(plot.left() + 0.4 * unit, y - 1.2 * unit, 14 * unit, unit),
                Qt.AlignmentFlag.AlignLeft,
                self.tr("now {value}°").format(value=shown_number(f"{self._state.level:.2f}")),
            )

    def _trace(self, painter: QPainter, scale: "_Scale", series: Series) -> None:
        colour = _colour(series.colour)
        unit = painter.fontMetrics().height()
        rows = sorted(
            (x, y, series.u95[i] if series.u95 else 0.0)
            for i, (x, y) in enumerate(zip(series.x, series.y, strict=True))
            if math.isfinite(y)
        )
        painter.setPen(QPen(colour, 1))
        # Traces stand a little beside each other, so that none hides another's intervals.
        aside = 0.18 * unit * (series.colour % 4 - 1.5)
        points = [QPointF(scale.x(x) + aside, scale.y(y)) for x, y, _ in rows]
        for one, other in pairwise(points):
            painter.drawLine(one, other)
        for point, (x, y, u) in zip(points, rows, strict=True):
            if u > 0:
                low, high = QPointF(point.x(), scale.y(y - u)), QPointF(point.x(), scale.y(y + u))
                painter.drawLine(low, high)
                for end in (low, high):
                    painter.drawLine(end - QPointF(3, 0), end + QPointF(3, 0))
            _symbol(painter, point, series.colour, unit)
            interval = f" ± {significant(u, 2)}" if u > 0 else ""
            words = f"{series.name}, {x:g}°: {significant(y, 4)}{interval} {self._state.unit}"
            self._points.append((point, words))

    def words_at(self, at: QPointF) -> str:
        """The trace, angle and value of the point nearest to a place; empty beside the points."""
        near = [
            (math.hypot(point.x() - at.x(), point.y() - at.y()), words)
            for point, words in self._points
        ]
        distance, words = min(near, default=(math.inf, ""))
        return words if distance <= _NEAR_PX else ""

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), self.words_at(QPointF(event.pos())), self)
            return True
        return super().event(event)


class _Scale:
    """From angles and values to the plot."""

    def __init__(self, plot: QRectF, state: GraphState) -> None:
        self.plot = plot
        self._state = state
        values = [
            value + sign * (series.u95[i] if series.u95 else 0.0)
            for series in state.series
            for i, value in enumerate(series.y)
            if math.isfinite(value)
            for sign in (-1.0, 1.0)
        ]
        low, high = min(values), max(values)
        reach = max(abs(low), abs(high))
        self.limit_drawn = 0.0 < state.limit <= _LIMIT_FAR * reach
        if self.limit_drawn:
            low, high = min(low, -state.limit), max(high, state.limit)
        if math.isfinite(state.level):
            low, high = min(low, state.level), max(high, state.level)
        room = 0.12 * (high - low) or 0.12 * abs(high) or 1.0
        self.low, self.high = low - room, high + room

    def x(self, angle: float) -> float:
        """Abscissa of a set angle."""
        inside = self.plot.adjusted(12, 0, -12, 0)
        share = (angle - self._state.low) / (self._state.high - self._state.low)
        return inside.left() + share * inside.width()

    def y(self, value: float) -> float:
        """Ordinate of a value."""
        return self.plot.bottom() - (value - self.low) / (self.high - self.low) * self.plot.height()


def _colour(kind: int) -> QColor:
    curves = current_theme().curves
    return QColor(curves[kind % len(curves)])


def _symbol(painter: QPainter, at: QPointF, kind: int, unit: float) -> None:
    """A sign of its own for every trace: colour alone would not do."""
    colour = _colour(kind)
    r = 0.26 * unit
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(colour, 1))
    painter.setBrush(colour)
    match kind % 4:
        case 0:
            painter.drawEllipse(at, r, r)
        case 1:
            painter.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r))
        case 2:
            corners = ((0, -1.2), (1.1, 0.9), (-1.1, 0.9))
            painter.drawPolygon(QPolygonF([at + QPointF(r * x, r * y) for x, y in corners]))
        case _:
            painter.setBrush(QColor(current_theme().base))
            painter.drawEllipse(at, r, r)
    painter.restore()
