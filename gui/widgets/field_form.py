"""Fields of a form, each behind its name."""

from collections.abc import Sequence

from PySide6.QtWidgets import QComboBox, QFormLayout, QLabel, QWidget

from gui.languages.anchors import beside


class FieldForm(QFormLayout):
    """Rows of a name and a field.

    Parameters
    ----------
    fields : from above
    """

    def __init__(self, fields: Sequence[QWidget]) -> None:
        super().__init__()
        unit = fields[0].fontMetrics().height()
        self.setVerticalSpacing(unit // 3)
        self._fields = tuple(fields)
        self._labels = tuple(QLabel() for _ in fields)
        for label, field in zip(self._labels, self._fields, strict=True):
            label.setBuddy(field)
            self.addRow(label, field)
            if not isinstance(field, QComboBox):
                # Their largest numbers, which nobody enters, would make the pane too wide.
                field.setMinimumWidth(6 * unit)

    def say(self, words: Sequence[tuple[str, str]]) -> None:
        """Write the names and their tool tips, in the order of the fields."""
        for label, field, (name, tip) in zip(self._labels, self._fields, words, strict=True):
            label.setText(name)
            label.setToolTip(beside(name, tip) if tip else "")
            field.setAccessibleName(name)
            field.setToolTip(tip)
