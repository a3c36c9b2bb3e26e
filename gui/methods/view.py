"""What a page of the tab Methods is, and where it stands."""

from collections.abc import Sequence
from typing import Protocol

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QListWidget,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from core.plans.plan import Plan, Step
from gui.widgets.side_scroll import SideScroll


class Page(Protocol):
    """One method."""

    @property
    def side(self) -> QWidget:
        """Its settings, below the list of pages."""
        ...

    @property
    def widget(self) -> QWidget:
        """All the rest."""
        ...

    def why_busy(self) -> str:
        """Why the ports cannot be let go of now; empty if they can."""
        ...

    def wanted(self) -> tuple[Plan, Step] | None:
        """What the operator of the rig has to set now; None for nothing."""
        ...

    def close(self) -> None:
        """The window closes."""
        ...


class MethodsView(QWidget):
    """List of the pages, and the chosen page.

    Parameters
    ----------
    keys : of the pages, in their order
    """

    chosen = Signal(str)
    """Key of a page."""

    def __init__(self, keys: Sequence[str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self.list = QListWidget()
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._sides, self._pages = QStackedWidget(), QStackedWidget()
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.list)
        column.addWidget(self._sides, 1)
        across = QSplitter(Qt.Orientation.Horizontal)
        across.addWidget(left)
        across.addWidget(self._pages)
        across.setChildrenCollapsible(False)
        across.setStretchFactor(0, 0)
        across.setStretchFactor(1, 1)
        across.setSizes([17 * unit, 68 * unit])
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(across)
        self._keys = tuple(keys)
        self.list.addItems([""] * len(self._keys))
        self._retranslate()
        height = round(1.9 * unit)
        for place in range(len(self._keys)):
            self.list.item(place).setSizeHint(QSize(6 * unit, height))
        self.list.setFixedHeight(len(self._keys) * height + 2 * self.list.frameWidth())
        self.list.currentRowChanged.connect(self._on_row)

    def put(self, page: Page) -> None:
        """Show a page, new or not."""
        if self._pages.indexOf(page.widget) < 0:
            self._sides.addWidget(SideScroll(page.side))
            self._pages.addWidget(page.widget)
        place = self._pages.indexOf(page.widget)
        self._sides.setCurrentIndex(place)
        self._pages.setCurrentIndex(place)

    def choose(self, key: str) -> None:
        """Mark a page in the list."""
        self.list.setCurrentRow(self._keys.index(key))

    def _on_row(self, row: int) -> None:
        if row >= 0:
            self.chosen.emit(self._keys[row])

    def showEvent(self, event: QShowEvent) -> None:
        """Open the first page when the tab is first seen."""
        super().showEvent(event)
        if self.list.currentRow() < 0:
            self.list.setCurrentRow(0)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        titles = {
            "advisor": self.tr("Which procedure?"),
            "tumble": self.tr("Fourier tumble"),
            "gyrocompass": self.tr("Gyrocompass"),
            "comparison": self.tr("Compare gyros"),
        }
        for place, key in enumerate(self._keys):
            self.list.item(place).setText(titles[key])
        self.list.setAccessibleName(self.tr("Methods"))
