"""Stacked charts with one time axis, live or of a record, for 1 to 64 channels.

Mouse: wheel zooms in time about the pointer, Ctrl+wheel or the wheel on the left axis zooms the
values of a chart, double click there gives it back its own range, Shift+wheel scrolls the charts,
dragging moves the window, a click sets cursor A and Shift+click cursor B, both can be dragged.

Keys: arrows move the window and scroll the charts, + and - zoom, Home is the full time scale, End
tracks the newest samples, A, B and C set and clear the cursors, Ctrl and Ctrl+Shift with arrows
move them.
"""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QScrollBar, QWidget

from gui.widgets.history import History
from gui.widgets.strip_canvas import StripCanvas
from gui.widgets.strip_view import Follow, Interval, Mark


class StripCharts(QWidget):
    """Charts over a `History` that somebody else fills.

    The owner calls `refresh` when samples have come, some 30 times a second; it costs the same
    whatever the length of the history, and nothing while the charts are hidden.
    """

    cursors_changed = Signal()
    """Cursor A or B was set, moved or cleared; read `cursors`."""
    hovered = Signal()
    """The pointer moved over the charts or left them; read `hover`."""
    interval_selected = Signal(float, float)
    """A stretch was drawn with the mouse while `set_selecting` was on, s."""
    follow_changed = Signal()
    """Full time scale, auto tracking or neither; read `follow`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._paused = False
        self._told: Follow | None = None
        self._canvas = StripCanvas()
        self._bar = QScrollBar(Qt.Orientation.Vertical)
        self._bar.valueChanged.connect(self._on_bar)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(self._canvas, 1)
        row.addWidget(self._bar)
        self.setFocusProxy(self._canvas)
        self._canvas.cursors_changed.connect(self.cursors_changed)
        self._canvas.hover_changed.connect(self.hovered)
        self._canvas.interval_selected.connect(self.interval_selected)
        self._canvas.view_changed.connect(self._tell_follow)
        self._canvas.rows_changed.connect(self._set_bar)
        self._retranslate()
        self._set_bar()

    @property
    def cursors(self) -> tuple[float | None, float | None]:
        """Times of A and B, s."""
        return self._canvas.cursor_a, self._canvas.cursor_b

    @property
    def hover(self) -> float | None:
        """Time under the pointer, s."""
        return self._canvas.hover

    @property
    def window_s(self) -> tuple[float, float]:
        """First and last time shown, s."""
        return self._canvas.view.start, self._canvas.view.stop

    @property
    def follow(self) -> Follow:
        """What moves the window."""
        return self._canvas.view.follow

    def set_history(self, history: History | None) -> None:
        """Show another record; all its channels, no cursors."""
        self._canvas.history = history
        self._canvas.view.reset(len(history.channels) if history else 0)
        self._canvas.set_cursors(None, None)
        self._canvas.overlays = ()
        self.set_channels(range(len(history.channels)) if history else ())
        self.refresh()

    def set_overlays(self, overlays: Sequence[History]) -> None:
        """Draw other records with the same channels in grey beneath, all from time zero on."""
        self._canvas.overlays = tuple(overlays)
        self._canvas.redraw()

    def set_channels(self, order: Sequence[int]) -> None:
        """Show these channels of the history, from the top."""
        self._canvas.order = tuple(order)
        self._canvas.top_row = 0
        self._set_bar()
        self._canvas.redraw()

    def refresh(self) -> None:
        """Show the samples that have come since."""
        history = self._canvas.history
        if self._paused or history is None:
            return
        self._canvas.view.advance(history.seconds(history.end))
        self._canvas.redraw()

    def set_paused(self, paused: bool) -> None:
        """Freeze the picture; the history goes on."""
        self._paused = paused
        self.refresh()

    def show_all(self) -> None:
        """Full time scale."""
        self._canvas.follow(Follow.ALL)

    def track(self, seconds: float) -> None:
        """Auto tracking: show the last seconds."""
        self._canvas.view.tail_s = seconds
        self._canvas.follow(Follow.TAIL)

    def look_at(self, start: float, stop: float) -> None:
        """Show a window of time, s."""
        self._canvas.view.look_at(start, stop)
        self._tell_follow()
        self._canvas.redraw()

    def set_range(self, channel: int, limits: tuple[float, float] | None) -> None:
        """Fix the range of a channel, or give it back its own."""
        self._canvas.view.fix(channel, limits)
        self._canvas.redraw()

    def set_cursors(self, a: float | None, b: float | None) -> None:
        """Place the cursors, s."""
        self._canvas.set_cursors(a, b)

    def set_selecting(self, on: bool) -> None:
        """Let dragging draw an interval instead of moving the window."""
        self._canvas.selecting = on
        self._canvas.setCursor(Qt.CursorShape.IBeamCursor if on else Qt.CursorShape.ArrowCursor)

    def set_crosshair(self, on: bool) -> None:
        """Draw a line through all charts under the pointer, and show the values there."""
        self._canvas.crosshair = on
        if not on:
            self._canvas.hover = None
            self._canvas.update()

    def set_intervals(self, intervals: Sequence[Interval]) -> None:
        """Shade stretches of time."""
        self._canvas.intervals = tuple(intervals)
        self._canvas.update()

    def set_marks(self, marks: Sequence[Mark]) -> None:
        """Mark events."""
        self._canvas.marks = tuple(marks)
        self._canvas.update()

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw what is shown on any painter, for export."""
        self._canvas.paint(painter, size.width(), size.height())

    def _tell_follow(self) -> None:
        if self.follow is not self._told:
            self._told = self.follow
            self.follow_changed.emit()

    def _on_bar(self, value: int) -> None:
        self._canvas.scroll_rows(value - self._canvas.top_row)

    def _set_bar(self) -> None:
        hidden = len(self._canvas.order) - self._canvas.rows()
        self._bar.setVisible(hidden > 0)
        self._bar.setRange(0, max(0, hidden))
        self._bar.setPageStep(self._canvas.rows())
        self._bar.setValue(self._canvas.top_row)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._set_bar()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._canvas.setAccessibleName(self.tr("Charts"))
        self._canvas.setAccessibleDescription(
            self.tr(
                "Arrows move, plus and minus zoom, Home shows all, End tracks, A and B set cursors"
            )
        )
