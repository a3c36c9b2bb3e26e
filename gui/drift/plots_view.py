"""Turn-ons with the table and its knots above; what is left on held-out turn-ons below."""

from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QSplitter, QVBoxLayout, QWidget

from core.arrays import FloatArray
from gui.drift.state import DriftState, KnotsState, PictureState
from gui.languages.shown import shown
from gui.widgets.colours import Theme
from gui.widgets.fields import ChoiceField
from gui.widgets.legend import Legend
from gui.widgets.plot import Plot
from gui.widgets.theme import current_theme
from gui.widgets.toggle import Toggle
from gui.widgets.word_label import WordLabel

_TABLE = 6
_NEAR_PX = 9.0
_ARROWS = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}
_CHOOSE = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


class KnotPlot(Plot):
    """Turn-ons, means, and the table, whose inner knots the mouse or the arrow keys move."""

    dragged = Signal(int, float)
    """A knot, and where to."""
    dropped = Signal()
    nudged = Signal(int, int)
    """A knot, and by how many blocks."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("t, s", "", parent=parent)
        self._knots: KnotsState | None = None
        self._drawn: PictureState | None = None
        self._held = 0
        self._chosen = 1
        # One path with gaps for all temperatures: a frame of a drag costs one item.
        self._table = pg.PlotCurveItem(connect="finite", antialias=True)
        self._marks = pg.ScatterPlotItem(size=8, pen=None)
        self._lines = pg.PlotCurveItem(connect="pairs")
        self._handle = pg.InfiniteLine(angle=90)
        for item, z in ((self._lines, 5), (self._table, 15), (self._marks, 16), (self._handle, 6)):
            item.setZValue(z)
            self._plot.addItem(item, ignoreBounds=True)
        self._handle.hide()
        self._wear_knots(current_theme())
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def render_curves(self, state: PictureState, table: str) -> None:
        """Draw turn-ons and means; `table` names the table in the legend."""
        self.clear_items()
        self.set_labels("t, s", self.tr("drift, {unit}").format(unit=state.unit))
        for line in (*state.turn_ons, *state.means):
            self.add_curve(line.x, line.y, line.colour, line.name)
        self._entitle(table, _TABLE, Qt.PenStyle.SolidLine)
        self._drawn = state
        self.show_everything()

    def show_everything(self) -> None:
        """Fit the ranges to the curves; above them there is the legend."""
        if self._drawn is not None:
            lines = (*self._drawn.turn_ons, *self._drawn.means)
            _fit(self, [line.x for line in lines], [line.y for line in lines], len(self._legend))

    def render_knots(self, knots: KnotsState | None) -> None:
        """Draw the table; all that a drag needs."""
        self._knots = knots
        if knots is None:
            for item in (self._table, self._marks, self._lines):
                item.setData([], [])
            self._handle.hide()
            return
        m = len(knots.values)
        gap = np.full((m, 1), np.nan)
        x = np.hstack([np.tile(knots.times_s, (m, 1)), gap]).ravel()
        y = np.hstack([knots.values, gap]).ravel()
        self._table.setData(x, y)
        self._marks.setData(np.tile(knots.times_s, m), knots.values.ravel())
        low, high = float(knots.values.min()), float(knots.values.max())
        edges = np.tile([low, high], len(knots.times_s))
        self._lines.setData(np.repeat(knots.times_s, 2), edges)
        self._chosen = min(max(self._chosen, 1), max(len(knots.times_s) - 2, 1))
        self._show_handle()

    def _show_handle(self) -> None:
        inner = self._knots is not None and len(self._knots.times_s) > 2
        self._handle.setVisible(inner and (self.hasFocus() or self._held > 0))
        if self._knots is not None and inner:
            self._handle.setPos(float(self._knots.times_s[self._chosen]))

    # --- mouse and keys ---------------------------------------------------------------------------

    def _time_at(self, position: QPointF) -> float:
        box = self._plot.getViewBox()
        return float(box.mapSceneToView(self.mapToScene(position.toPoint())).x())

    def _near(self, position: QPointF) -> int:
        """The inner knot under the mouse; 0 for none."""
        if self._knots is None or len(self._knots.times_s) < 3:
            return 0
        box = self._plot.getViewBox()
        if not box.sceneBoundingRect().contains(position):
            return 0
        per_px = abs(float(box.viewPixelSize()[0]))
        away = np.abs(self._knots.times_s[1:-1] - self._time_at(position))
        place = int(away.argmin())
        return place + 1 if float(away[place]) < _NEAR_PX * per_px else 0

    def mousePressEvent(self, event: QMouseEvent) -> None:
        knot = self._near(event.position())
        if knot and event.button() == Qt.MouseButton.LeftButton:
            self._held = self._chosen = knot
            self._show_handle()
            event.accept()
            return
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held:
            self.dragged.emit(self._held, self._time_at(event.position()))
            return
        near = self._near(event.position())
        cursor = Qt.CursorShape.SizeHorCursor if near else Qt.CursorShape.ArrowCursor
        self.viewport().setCursor(cursor)
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._held:
            self._held = 0
            self.dropped.emit()
            self._show_handle()
            return
        super().mouseReleaseEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = Qt.Key(event.key())
        if self._knots is None or key not in {**_ARROWS, **_CHOOSE}:
            super().keyPressEvent(event)
        elif key in _ARROWS:
            self.nudged.emit(self._chosen, _ARROWS[key])
        else:
            last = len(self._knots.times_s) - 2
            self._chosen = min(max(self._chosen + _CHOOSE[key], 1), max(last, 1))
            self._show_handle()

    def focusInEvent(self, event: Any) -> None:
        super().focusInEvent(event)
        self._show_handle()

    def focusOutEvent(self, event: Any) -> None:
        super().focusOutEvent(event)
        self._show_handle()

    def _wear_knots(self, theme: Theme) -> None:
        colour = theme.curves[_TABLE % len(theme.curves)]
        self._table.setPen(pg.mkPen(colour, width=1.6))
        self._marks.setBrush(pg.mkBrush(colour))
        self._lines.setPen(pg.mkPen(theme.line, style=Qt.PenStyle.DotLine))
        self._handle.setPen(pg.mkPen(theme.accent))

    def _wear(self, theme: Theme) -> None:
        super()._wear(theme)
        if hasattr(self, "_handle"):
            self._wear_knots(theme)


def _fit(plot: Plot, x: list[FloatArray], y: list[FloatArray], names: int) -> None:
    """Set the ranges so that the legend covers no curve."""
    across, along = np.concatenate(x), np.concatenate(y)
    low, high = float(along.min()), float(along.max())
    room = (high - low or 1.0) * (0.05 + 0.08 * names)
    plot.getViewBox().setRange(
        xRange=(float(across.min()), float(across.max())), yRange=(low, high + room), padding=0.03
    )


class PlotsView(QWidget):
    """Both plots with what chooses their content."""

    shown = Signal(int)
    """Place of the temperature; -1 for all."""
    snapped = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._picture: PictureState | None = None
        self._rendering = False
        unit = self.fontMetrics().height()
        self.choice, self.snap = ChoiceField(), Toggle()
        self.reading, self.caption, self.legend = WordLabel(), QLabel(), Legend()
        self.curves = KnotPlot()
        self.residuals = Plot("t, s", "", log_y=True)
        self.residuals.setXLink(self.curves)
        for plot in (self.curves, self.residuals):
            # One width for both, so that the times stand above each other.
            plot.getAxis("left").setWidth(round(4.5 * unit))
        # Its words change with every pixel of a drag: they must not move the panes.
        self.reading.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.reading.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        head = QHBoxLayout()
        head.setSpacing(unit)
        head.addWidget(self.choice)
        head.addWidget(self.snap)
        head.addStretch(1)
        below = QWidget()
        under = QVBoxLayout(below)
        under.setContentsMargins(0, unit // 4, 0, 0)
        under.setSpacing(unit // 4)
        under.addWidget(self.caption)
        under.addWidget(self.legend)
        under.addWidget(self.residuals, 1)
        self._below = below
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(self.curves)
        split.addWidget(below)
        split.setChildrenCollapsible(False)
        split.setSizes([27 * unit, 23 * unit])
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        column.setSpacing(unit // 4)
        column.addLayout(head)
        column.addWidget(self.reading)
        column.addWidget(split, 1)
        self.choice.activated.connect(self._on_choice)
        self.snap.toggled.connect(self._on_snap)
        self._state: DriftState | None = None
        self._retranslate()

    def render(self, state: DriftState) -> None:
        """Show a state."""
        self._state = state
        self._rendering = True
        temperatures = [shown(text) for text in state.temperatures]
        if [self.choice.itemText(i) for i in range(self.choice.count())] != temperatures:
            self.choice.clear()
            self.choice.addItems(temperatures)
        self.choice.setCurrentIndex(state.shown + 1)
        self.snap.setChecked(state.snap)
        self._rendering = False
        if state.picture is not None and state.picture is not self._picture:
            self._picture = state.picture
            self.curves.render_curves(state.picture, self.tr("this table"))
            self._render_left(state.picture)
        self.render_knots(state.knots)

    def render_knots(self, knots: KnotsState | None) -> None:
        """Show the table alone, while a knot is dragged."""
        self.curves.render_knots(knots)
        self.reading.setText("" if knots is None else knots.reading)

    def _render_left(self, picture: PictureState) -> None:
        self.residuals.clear_items()
        self._below.setVisible(bool(picture.left))
        if not picture.left:
            return
        words = self.tr("left, {unit}").format(unit=picture.unit)
        self.residuals.set_labels("t, s", words)
        for line in picture.left:
            self.residuals.add_curve(line.x, line.y, line.colour, dashed=line.dashed)
        self.legend.set_entries(tuple(line.legend for line in picture.left))
        logarithms = [np.log10(line.y) for line in picture.left]
        _fit(self.residuals, [line.x for line in picture.left], logarithms, 0)

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw both plots on any painter, for export."""
        parts = [self.curves] + ([self.residuals] if self._picture and self._picture.left else [])
        total = sum(part.height() for part in parts)
        painter.fillRect(QRect(QPoint(), size), current_theme().window)
        line = self.legend.height() if len(parts) > 1 else 0
        for part in parts:
            if part is self.residuals:
                self.legend.render(painter, QPoint())
                painter.translate(0, line)
            height = round((size.height() - line) * part.height() / total)
            painter.save()
            part.paint(painter, QSize(size.width(), height))
            painter.restore()
            painter.translate(0, height)

    def close_plots(self) -> None:
        """Close the plots: panels of pyqtgraph would outlive them as windows."""
        self.curves.close()
        self.residuals.close()

    def _on_choice(self, index: int) -> None:
        self.shown.emit(index - 1)

    def _on_snap(self, on: bool) -> None:
        if not self._rendering:
            self.snapped.emit(on)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                self._picture = None
                self.render(self._state)

    def _retranslate(self) -> None:
        self.snap.setText(self.tr("Snap to blocks"))
        self.snap.setToolTip(
            self.tr(
                "Drag a knot with the mouse; or choose it by Page Up and Page Down and move it by"
                " the arrow keys."
            )
        )
        self.choice.setAccessibleName(self.tr("Temperature"))
        self.caption.setText(self.tr("Left on turn-ons that were not seen, rms"))
