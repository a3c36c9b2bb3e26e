"""The surface of the stacked charts: what is painted when, and what mouse and keys do."""

import math
from collections.abc import Callable, Sequence
from enum import Enum

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from gui.widgets.chart_scale import nice_step, tick_text
from gui.widgets.history import History
from gui.widgets.strip_painter import (
    Layout,
    paint_column,
    paint_cursor,
    paint_curves,
    paint_ground,
    paint_intervals,
    paint_marks,
)
from gui.widgets.strip_view import Follow, Interval, Mark, StripView
from gui.widgets.theme import current_theme

_GRAB_PX = 6
_LEAST_ROWS_EM = 4.2
"""Height of the lowest chart in heights of the font."""


class _Drag(Enum):
    NONE = 0
    PRESSED = 1
    PAN = 2
    CURSOR_A = 3
    CURSOR_B = 4
    SELECT = 5


class StripCanvas(QWidget):
    """Charts without scroll bar; see `StripCharts` for what each part means."""

    view_changed = Signal()
    cursors_changed = Signal()
    hover_changed = Signal()
    interval_selected = Signal(float, float)
    rows_changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.view = StripView()
        self.history: History | None = None
        self.overlays: tuple[History, ...] = ()
        self.order: tuple[int, ...] = ()
        self.top_row = 0
        self.intervals: Sequence[Interval] = ()
        self.marks: Sequence[Mark] = ()
        self.selecting = False
        self.crosshair = True
        self.cursor_a: float | None = None
        self.cursor_b: float | None = None
        self.hover: float | None = None
        self._drag = _Drag.NONE
        self._pressed = QPointF()
        self._rubber: tuple[float, float] | None = None
        self._ground = QPixmap()
        self._ground_key: tuple[object, ...] = ()
        self._frame = QPixmap()
        self._stale = True
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def sizeHint(self) -> QSize:
        return QSize(900, 500)

    def minimumSizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(30 * unit, round(_LEAST_ROWS_EM * unit + 3 * unit))

    def rows(self) -> int:
        """Return how many charts fit."""
        unit = self.fontMetrics().height()
        fit = int((self.height() - 2 * unit) / (_LEAST_ROWS_EM * unit))
        return max(1, min(len(self.order), fit))

    def shown(self) -> tuple[int, ...]:
        """Return the channels that are seen."""
        return self.order[self.top_row : self.top_row + self.rows()]

    def redraw(self) -> None:
        """Draw curves and axes anew at the next paint."""
        self._stale = True
        self.update()

    def paint(self, painter: QPainter, width: float, height: float) -> None:
        """Draw everything on any painter."""
        layout = Layout.of(width, height, self.shown(), self.font())
        self._fit()
        paint_ground(painter, layout, self.view, current_theme(), self.font())
        self._paint_data(painter, layout)
        self._paint_over(painter, layout)

    def _layout(self) -> Layout:
        return Layout.of(self.width(), self.height(), self.shown(), self.font())

    def _fit(self) -> None:
        if self.history is not None:
            self.view.fit(self.history, self.shown())

    def _paint_data(self, painter: QPainter, layout: Layout) -> None:
        theme = current_theme()
        for overlay in self.overlays:
            paint_curves(painter, layout, self.view, overlay, (theme.disabled,))
        if self.history is not None:
            paint_curves(painter, layout, self.view, self.history, theme.curves)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        layout = self._layout()
        if self._stale or self._frame.deviceIndependentSize().toSize() != self.size():
            self._draw_frame(layout)
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._frame)
        painter.setFont(self.font())
        self._paint_over(painter, layout)
        painter.end()

    def _draw_frame(self, layout: Layout) -> None:
        """Curves over a ground that is kept for as long as no range, size or look changes."""
        self._fit()
        theme = current_theme()
        limits = tuple(self.view.limits(channel) for channel in layout.channels)
        key = (
            self.size(),
            self.devicePixelRatioF(),
            self.view.start,
            self.view.stop,
            layout.channels,
            limits,
            theme.name,
            self.font().key(),
        )
        if key != self._ground_key:
            self._ground = self._pixmap()
            painter = QPainter(self._ground)
            paint_ground(painter, layout, self.view, theme, self.font())
            painter.end()
            self._ground_key = key
        if self._frame.size() != self._ground.size():
            self._frame = self._pixmap()
        painter = QPainter(self._frame)
        painter.drawPixmap(0, 0, self._ground)
        self._paint_data(painter, layout)
        painter.end()
        self._stale = False

    def _pixmap(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        pixmap = QPixmap(self.size() * ratio)
        pixmap.setDevicePixelRatio(ratio)
        return pixmap

    def _paint_over(self, painter: QPainter, layout: Layout) -> None:
        """All that moves with the mouse: it never makes the curves be drawn again."""
        theme = current_theme()
        paint_intervals(painter, layout, self.view, self.intervals, theme)
        if self._rubber is not None:
            low, high = sorted(self._rubber)
            rubber = Interval(low, high, selected=True)
            paint_intervals(painter, layout, self.view, (rubber,), theme)
        paint_marks(painter, layout, self.view, self.marks, theme)
        for label, at in (("", self.hover), ("A", self.cursor_a), ("B", self.cursor_b)):
            if at is not None:
                paint_cursor(painter, layout, self.view, at, label, theme)
        if self.history is None:
            return
        for row, channel in enumerate(layout.channels):
            described = self.history.channels[channel]
            title = f"{described.name}, {described.unit}" if described.unit else described.name
            paint_column(
                painter,
                layout.plot(row),
                layout,
                title,
                self._lines(self.history, channel),
                theme.curves[channel % len(theme.curves)],
                theme,
            )

    def _lines(self, history: History, channel: int) -> list[tuple[str, str]]:
        low, high = self.view.limits(channel)
        step = nice_step(high - low, 1000)

        def text(value: float) -> str:
            return "—" if math.isnan(value) else tick_text(value, step)

        a, b = (
            None if at is None else history.value(channel, history.number(at))
            for at in (self.cursor_a, self.cursor_b)
        )
        number = history.end - 1 if self.hover is None else history.number(self.hover)
        lines = [("", text(history.value(channel, number)))]
        if a is not None:
            lines.append(("A", text(a)))
        if b is not None:
            lines.append(("B", text(b)))
        if a is not None and b is not None:
            lines.append(("B−A", text(b - a)))
        return lines

    # What the operator does.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        self._pressed = event.position()
        layout = self._layout()
        self._drag = _Drag.PRESSED
        if self.selecting:
            self._drag = _Drag.SELECT
            at = layout.time_of(self.view, event.position().x())
            self._rubber = (at, at)
            return
        for drag, at in ((_Drag.CURSOR_A, self.cursor_a), (_Drag.CURSOR_B, self.cursor_b)):
            if at is not None:
                distance = abs(layout.x_of(self.view, at) - event.position().x())
                if distance <= _GRAB_PX:
                    self._drag = drag

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        layout = self._layout()
        x = event.position().x()
        at = layout.time_of(self.view, x)
        inside = layout.area.contains(event.position())
        if self._drag is _Drag.PRESSED and abs(x - self._pressed.x()) > _GRAB_PX:
            self._drag = _Drag.PAN
        if self._drag is _Drag.PAN:
            moved = layout.time_of(self.view, self._pressed.x()) - at
            self._pressed = event.position()
            self._look(lambda: self.view.pan(moved))
        elif self._drag is _Drag.SELECT and self._rubber is not None:
            self._rubber = (self._rubber[0], at)
        elif self._drag is _Drag.CURSOR_A:
            self.set_cursors(at, self.cursor_b)
        elif self._drag is _Drag.CURSOR_B:
            self.set_cursors(self.cursor_a, at)
        self.hover = at if inside and self.crosshair else None
        self.hover_changed.emit()
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag, self._drag = self._drag, _Drag.NONE
        if drag is _Drag.SELECT and self._rubber is not None:
            low, high = sorted(self._rubber)
            self._rubber = None
            if high > low:
                self.interval_selected.emit(low, high)
            self.update()
        elif drag is _Drag.PRESSED:
            layout = self._layout()
            if not layout.area.contains(event.position()):
                return
            at = layout.time_of(self.view, event.position().x())
            if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
                self.set_cursors(self.cursor_a, at)
            else:
                self.set_cursors(at, self.cursor_b)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        channel = self._channel_at(event.position())
        if channel is not None and event.position().x() < self._layout().left:
            self.view.fix(channel, None)
            self.redraw()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.hover = None
        self.hover_changed.emit()
        self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        layout = self._layout()
        notches = event.angleDelta().y() / 120.0 or event.angleDelta().x() / 120.0
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.scroll_rows(-round(notches))
            return
        factor = 1.25**-notches
        on_axis = event.position().x() < layout.left
        if on_axis or event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            channel = self._channel_at(event.position())
            if channel is not None:
                plot = layout.plot(layout.channels.index(channel))
                low, high = self.view.limits(channel)
                share = (plot.bottom() - event.position().y()) / plot.height()
                self.view.zoom_values(channel, factor, low + share * (high - low))
                self.redraw()
            return
        at = layout.time_of(self.view, event.position().x())
        self._look(lambda: self.view.zoom(factor, at))

    def _channel_at(self, position: QPointF) -> int | None:
        layout = self._layout()
        for row, channel in enumerate(layout.channels):
            plot = layout.plot(row)
            if plot.top() <= position.y() <= plot.bottom():
                return channel
        return None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        span = self.view.stop - self.view.start
        middle = self.view.start + 0.5 * span if self.hover is None else self.hover
        control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        key = event.key()
        if control and key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            self._step_cursor(event, -1 if key == Qt.Key.Key_Left else 1)
        elif key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            way = -0.1 if key == Qt.Key.Key_Left else 0.1
            self._look(lambda: self.view.pan(way * span))
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
            self._look(lambda: self.view.zoom(0.8, middle))
        elif key == Qt.Key.Key_Minus:
            self._look(lambda: self.view.zoom(1.25, middle))
        elif key in (Qt.Key.Key_Home, Qt.Key.Key_End):
            self.follow(Follow.ALL if key == Qt.Key.Key_Home else Follow.TAIL)
        elif key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self.scroll_rows(-1 if key == Qt.Key.Key_Up else 1)
        elif key == Qt.Key.Key_A and not control:
            self.set_cursors(middle, self.cursor_b)
        elif key == Qt.Key.Key_B and not control:
            self.set_cursors(self.cursor_a, middle)
        elif key == Qt.Key.Key_C and not control:
            self.set_cursors(None, None)
        else:
            super().keyPressEvent(event)

    def _step_cursor(self, event: QKeyEvent, way: int) -> None:
        """Move A, or with Shift B, by one pixel and at least one sample."""
        step = (self.view.stop - self.view.start) / max(1.0, self._layout().area.width())
        if self.history is not None:
            step = max(step, 1.0 / self.history.rate)
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            if self.cursor_b is not None:
                self.set_cursors(self.cursor_a, self.cursor_b + way * step)
        elif self.cursor_a is not None:
            self.set_cursors(self.cursor_a + way * step, self.cursor_b)

    def follow(self, what: Follow) -> None:
        """Let the window follow the record from now on."""
        self.view.follow = what
        if self.history is not None:
            self.view.advance(self.history.seconds(self.history.end))
        self.view_changed.emit()
        self.redraw()

    def set_cursors(self, a: float | None, b: float | None) -> None:
        """Place the cursors, s."""
        if (a, b) != (self.cursor_a, self.cursor_b):
            self.cursor_a, self.cursor_b = a, b
            self.cursors_changed.emit()
            self.update()

    def scroll_rows(self, rows: int) -> None:
        """Show other channels, so many further down."""
        top = min(max(0, self.top_row + rows), len(self.order) - self.rows())
        if top != self.top_row:
            self.top_row = max(0, top)
            self.rows_changed.emit()
            self.redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.top_row = min(self.top_row, max(0, len(self.order) - self.rows()))
        self.rows_changed.emit()
        self._stale = True
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self.redraw()

    def _look(self, change: Callable[[], None]) -> None:
        change()
        self.view_changed.emit()
        self.redraw()
