"""Compass above; below it the uncertainty of the heading against the averaging time."""

import numpy as np
from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QLabel, QSplitter, QStackedWidget, QVBoxLayout, QWidget

from gui.gyrocompass.compass_view import CompassView
from gui.gyrocompass.state import Advice, CompassChoices, CompassState
from gui.languages.shown import shown_number
from gui.widgets.number_text import significant
from gui.widgets.plot import Plot

_COMPASS = 0.58
_NOW = 1
_ENOUGH = 2


class CompassContent(QWidget):
    """The two pictures of the page."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.compass = CompassView()
        self.plot: Plot | None = Plot(log_x=True, log_y=True)
        self.missing = QLabel()
        self.missing.setWordWrap(True)
        self.missing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        unit = self.fontMetrics().height()
        self.missing.setContentsMargins(2 * unit, unit, 2 * unit, unit)
        self._below = QStackedWidget()
        self._below.addWidget(self.missing)
        self._below.addWidget(self.plot)
        self._state: CompassState | None = None
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(self.compass)
        split.addWidget(self._below)
        split.setChildrenCollapsible(False)
        split.setStretchFactor(0, 5)
        split.setStretchFactor(1, 4)
        split.setSizes([22 * unit, 17 * unit])
        self._below.setMinimumHeight(11 * unit)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(split)
        self._retranslate()

    def render(self, state: CompassState) -> None:
        """Show a state."""
        before, self._state = self._state, state
        self.compass.render(state.rose)
        plot = self.plot
        if plot is None or state.advice is None:
            self._below.setCurrentWidget(self.missing)
            return
        self._below.setCurrentWidget(plot)
        if before is None or before.advice is not state.advice:
            self._draw(plot, state.advice, state.choices)

    def close_plot(self) -> None:
        """Panels of pyqtgraph would outlive it as windows; may be called again."""
        if self.plot is not None:
            plot, self.plot = self.plot, None
            self._below.setCurrentWidget(self.missing)
            plot.close()

    def _draw(self, plot: Plot, advice: Advice, choices: CompassChoices) -> None:
        curve = advice.curve
        plot.clear_items()
        plot.set_labels(
            self.tr("averaging time at each heading, s"), self.tr("u of the heading, °")
        )
        plot.add_curve(curve.seconds, curve.u_deg, 0)
        if choices.target_deg > 0:
            level = np.full(2, choices.target_deg)
            ends = np.array([curve.seconds[0], curve.seconds[-1]])
            words = self.tr("wanted, {target}°").format(
                target=shown_number(significant(choices.target_deg, 2))
            )
            plot.add_curve(ends, level, _ENOUGH, words, dashed=True)
        plot.add_points(
            np.array([choices.average_s]),
            np.array([advice.now_deg]),
            _NOW,
            self.tr("as set, {u}°").format(u=shown_number(significant(advice.now_deg, 2))),
        )
        plot.add_points(
            np.array([curve.best_s]),
            np.array([curve.best_deg]),
            3,
            self.tr("best, {u}°").format(u=shown_number(significant(curve.best_deg, 2))),
        )
        plot.show_everything()

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw both on any painter, for export."""
        plot = self.plot if self._state is not None and self._state.advice is not None else None
        above = size.height() if plot is None else round(_COMPASS * size.height())
        self.compass.paint(painter, QSize(size.width(), above))
        if plot is not None:
            painter.translate(0, above)
            plot.paint(painter, QSize(size.width(), size.height() - above))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                state, self._state = self._state, None
                self.render(state)

    def _retranslate(self) -> None:
        self.missing.setText(
            self.tr(
                "State the noise of the gyro at the left, or take it from a record: then this curve"
                " shows how long to average."
            )
        )
