"""The form of one number of a board."""

from PySide6.QtCore import QEvent, QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QLineEdit, QPushButton, QWidget

from gui.frames.presenter import FramesPresenter
from gui.frames.state import FieldRow, FramesState
from gui.frames.texts import TYPE_WORDS
from gui.widgets.fields import ChoiceField

ROLES = (
    "", "acc.x", "acc.y", "acc.z", "rate.x", "rate.y", "rate.z", "mag.x", "mag.y", "mag.z", "temp",
    "counter", "time", "status", "adc.1", "adc.2", "adc.3", "angle.heading", "angle.pitch",
    "angle.roll",
)  # fmt: skip
UNITS = ("code", "m/s^2", "deg/s", "degC", "V", "deg", "uT", "s", "ms")

_NONE = FieldRow("", "", "", "", "", "", 1.0, 0.0, hide=False)


class FieldForm(QWidget):
    """Name, type, byte order, scale, unit and role; buttons to add and to take away."""

    def __init__(self, presenter: FramesPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._labels = {
            key: QLabel() for key in ("name", "type", "scale", "offset", "unit", "role")
        }
        self.name, self.scale, self.offset = QLineEdit(), QLineEdit(), QLineEdit()
        self.type, self.endian = ChoiceField(), ChoiceField()
        self.unit, self.role = ChoiceField(), ChoiceField()
        self.hidden = QCheckBox()
        self.add, self.remove = QPushButton(), QPushButton()
        for key, text in TYPE_WORDS.items():
            self.type.addItem(text, key)
        self.endian.addItem("", "little")
        self.endian.addItem("", "big")
        for box, entries in ((self.unit, UNITS), (self.role, ROLES)):
            box.setEditable(True)
            box.addItems(entries)
        self._build()
        self._retranslate()
        self.name.editingFinished.connect(self._on_name)
        for box in (self.unit, self.role):
            box.activated.connect(self._on_name)
            line = box.lineEdit()
            if line is not None:
                line.editingFinished.connect(self._on_name)
        self.type.activated.connect(self._on_type)
        self.endian.activated.connect(self._on_type)
        self.scale.editingFinished.connect(self._on_scale)
        self.offset.editingFinished.connect(self._on_scale)
        self.hidden.toggled.connect(self._on_hidden)
        self.add.clicked.connect(presenter.add_selected)
        self.remove.clicked.connect(presenter.remove_selected)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, unit // 2)
        grid.setHorizontalSpacing(unit // 2)
        grid.setVerticalSpacing(unit // 3)
        placed: tuple[tuple[QWidget, ...], ...] = (
            (self._labels["name"], self.name, self._labels["type"], self.type, self.endian),
            (self._labels["scale"], self.scale, self._labels["offset"], self.offset, self.hidden),
            (self._labels["unit"], self.unit, self._labels["role"], self.role, self.add),
        )
        for row, widgets in enumerate(placed):
            for column, widget in enumerate(widgets):
                grid.addWidget(widget, row, column)
        grid.addWidget(self.remove, 3, 4)
        for column in (1, 3):
            grid.setColumnStretch(column, 1)

    def render(self, state: FramesState) -> None:
        """Show the number that is being edited."""
        row = state.fields[state.field] if 0 <= state.field < len(state.fields) else None
        binary = state.binary and row is not None
        for widget in (self.name, self.scale, self.offset, self.unit, self.role):
            widget.setEnabled(row is not None)
        for widget in (self.type, self.endian, self.hidden):
            widget.setEnabled(binary)
        self.add.setEnabled(state.binary and state.selection is not None and state.length > 0)
        self.remove.setEnabled(state.binary and state.selection is not None)
        self._fill(row or _NONE)

    def _fill(self, row: FieldRow) -> None:
        for line, text in (
            (self.name, row.name),
            (self.scale, f"{row.scale:.12g}" if row.name else ""),
            (self.offset, f"{row.offset:.12g}" if row.name else ""),
        ):
            if not (line.hasFocus() and line.isModified()):
                line.setText(text)
        for box, text in ((self.unit, row.unit), (self.role, row.role)):
            line = box.lineEdit()
            if line is None or not (line.hasFocus() and line.isModified()):
                box.setCurrentText(text)
        with QSignalBlocker(self.hidden):
            self.hidden.setChecked(row.hide)
        self.type.setCurrentIndex(self.type.findData(row.type))
        self.endian.setCurrentIndex(self.endian.findData(row.endian))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        words = {
            "name": self.tr("Name"),
            "type": self.tr("Type"),
            "scale": self.tr("Scale"),
            "offset": self.tr("Offset"),
            "unit": self.tr("Unit"),
            "role": self.tr("Role"),
        }
        for key, word in words.items():
            self._labels[key].setText(word)
            getattr(self, key).setAccessibleName(word)
            self._labels[key].setBuddy(getattr(self, key))
        self.endian.setItemText(0, self.tr("little endian"))
        self.endian.setItemText(1, self.tr("big endian"))
        self.endian.setAccessibleName(self.tr("Byte order"))
        self.scale.setToolTip(self.tr("A number or an expression, such as 20*9.80665/65536"))
        self.role.setToolTip(
            self.tr("Tells the program what it measures: acc in m/s^2, rate in deg/s, temp in degC")
        )
        self.hidden.setText(self.tr("No channel"))
        self.add.setText(self.tr("Add field"))
        self.add.setToolTip(self.tr("Makes numbers of the bytes pointed at (Enter)"))
        self.remove.setText(self.tr("Remove field"))
        self.remove.setToolTip(self.tr("Takes away the fields on the bytes pointed at (Delete)"))

    @property
    def _index(self) -> int:
        state = self._presenter.state
        return state.field if 0 <= state.field < len(state.fields) else -1

    def _on_name(self) -> None:
        if (index := self._index) >= 0:
            row = self._presenter.state.fields[index]
            words = (self.name.text().strip(), self.unit.currentText(), self.role.currentText())
            self._settle(self.name)
            if words != (row.name, row.unit, row.role):
                self._presenter.rename(index, *words)

    def _on_type(self) -> None:
        if (index := self._index) >= 0:
            self._presenter.retype(index, self.type.currentData(), self.endian.currentData())

    def _on_scale(self) -> None:
        if (index := self._index) >= 0 and (self.scale.isModified() or self.offset.isModified()):
            self._settle(self.scale, self.offset)
            self._presenter.rescale(index, self.scale.text(), self.offset.text())

    def _on_hidden(self, hidden: bool) -> None:
        if (index := self._index) >= 0:
            self._presenter.hide(index, hidden)

    @staticmethod
    def _settle(*lines: QLineEdit) -> None:
        for line in lines:
            line.setModified(False)
