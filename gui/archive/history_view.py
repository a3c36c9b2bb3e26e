"""A parameter over time, with error bars, its scatter and its limits."""

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from core.arrays import FloatArray
from gui.archive.date_ticks import date_ticks
from gui.archive.state import HistoryState
from gui.widgets.colours import Theme
from gui.widgets.plot import Plot
from gui.widgets.theme import current_theme

_VALUE, _ASIDE, _LIMIT = 0, 4, 1
_DAY, _AGES = 86400.0, 3e9
_FAR = 4.0
"""Limits beyond so many heights of the values are not brought into the picture."""


class HistoryPlot(Plot):
    """Values with their 95 % bars over dates; those of the chosen entries have a ring."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("", "", parent=parent)
        self._state: HistoryState | None = None
        self._zero = 0.0
        self._ring = pg.ScatterPlotItem(size=15, brush=None)
        self._ring.setZValue(20)
        self._plot.addItem(self._ring, ignoreBounds=True)
        self._wear_ring(current_theme())
        self._plot.getViewBox().sigXRangeChanged.connect(self._on_range)

    def render_history(self, state: HistoryState) -> None:
        """Draw a state."""
        if state is self._state:
            return
        self._state = state
        self.clear_items()
        self.set_labels("", f"{state.title}, {state.unit}")
        known = np.isfinite(state.seconds)
        # Seconds since 1970 leave single-precision painters no digits: count from the first.
        self._zero = float(state.seconds[known].min()) if known.any() else 0.0
        x = state.seconds - self._zero
        self._draw_values(state, x)
        self._ring.setData(x[state.chosen], state.values[state.chosen])
        self._range(state, x[known])

    def _draw_values(self, state: HistoryState, x: FloatArray) -> None:
        counted = state.counted.astype(bool)
        whole = np.array([-_AGES, _AGES])
        if np.isfinite(state.spread):
            mean = np.full(2, state.mean)
            self.add_band(whole, mean - state.spread, mean + state.spread, _VALUE)
            words = QCoreApplication.translate("HistoryPlot", "mean ± s")
            self.add_curve(whole, mean, _VALUE, words, dashed=True)
        words = QCoreApplication.translate("HistoryPlot", "limits")
        for number, limit in enumerate((state.low, state.high)):
            if np.isfinite(limit):
                first = number == 0 or not np.isfinite(state.low)
                self.add_curve(whole, np.full(2, limit), _LIMIT, words if first else "")
        words = QCoreApplication.translate("HistoryPlot", "value ± U")
        aside = QCoreApplication.translate("HistoryPlot", "not counted")
        for which, colour, name in ((counted, _VALUE, words), (~counted, _ASIDE, aside)):
            if which.any():
                half = np.nan_to_num(state.expanded[which])
                y = state.values[which]
                self.add_points(x[which], y, colour, name, low=y - half, high=y + half)

    def _range(self, state: HistoryState, x: FloatArray) -> None:
        half = np.nan_to_num(state.expanded)
        low, high = float((state.values - half).min()), float((state.values + half).max())
        height = max(high - low, 1e-9 * abs(high), 1e-300)
        for limit in (state.low, state.high):
            if np.isfinite(limit) and low - _FAR * height <= limit <= high + _FAR * height:
                low, high = min(low, limit), max(high, limit)
        room = 0.08 * max(high - low, height)
        width = max(float(np.ptp(x)) if x.size else 0.0, _DAY)
        middle = float(x.min() + x.max()) / 2.0 if x.size else 0.0
        self._plot.getViewBox().setRange(
            xRange=(middle - 0.56 * width, middle + 0.56 * width),
            # Above there is the legend.
            yRange=(low - room, high + 3.0 * room),
            padding=0.0,
        )
        self._on_range()

    def show_everything(self) -> None:
        """Fit the ranges to the values."""
        if self._state is not None:
            known = np.isfinite(self._state.seconds)
            self._range(self._state, self._state.seconds[known] - self._zero)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if getattr(self, "_ring", None) is not None and self.getPlotItem() is not None:
            self._on_range()

    def _on_range(self) -> None:
        low, high = self._plot.getViewBox().viewRange()[0]
        most = max(3, self.width() // (11 * self.fontMetrics().averageCharWidth()))
        ticks = date_ticks(low + self._zero, high + self._zero, most)
        self._axes["bottom"].setTicks([[(at - self._zero, words) for at, words in ticks]])

    def _wear_ring(self, theme: Theme) -> None:
        self._ring.setPen(pg.mkPen(theme.text))

    def _wear(self, theme: Theme) -> None:
        super()._wear(theme)
        if hasattr(self, "_ring"):
            self._wear_ring(theme)
