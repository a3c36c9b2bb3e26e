"""What the models of the tables share: rows under a header, columns set flush."""

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtWidgets import QWidget

from gui.languages.shown import shown

Index = QModelIndex | QPersistentModelIndex


class TableModel(QAbstractTableModel):
    """Keeps `rows` and `header`; a subclass replaces them and says what a cell shows."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.rows: Sequence[Any] = ()
        self.header: tuple[str, ...] = ()

    def side(self, column: int) -> Qt.AlignmentFlag:  # noqa: ARG002
        """To which side cells and header of a column are set flush."""
        return Qt.AlignmentFlag.AlignLeft

    def alignment(self, column: int) -> Qt.AlignmentFlag:
        """The same, in the middle of the height."""
        return self.side(column) | Qt.AlignmentFlag.AlignVCenter

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self.header)

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> object:
        if orientation is Qt.Orientation.Vertical:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return shown(self.header[section])
        return self.alignment(section) if role == Qt.ItemDataRole.TextAlignmentRole else None
