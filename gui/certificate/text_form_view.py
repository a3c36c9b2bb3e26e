"""A form of texts: labels left, fields right, long ones as high as some lines."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QFormLayout, QLabel, QLineEdit, QPlainTextEdit, QWidget

_LINES = 3


class TextForm(QWidget):
    """Named texts.

    Parameters
    ----------
    names : of the fields, from above
    long : those that have several lines
    """

    edited = Signal()

    def __init__(
        self, names: Sequence[str], long: Sequence[str] = (), parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.fields: dict[str, QLineEdit | QPlainTextEdit] = {}
        self.labels: dict[str, QLabel] = {}
        self.form = QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.form.setVerticalSpacing(self.fontMetrics().height() // 3)
        for name in names:
            field = self._long() if name in long else QLineEdit()
            field.textChanged.connect(self.edited)
            self.fields[name] = field
            self.labels[name] = QLabel()
            self.labels[name].setBuddy(field)
            self.form.addRow(self.labels[name], field)

    def values(self) -> dict[str, str]:
        """What stands in the fields."""
        return {
            name: field.text() if isinstance(field, QLineEdit) else field.toPlainText()
            for name, field in self.fields.items()
        }

    def show_values(self, values: Mapping[str, str]) -> None:
        """Put texts into the fields; the cursor stays where it is in those that are right."""
        now = self.values()
        for name, field in self.fields.items():
            if now[name] == values[name]:
                continue
            blocker = QSignalBlocker(field)
            if isinstance(field, QLineEdit):
                field.setText(values[name])
                field.setCursorPosition(0)
            else:
                field.setPlainText(values[name])
            blocker.unblock()

    def set_read_only(self, on: bool) -> None:
        """Let nothing be typed."""
        for field in self.fields.values():
            field.setReadOnly(on)

    def set_words(self, labels: Mapping[str, str], hints: Mapping[str, str]) -> None:
        """Name the fields, and tell what goes into those that are empty."""
        for name, field in self.fields.items():
            self.labels[name].setText(labels[name])
            field.setAccessibleName(labels[name])
            field.setPlaceholderText(hints.get(name, ""))

    def _long(self) -> QPlainTextEdit:
        field = QPlainTextEdit()
        field.setTabChangesFocus(True)
        height = round((_LINES + 0.4) * field.fontMetrics().lineSpacing())
        # The sheet of the window gives all fields the height of one line.
        field.setStyleSheet(f"min-height: {height}px; max-height: {height}px")
        return field


def embolden(label: QLabel) -> None:
    """Make a label the heading of what stands below it."""
    font = label.font()
    font.setBold(True)
    label.setFont(font)
