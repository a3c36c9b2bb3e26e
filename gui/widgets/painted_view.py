"""A widget that is drawn whole by one method, on the screen as in an exported picture."""

from PySide6.QtCore import QSize
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget


class PaintedView(QWidget):
    """Takes all the room there is; a subclass has ``paint``.

    Parameters
    ----------
    wanted, least : width and height, in heights of a line
    """

    def __init__(
        self, wanted: tuple[int, int], least: tuple[int, int], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._wanted, self._least = wanted, least
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def paint(self, painter: QPainter, size: QSize) -> None:
        """Draw on any painter, for export."""
        raise NotImplementedError

    def sizeHint(self) -> QSize:
        return QSize(*self._wanted) * self.fontMetrics().height()

    def minimumSizeHint(self) -> QSize:
        return QSize(*self._least) * self.fontMetrics().height()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        self.paint(painter, self.size())
        painter.end()
