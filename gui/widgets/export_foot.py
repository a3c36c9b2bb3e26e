"""What can be exported, under results: format, file name, and the button."""

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QGridLayout, QLineEdit, QPushButton, QWidget

from gui.languages.shown import shown
from gui.widgets.fields import ChoiceField


class ExportFoot(QWidget):
    """Where a file goes stands in its name.

    Parameters
    ----------
    two_rows : the name has a row of its own, for a narrow panel
    """

    export_requested = Signal(str, str)
    """Format and file name."""
    format_chosen = Signal(str)

    def __init__(self, *, two_rows: bool = False, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._titles: list[str] = []
        self.formats, self.name, self.button = ChoiceField(), QLineEdit(), QPushButton()
        # Titles of formats are long: the field shortens them, and the name keeps its room.
        self.formats.setMinimumContentsLength(12)
        self.formats.setSizeAdjustPolicy(
            ChoiceField.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.formats.activated.connect(self._on_format)
        self.name.returnPressed.connect(self.export)
        self.button.clicked.connect(self.export)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(self.formats, 0, 0)
        if two_rows:
            grid.addWidget(self.button, 0, 1)
            grid.addWidget(self.name, 1, 0, 1, 2)
            grid.setColumnStretch(0, 1)
        else:
            grid.addWidget(self.name, 0, 1)
            grid.addWidget(self.button, 0, 2)
            grid.setColumnStretch(0, 2)
            grid.setColumnStretch(1, 3)
        self._retranslate()

    def set_formats(self, formats: tuple[tuple[str, str], ...]) -> None:
        """Offer these formats: keys and titles."""
        for key, title in formats:
            self.formats.addItem(shown(title), key)
        self._titles = [title for _, title in formats]

    @property
    def chosen_format(self) -> str:
        """Key of the format on the screen."""
        return str(self.formats.currentData())

    def show_name(self, name: str) -> None:
        """Propose a file name."""
        self.name.setText(name)
        self.name.setToolTip(name)

    def export(self) -> None:
        """Write the chosen format under the name in the field."""
        self.export_requested.emit(self.chosen_format, self.name.text())

    def _on_format(self, index: int) -> None:
        self.format_chosen.emit(self.formats.itemData(index))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        for place, title in enumerate(self._titles):
            self.formats.setItemText(place, shown(title))
        self.formats.setAccessibleName(self.tr("Export format"))
        self.name.setAccessibleName(self.tr("File of the export"))
        self.button.setText(self.tr("Export"))
