"""Measured and simulated above; the residual with its band, and where it leaves it, below."""

from typing import Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from core.arrays import FloatArray
from gui.discrepancy.state import PictureState, StoryState
from gui.languages.shown import shown
from gui.widgets.colours import Theme, blend
from gui.widgets.fields import ChoiceField
from gui.widgets.legend import DASHES, LINE, POINT, Legend, LegendEntry
from gui.widgets.plot import Plot
from gui.widgets.states import Tone
from gui.widgets.toggle import Toggle
from gui.widgets.word_label import WordLabel

_CROSS = "✕"
_MANY = 200
_MEASURED, _SIMULATED, _AGAIN, _CURVE, _PREVIEW, _BAND = 0, 1, 3, 4, 2, 5


class RowsPlot(Plot):
    """Points of two kinds, and stretches of the axis that are marked."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent=parent)
        # The same for all, so that points of one row stand one above the other.
        self._axes["left"].setWidth(round(5.8 * self.fontMetrics().height()))

    def follow(self, other: "RowsPlot") -> None:
        """Show the same stretch of the axis as another plot."""
        self._plot.setXLink(other)

    def add_crosses(self, x: FloatArray, y: FloatArray, colour: int, name: str = "") -> None:
        """Draw points as crosses, so that they can lie on others; many are drawn small."""
        size = 9 if len(x) < _MANY else 4
        item = pg.ScatterPlotItem(x, y, size=size, symbol="x", brush=None)
        self._add(item, lambda theme: item.setPen(pg.mkPen(_shade(theme, colour), width=1)))
        self._entitle(name, colour, None)

    def add_alarm(self, x: FloatArray, y: FloatArray) -> None:
        """Draw points that stand for disagreement, larger and in the colour of what is bad."""
        item = pg.ScatterPlotItem(x, y, size=11, symbol="d", pen=None)
        self._add(item, lambda theme: item.setBrush(pg.mkBrush(theme.tones[Tone.BAD])))

    def add_stretch(self, low: float, high: float) -> None:
        """Tint a stretch of the axis."""
        item: Any = pg.LinearRegionItem((low, high), movable=False)
        item.setZValue(-50)

        def wear(theme: Theme) -> None:
            shade = blend(theme.tones[Tone.BAD], theme.base, 0.14)
            item.setBrush(pg.mkBrush(shade))
            for line in item.lines:
                line.setPen(pg.mkPen(shade))

        self._add(item, wear)

    def add_words(self, x: float, y: float, text: str, above: bool, across: float) -> None:
        """Write what is worst beside its place, which lies so far across the plot, 0 to 1."""
        item = pg.TextItem(shown(text), anchor=(min(max(across, 0.0), 1.0), 1.2 if above else -0.2))
        item.setPos(x, y)
        item.setZValue(20)
        font = self.font()
        font.setBold(True)
        item.setFont(font)

        def wear(theme: Theme) -> None:
            item.setColor(theme.tones[Tone.BAD])
            # Points and bands do not show through the words.
            item.fill = pg.mkBrush(theme.base)
            item.update()

        self._add(item, wear)

    def draw_residual(self, picture: PictureState) -> None:
        """Draw the residual, its band, and where it leaves it."""
        self.clear_items()
        label = self.tr("measured − simulated, {unit}").format(unit=picture.unit)
        self.set_labels(picture.x_label, label)
        if len(picture.band):
            for low, high in stretches(picture.knots, picture.marked):
                self.add_stretch(low, high)
            self.add_band(picture.knots, -picture.band, picture.band, _BAND)
        self.add_points(picture.x, picture.residual, _MEASURED)
        if len(picture.again):
            self.add_crosses(picture.x, picture.again, _AGAIN)
        if len(picture.curve):
            self.add_curve(picture.knots, picture.curve, _CURVE)
        if len(picture.preview):
            self.add_curve(picture.knots, picture.preview, _PREVIEW, dashed=True)
        there = picture.marked > 0
        self.add_alarm(picture.knots[there], picture.mean[there])
        if picture.worst >= 0:
            at = float(picture.mean[picture.worst])
            x = float(picture.knots[picture.worst])
            span = float(np.ptp(picture.knots)) or 1.0
            across = (x - float(picture.knots.min())) / span
            self.add_words(x, at, picture.worst_words, at > 0, across)


class PlotsView(QWidget):
    """Both plots with what belongs to them."""

    channel_chosen = Signal(int)
    after_chosen = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._picture: PictureState | None = None
        self._rendering = False
        unit = self.fontMetrics().height()
        self.title = WordLabel()
        self.title.setWordWrap(True)
        self.title.setTextFormat(Qt.TextFormat.PlainText)
        font = self.title.font()
        font.setBold(True)
        self.title.setFont(font)
        self.title.setMinimumHeight(round(2.4 * unit))
        self.channels, self.after = ChoiceField(), Toggle()
        self.channels.setSizeAdjustPolicy(ChoiceField.SizeAdjustPolicy.AdjustToContents)
        head = QHBoxLayout()
        head.addWidget(self.channels)
        head.addWidget(self.after)
        head.addStretch(1)
        self.legend_rows, self.legend_left = Legend(), Legend()
        self.rows, self.left = RowsPlot(), RowsPlot()
        # Both follow the same regressor.
        self.left.follow(self.rows)
        panes = QSplitter(Qt.Orientation.Vertical)
        for legend, plot in ((self.legend_rows, self.rows), (self.legend_left, self.left)):
            pane = QWidget()
            column = QVBoxLayout(pane)
            column.setContentsMargins(0, 0, 0, 0)
            column.setSpacing(0)
            column.addWidget(legend)
            column.addWidget(plot, 1)
            panes.addWidget(pane)
            if plot is self.rows:
                self._rows_pane = pane
        panes.setChildrenCollapsible(False)
        panes.setStretchFactor(0, 2)
        panes.setStretchFactor(1, 3)
        panes.setSizes([20 * unit, 30 * unit])
        rows = QVBoxLayout(self)
        rows.setContentsMargins(unit // 2, unit // 2, unit // 4, 0)
        rows.setSpacing(unit // 4)
        rows.addWidget(self.title)
        rows.addLayout(head)
        rows.addWidget(panes, 1)
        self.channels.activated.connect(self._on_channel)
        self.after.toggled.connect(self._on_after)
        self._retranslate()

    def render(self, state: StoryState) -> None:
        """Show a state."""
        self._rendering = True
        names = [self.channels.itemText(i) for i in range(self.channels.count())]
        if names != list(state.channels):
            self.channels.clear()
            self.channels.addItems(state.channels)
        self.channels.setCurrentIndex(state.channel)
        self.channels.setVisible(len(state.channels) > 1)
        self.after.setChecked(state.after)
        self.after.setVisible(state.can_after)
        self._rendering = False
        if state.picture is None or state.picture is self._picture:
            return
        self._picture = state.picture
        self.title.setText(state.picture.title)
        self.draw(state.picture, after=state.after)

    def draw(self, picture: PictureState, *, after: bool) -> None:
        """Draw both plots."""
        rows = self.rows
        rows.clear_items()
        rows.set_labels("", self.tr("output, {unit}").format(unit=picture.unit))
        rows.add_points(picture.x, picture.measured, _MEASURED)
        rows.add_crosses(picture.x, picture.simulated, _SIMULATED)
        if len(picture.played):
            rows.add_crosses(picture.x, picture.played, _AGAIN)
        self.left.draw_residual(picture)
        self._render_legends(picture, after)
        self._rows_pane.setVisible(len(picture.measured) > 0)
        rows.show_everything()
        self.left.show_everything()

    def _render_legends(self, picture: PictureState, after: bool) -> None:
        model = self.tr("simulated, plain model")
        if after:
            model = self.tr("simulated, with the effects")
        above = [
            LegendEntry(self.tr("measured"), _MEASURED, POINT),
            LegendEntry(model, _SIMULATED, _CROSS),
        ]
        if len(picture.played):
            above.append(LegendEntry(self.tr("simulated rig"), _AGAIN, _CROSS))
        self.legend_rows.set_entries(tuple(above))
        entries = [LegendEntry(self.tr("residual"), _MEASURED, POINT)]
        if len(picture.band):
            entries.append(LegendEntry(self.tr("structure"), _CURVE, LINE))
            entries.append(LegendEntry(self.tr("95 % band for all points"), _BAND, LINE))
        if len(picture.preview):
            entries.append(LegendEntry(picture.preview_name, _PREVIEW, DASHES))
        if len(picture.again):
            entries.append(LegendEntry(self.tr("simulated rig less model"), _AGAIN, _CROSS))
        self.legend_left.set_entries(tuple(entries))

    def close_plots(self) -> None:
        """Close the plots: panels of pyqtgraph would outlive them as windows."""
        self.rows.close()
        self.left.close()

    def _on_channel(self, place: int) -> None:
        if not self._rendering:
            self.channel_chosen.emit(place)

    def _on_after(self, on: bool) -> None:
        if not self._rendering:
            self.after_chosen.emit(on)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._picture is not None:
                self.draw(self._picture, after=self.after.isChecked())

    def _retranslate(self) -> None:
        self.channels.setAccessibleName(self.tr("Output"))
        self.after.setText(self.tr("With the effects added"))


def stretches(knots: FloatArray, marked: FloatArray) -> list[tuple[float, float]]:
    """Stretches of the axis that belong to marked knots, each half way to its neighbours."""
    if not len(knots):
        return []
    middles = 0.5 * (knots[1:] + knots[:-1])
    edges = np.concatenate([knots[:1], middles, knots[-1:]])
    found: list[tuple[float, float]] = []
    for place in np.flatnonzero(marked > 0):
        low, high = float(edges[place]), float(edges[place + 1])
        if found and found[-1][1] == low:
            found[-1] = (found[-1][0], high)
        else:
            found.append((low, high))
    return found


def _shade(theme: Theme, number: int) -> str:
    return theme.curves[number % len(theme.curves)]
