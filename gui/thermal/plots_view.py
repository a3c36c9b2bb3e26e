"""One plot a sensor, or an angle, one above the other."""

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from gui.thermal.state import PlotState, ThermalState
from gui.widgets.fields import ChoiceField
from gui.widgets.plot import Plot


class PlotsView(QWidget):
    """The plots with what chooses their content."""

    shown = Signal(int)
    """Number of the quantity."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._states: tuple[PlotState, ...] = ()
        self._rows: list[tuple[QLabel, Plot]] = []
        unit = self.fontMetrics().height()
        self.choice = ChoiceField()
        head = QHBoxLayout()
        head.addWidget(self.choice)
        head.addStretch(1)
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        self._column.setSpacing(unit // 4)
        self._column.addLayout(head)
        self.choice.activated.connect(self.shown)
        self._retranslate()

    @property
    def plots(self) -> tuple[Plot, ...]:
        """The plots on the page, from above."""
        return tuple(plot for _, plot in self._rows[: len(self._states)])

    def render(self, state: ThermalState) -> None:
        """Show a state."""
        if [self.choice.itemText(i) for i in range(self.choice.count())] != [*state.quantities]:
            self.choice.clear()
            self.choice.addItems(list(state.quantities))
        self.choice.setCurrentIndex(state.quantity)
        if state.plots is self._states:
            return
        self._states = state.plots
        while len(self._rows) < len(state.plots):
            self._add_row()
        for place, (title, plot) in enumerate(self._rows):
            for part in (title, plot):
                part.setVisible(place < len(state.plots))
            if place < len(state.plots):
                last = place == len(state.plots) - 1
                _draw(plot, state.plots[place], legend=place == 0, bottom=last)
                title.setText(state.plots[place].title)

    def _add_row(self) -> None:
        title, plot = QLabel(), Plot()
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        title.setTextFormat(Qt.TextFormat.PlainText)
        title.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        title.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._column.addWidget(title)
        self._column.addWidget(plot, 1)
        if self._rows:
            plot.setXLink(self._rows[0][1])
        self._rows.append((title, plot))

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw all plots on any painter, for export."""
        height = size.height() // max(len(self.plots), 1)
        for plot in self.plots:
            painter.save()
            plot.paint(painter, QSize(size.width(), height))
            painter.restore()
            painter.translate(0, height)

    def close_plots(self) -> None:
        """Close the plots: panels of pyqtgraph would outlive them as windows."""
        for _, plot in self._rows:
            plot.close()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self.choice.setAccessibleName(self.tr("Quantity"))


def _draw(plot: Plot, state: PlotState, *, legend: bool, bottom: bool) -> None:
    plot.clear_items()
    plot.set_labels("T, °C" if bottom else "", state.label)
    for line in state.lines:
        name = line.name if legend else ""
        plot.add_curve(line.x, line.y, line.colour, name, dashed=line.dashed)
    for points in state.points:
        bars = points.low.size > 0
        plot.add_points(
            points.x,
            points.y,
            points.colour,
            points.name if legend else "",
            low=points.low if bars else None,
            high=points.high if bars else None,
        )
    plot.show_everything()
