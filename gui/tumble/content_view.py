"""The two pictures of the page, one above the other."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QSplitter, QVBoxLayout, QWidget

from gui.tumble.harmonics_view import HarmonicsView
from gui.tumble.polar_view import PolarView
from gui.tumble.state import TumbleState

_POLAR = 0.64


class TumbleContent(QWidget):
    """Residuals round the turn above the harmonics."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.polar, self.bars = PolarView(), HarmonicsView()
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(self.polar)
        split.addWidget(self.bars)
        split.setChildrenCollapsible(False)
        split.setStretchFactor(0, 16)
        split.setStretchFactor(1, 9)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(split)

    def render(self, state: TumbleState) -> None:
        """Show a result; without one the pictures stay as they were, out of sight."""
        if state.polar is not None and state.bars is not None:
            self.polar.render(state.polar)
            self.bars.render(state.bars)

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw both on any painter, for export."""
        above = round(_POLAR * size.height())
        self.polar.paint(painter, QSize(size.width(), above))
        painter.translate(0, above)
        self.bars.paint(painter, QSize(size.width(), size.height() - above))
