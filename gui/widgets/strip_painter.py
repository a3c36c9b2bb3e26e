"""Drawing of the stacked charts on any painter: the screen's, a printer's, an SVG file's."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen

from gui.languages.shown import shown, shown_number
from gui.widgets.chart_scale import nice_step, tick_text, ticks, time_step, time_text
from gui.widgets.colours import Theme
from gui.widgets.history import History
from gui.widgets.polyline import polygons
from gui.widgets.states import Tone
from gui.widgets.strip_view import Interval, Mark, StripView

_DOTS = 300
"""Below so many samples in view each one is drawn as a dot too."""


@dataclass(frozen=True, slots=True)
class Layout:
    """Places of the parts, in pixels.

    Parameters
    ----------
    channels : numbers of the channels that are seen, from the top
    """

    width: float
    height: float
    channels: tuple[int, ...]
    left: float
    right: float
    bottom: float
    top: float

    @classmethod
    def of(cls, width: float, height: float, channels: tuple[int, ...], font: QFont) -> "Layout":
        """Lay out so many charts on a surface."""
        metrics = QFontMetricsF(font)
        unit = metrics.height()
        return cls(
            width,
            height,
            channels,
            left=metrics.horizontalAdvance("0") * 10 + 6,
            right=min(metrics.horizontalAdvance("0") * 19, 0.3 * width),
            bottom=1.6 * unit,
            top=0.4 * unit,
        )

    def plot(self, row: int) -> QRectF:
        """Return where the chart in this row is drawn."""
        each = (self.height - self.bottom - self.top) / max(1, len(self.channels))
        rect = QRectF(self.left, self.top + row * each, self.width - self.left - self.right, each)
        return rect.adjusted(0, 3, 0, -3)

    @property
    def area(self) -> QRectF:
        """All charts together, without axes."""
        return QRectF(
            self.left,
            self.top,
            self.width - self.left - self.right,
            self.height - self.top - self.bottom,
        )

    def x_of(self, view: StripView, seconds: float) -> float:
        """Return the pixel of a time."""
        area = self.area
        return area.left() + area.width() * (seconds - view.start) / (view.stop - view.start)

    def time_of(self, view: StripView, x: float) -> float:
        """Return the time at a pixel."""
        area = self.area
        return view.start + (view.stop - view.start) * (x - area.left()) / area.width()


def paint_ground(
    painter: QPainter, layout: Layout, view: StripView, theme: Theme, font: QFont
) -> None:
    """Draw surfaces, grid and axes."""
    painter.fillRect(QRectF(0, 0, layout.width, layout.height), QColor(theme.window))
    painter.setFont(font)
    metrics = QFontMetricsF(font)
    area = layout.area
    step = time_step(
        view.stop - view.start, max(2, int(area.width() / (9 * metrics.averageCharWidth())))
    )
    times = ticks(view.start, view.stop, step)
    for row, channel in enumerate(layout.channels):
        plot = layout.plot(row)
        painter.fillRect(plot, QColor(theme.base))
        low, high = view.limits(channel)
        value_step = nice_step(high - low, max(1, int(plot.height() / (1.35 * metrics.height()))))
        values = ticks(low, high, value_step)
        scale = plot.height() / (high - low)
        painter.setPen(QPen(QColor(theme.grid), 1))
        lines = [
            QLineF(plot.left(), y, plot.right(), y)
            for y in (round(plot.bottom() - (v - low) * scale) for v in values)
        ]
        lines += [
            QLineF(x, plot.top(), x, plot.bottom())
            for x in (round(layout.x_of(view, t)) for t in times)
        ]
        painter.drawLines(lines)
        painter.setPen(QPen(QColor(theme.line), 1))
        painter.drawRect(plot)
        painter.setPen(QColor(theme.muted))
        for value in values:
            y = plot.bottom() - (value - low) * scale
            if plot.top() + 0.3 * metrics.height() <= y <= plot.bottom() - 0.3 * metrics.height():
                place = QRectF(0, y - metrics.height(), layout.left - 5, 2 * metrics.height())
                painter.drawText(
                    place,
                    Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                    shown_number(tick_text(value, value_step)),
                )
    _paint_times(painter, layout, view, times, step)


def _paint_times(
    painter: QPainter, layout: Layout, view: StripView, times: Sequence[float], step: float
) -> None:
    metrics = painter.fontMetrics()
    top = layout.height - layout.bottom
    centre = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop
    for time in times:
        x = layout.x_of(view, time)
        text = shown_number(time_text(time, step, view.stop))
        half = metrics.horizontalAdvance(text)
        painter.drawText(QRectF(x - half, top + 2, 2 * half, layout.bottom), centre, text)
    unit = "s" if view.stop < 120.0 else "min:s" if view.stop < 3600.0 else "h:min:s"
    painter.drawText(
        QRectF(layout.width - layout.right, top + 2, layout.right - 8, layout.bottom),
        Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop,
        unit,
    )


def paint_curves(
    painter: QPainter,
    layout: Layout,
    view: StripView,
    history: History,
    colours: Sequence[str],
) -> None:
    """Draw every channel of a history in the colour that its turn has."""
    start, stop = history.number(view.start) - 1, history.number(view.stop) + 2
    area = layout.area
    per_sample = area.width() / ((view.stop - view.start) * history.rate)
    left = layout.x_of(view, 0.0) - per_sample * history.first
    pixels = max(1, int(area.width()))
    dots = (stop - start) < _DOTS
    for row, channel in enumerate(layout.channels):
        plot = layout.plot(row)
        low, high = view.limits(channel)
        per_unit = -plot.height() / (high - low)
        top = plot.bottom() - low * per_unit
        colour = QColor(colours[channel % len(colours)])
        pen = QPen(colour, 1)
        painter.save()
        painter.setClipRect(plot)
        painter.setPen(pen)
        for columns in history.columns(channel, start, stop, pixels):
            for line in polygons(columns, left, per_sample, top, per_unit):
                painter.drawPolyline(line)
                if dots or line.size() == 1:
                    painter.setPen(QPen(colour, 4))
                    painter.drawPoints(line)
                    painter.setPen(pen)
        painter.restore()


def paint_intervals(
    painter: QPainter, layout: Layout, view: StripView, intervals: Sequence[Interval], theme: Theme
) -> None:
    """Shade marked stretches; a selected one has a frame too."""
    area = layout.area
    painter.save()
    painter.setClipRect(area)
    for interval in intervals:
        left, right = layout.x_of(view, interval.start), layout.x_of(view, interval.stop)
        tone = Tone.ACTION if interval.selected else Tone.IDLE
        colour = QColor(theme.tones[tone])
        shade = QColor(colour)
        shade.setAlpha(40)
        rect = QRectF(left, area.top(), right - left, area.height())
        painter.fillRect(rect, shade)
        painter.setPen(QPen(colour, 2 if interval.selected else 1))
        painter.drawLine(rect.topLeft(), rect.bottomLeft())
        painter.drawLine(rect.topRight(), rect.bottomRight())
        painter.drawText(QPointF(left + 4, area.bottom() - 6), interval.label)
    painter.restore()


def paint_marks(
    painter: QPainter, layout: Layout, view: StripView, marks: Sequence[Mark], theme: Theme
) -> None:
    """Draw events as dotted lines with their notes at the top."""
    area = layout.area
    painter.save()
    painter.setClipRect(area)
    painter.setPen(QPen(QColor(theme.muted), 1, Qt.PenStyle.DotLine))
    for mark in marks:
        x = layout.x_of(view, mark.at)
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
        painter.drawText(QPointF(x + 4, area.top() + painter.fontMetrics().ascent() + 3), mark.text)
    painter.restore()


def paint_cursor(
    painter: QPainter, layout: Layout, view: StripView, at: float, label: str, theme: Theme
) -> None:
    """Draw a vertical line through all charts with its time at the bottom."""
    area = layout.area
    x = layout.x_of(view, at)
    if not area.left() <= x <= area.right():
        return
    colour = QColor(theme.accent if label else theme.muted)
    painter.setPen(QPen(colour, 1))
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
    step = nice_step((view.stop - view.start) / max(1.0, area.width()), 1)
    text = shown_number(f"{label} {time_text(at, step, view.stop)}".strip())
    metrics = painter.fontMetrics()
    width = metrics.horizontalAdvance(text) + 8
    tag = QRectF(0, area.bottom() + 2, width, metrics.height() + 1)
    tag.moveLeft(min(max(x - width / 2, area.left()), area.right() - width))
    painter.fillRect(tag.adjusted(-5, 0, 5, 1), QColor(theme.window))
    painter.fillRect(tag, colour)
    painter.setPen(QColor(theme.on_accent if label else theme.window))
    painter.drawText(tag, Qt.AlignmentFlag.AlignCenter, text)


def paint_column(
    painter: QPainter,
    plot: QRectF,
    layout: Layout,
    title: str,
    lines: Sequence[tuple[str, str]],
    colour: str,
    theme: Theme,
) -> None:
    """Draw name and values of a channel beside its chart; what does not fit is left out."""
    metrics = painter.fontMetrics()
    left = plot.right() + 12
    place = QRectF(left, plot.top(), layout.width - left - 4, metrics.height())
    painter.fillRect(QRectF(left - 8, plot.top(), 3, plot.height()), QColor(colour))
    painter.setPen(QColor(theme.muted))
    painter.drawText(
        place,
        Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
        metrics.elidedText(title, Qt.TextElideMode.ElideRight, int(place.width())),
    )
    for label, value in lines:
        place.translate(0, metrics.height() * 1.05)
        if place.bottom() > plot.bottom() + 2:
            return
        words = shown(label)
        painter.setPen(QColor(theme.muted))
        painter.drawText(place, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, words)
        painter.setPen(QColor(theme.text))
        offset = metrics.horizontalAdvance(words + " ") if words else 0
        painter.drawText(
            place.adjusted(offset, 0, 0, 0),
            Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
            shown_number(value),
        )
