"""The log-log plot of Allan deviations, with a cursor that reads the chosen curve."""

import math

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from core.allan.confidence import local_slopes
from core.arrays import FloatArray
from gui.allan.state import CurveState, PictureState
from gui.allan.texts import short
from gui.widgets.colours import Theme
from gui.widgets.plot import Plot
from gui.widgets.theme import current_theme

_TERM_COLOUR = 4


class AllanPlot(Plot):
    """Curves, bands, fitted terms; the mouse or the arrow keys move the cursor from tau to tau."""

    read = Signal(str)
    """What the cursor reads, in words; empty where there is no cursor."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("τ, s", "σ(τ)", log_x=True, log_y=True, parent=parent)
        self._state: PictureState | None = None
        self._drawn: tuple[bool, bool] = (True, True)
        self._slopes = np.empty(0)
        self._at = -1
        self._line = pg.InfiniteLine(angle=90)
        self._mark = pg.ScatterPlotItem(size=9, brush=None)
        for item in (self._line, self._mark):
            item.setZValue(20)
            item.hide()
            self._plot.addItem(item, ignoreBounds=True)
        self._wear_cursor(current_theme())
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def render_picture(self, state: PictureState, *, band: bool, terms: bool) -> None:
        """Draw a state."""
        if state is self._state and self._drawn == (band, terms):
            return
        self._state, self._drawn = state, (band, terms)
        self.clear_items()
        self.set_labels("τ, s", f"σ(τ), {state.unit}" + (state.mixed and f"; {state.mixed}"))
        for curve in state.curves:
            if band and not curve.aside:
                self.add_band(curve.taus, curve.lower, curve.upper, curve.colour)
        if terms:
            for line in state.lines:
                if line.whole:
                    self.add_curve(line.taus, line.values, _TERM_COLOUR, "fitted model")
                else:
                    self.add_curve(line.taus, line.values, _TERM_COLOUR, dashed=True)
                    self.add_text(*self._place_of(line.taus, line.values), line.words)
        for curve in state.curves:
            self.add_curve(
                curve.taus, curve.deviation, curve.colour, curve.name, dashed=curve.aside
            )
            if not curve.aside and len(state.curves) < 4:
                self.add_points(curve.taus, curve.deviation, curve.colour)
        self._range(state)
        chosen = state.curves[len(state.curves) - 1]
        self._slopes = local_slopes(chosen.taus, chosen.deviation) if len(chosen.taus) > 1 else []
        self._at = min(self._at, len(chosen.taus) - 1)
        self._show_cursor()

    def _range(self, state: PictureState) -> None:
        """Fit the ranges to the curves: the terms may leave the picture."""
        x = np.log10(np.concatenate([curve.taus for curve in state.curves]))
        y = np.log10(np.concatenate([curve.deviation for curve in state.curves]))
        span = max(float(np.ptp(y)), 0.5)
        room = 0.06 * span
        legend = 0.04 * span * (len(state.curves) + 1)
        self._plot.getViewBox().setRange(
            xRange=(float(x.min()), float(x.max())),
            # Above there is the legend.
            yRange=(float(y.min()) - 3.0 * room, float(y.max()) + room + legend),
            padding=0.02,
        )

    def show_everything(self) -> None:
        """Fit the ranges to the curves."""
        if self._state is not None:
            self._range(self._state)

    @staticmethod
    def _place_of(taus: FloatArray, values: FloatArray) -> tuple[float, float]:
        """Where the words of a line stand: below the legend, which is in the upper right."""
        at = int(0.3 * len(taus)) if values[0] > values[-1] else int(0.75 * len(taus))
        return float(taus[at]), float(values[at])

    # --- the cursor -------------------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        curve = self._chosen()
        if curve is None:
            return
        box = self._plot.getViewBox()
        if box.sceneBoundingRect().contains(QPointF(event.position())):
            x = box.mapSceneToView(self.mapToScene(event.position().toPoint())).x()
            self._at = int(np.abs(np.log10(curve.taus) - x).argmin())
        self._show_cursor()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        curve = self._chosen()
        step = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()), 0)
        if curve is None or not step:
            super().keyPressEvent(event)
            return
        begin = 0 if step > 0 else len(curve.taus) - 1
        at = begin if self._at < 0 else self._at + step
        self._at = min(max(at, 0), len(curve.taus) - 1)
        self._show_cursor()

    def _chosen(self) -> CurveState | None:
        return None if self._state is None else self._state.curves[-1]

    def _show_cursor(self) -> None:
        curve = self._chosen()
        visible = curve is not None and self._at >= 0
        self._line.setVisible(visible)
        self._mark.setVisible(visible)
        if curve is None or not visible:
            self.read.emit("")
            return
        tau, sigma = float(curve.taus[self._at]), float(curve.deviation[self._at])
        self._line.setPos(math.log10(tau))
        self._mark.setData([math.log10(tau)], [math.log10(sigma)])
        unit = "" if self._state is None else self._state.unit
        slope = f", slope {self._slopes[self._at]:+.2f}".replace("-", "\N{MINUS SIGN}")
        low, high = (float(edge[self._at]) for edge in (curve.lower, curve.upper))
        self.read.emit(
            f"τ = {short(tau, 4)} s   σ = {short(sigma, 4)} {unit}   "
            f"({short(low, 3)} … {short(high, 3)}, 1σ), "
            f"{curve.edf[self._at]:.3g} dof{slope}"
        )

    def _wear_cursor(self, theme: Theme) -> None:
        self._line.setPen(pg.mkPen(theme.muted))
        self._mark.setPen(pg.mkPen(QColor(theme.text)))

    def _wear(self, theme: Theme) -> None:
        super()._wear(theme)
        if hasattr(self, "_line"):
            self._wear_cursor(theme)
