"""One plot a sensor, or an angle, one above the other."""

from PySide6.QtCore import QEvent, QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.thermal.state import PlotState, ThermalState
from gui.widgets.fields import ChoiceField
from gui.widgets.legend import POINT, Legend, LegendEntry
from gui.widgets.page_scroll import PageScroll
from gui.widgets.plot import Plot
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class PlotsView(QWidget):
    """The plots with what chooses their content."""

    shown = Signal(int)
    """Number of the quantity."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._states: tuple[PlotState, ...] = ()
        self._quantities: tuple[str, ...] = ()
        self._rows: list[tuple[QLabel, Plot]] = []
        unit = self.fontMetrics().height()
        self.choice, self.legend = ChoiceField(), Legend()
        head = QHBoxLayout()
        head.setSpacing(unit)
        head.addWidget(self.choice)
        head.addWidget(self.legend, 1)
        # An assembly has nine sensors: their plots are looked through, not squeezed.
        rows = QWidget()
        self._column = QVBoxLayout(rows)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(unit // 4)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        column.setSpacing(unit // 4)
        column.addLayout(head)
        column.addWidget(PageScroll(rows), 1)
        self.choice.activated.connect(self.shown)
        self._retranslate()

    @property
    def plots(self) -> tuple[Plot, ...]:
        """The plots on the page, from above."""
        return tuple(plot for _, plot in self._rows[: len(self._states)])

    def render(self, state: ThermalState) -> None:
        """Show a state."""
        self._quantities = state.quantities
        self._name_quantities()
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
                _draw(plot, state.plots[place], bottom=last)
                title.setText(state.plots[place].title)
        self.legend.set_entries(_legend(state.plots))

    def _name_quantities(self) -> None:
        names = [shown(name) for name in self._quantities]
        if [self.choice.itemText(i) for i in range(self.choice.count())] != names:
            place = self.choice.currentIndex()
            self.choice.clear()
            self.choice.addItems(names)
            self.choice.setCurrentIndex(place)

    def _add_row(self) -> None:
        title, plot = WordLabel(), Plot()
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        title.setTextFormat(Qt.TextFormat.PlainText)
        title.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        title.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        plot.setMinimumHeight(9 * self.fontMetrics().height())
        # One width for all, so that the temperatures stand above each other.
        plot.getAxis("left").setWidth(round(4.5 * self.fontMetrics().height()))
        self._column.addWidget(title)
        self._column.addWidget(plot, 1)
        if self._rows:
            plot.setXLink(self._rows[0][1])
        self._rows.append((title, plot))

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw names and plots on any painter, for export."""
        painter.fillRect(QRect(QPoint(), size), current_theme().window)
        line = self.legend.height()
        self.legend.render(painter, QPoint())
        painter.translate(0, line)
        count = max(len(self.plots), 1)
        height = (size.height() - line * (count + 1)) // count
        for title, plot in self._rows[:count]:
            title.render(painter, QPoint())
            painter.translate(0, line)
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
            self._name_quantities()

    def _retranslate(self) -> None:
        self.choice.setAccessibleName(self.tr("Quantity"))


def _legend(states: tuple[PlotState, ...]) -> tuple[LegendEntry, ...]:
    """The names of all plots, each once."""
    entries: dict[LegendEntry, None] = {}
    for state in states:
        for points in state.points:
            entries[LegendEntry(points.name, points.colour, POINT)] = None
        for line in state.lines:
            entries[line.legend] = None
    return tuple(entries)


def _draw(plot: Plot, state: PlotState, *, bottom: bool) -> None:
    plot.clear_items()
    plot.set_labels("T, °C" if bottom else "", state.label)
    for line in state.lines:
        plot.add_curve(line.x, line.y, line.colour, dashed=line.dashed)
    for points in state.points:
        bars = points.low.size > 0
        plot.add_points(
            points.x,
            points.y,
            points.colour,
            low=points.low if bars else None,
            high=points.high if bars else None,
        )
    plot.show_everything()
