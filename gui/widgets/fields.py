"""Fields for settings that an operator cannot change by accident.

Space in them is the default action of the tab, as everywhere; turning the wheel over one that is
not in use scrolls the page and leaves the value alone.
"""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QHelpEvent, QKeyEvent, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import (
    QComboBox,
    QDoubleSpinBox,
    QStyle,
    QStyleOptionComboBox,
    QStylePainter,
    QToolTip,
    QWidget,
)


class NumberField(QDoubleSpinBox):
    """A number with a unit; typing is taken over when the field is left or Enter is pressed."""

    def __init__(
        self,
        low: float,
        high: float,
        decimals: int = 0,
        unit: str = "",
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setDecimals(decimals)
        self.setRange(low, high)
        self.setSuffix(f" {unit}" if unit else "")
        self.setGroupSeparatorShown(False)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # The style sheet's padding does not reach the line within a spin box.
        self.lineEdit().setTextMargins(self.fontMetrics().height() // 4, 0, 0, 0)

    def validate(self, text: str, place: int) -> object:
        return super().validate(self._with_mark(text), place)

    def valueFromText(self, text: str) -> float:
        return super().valueFromText(self._with_mark(text))

    def _with_mark(self, text: str) -> str:
        """Point and comma are both decimal marks, in every language."""
        return text.replace(",", ".").replace(".", self.locale().decimalPoint())

    def event(self, event: QEvent) -> bool:
        if _is_space(event):
            event.ignore()
            return False
        return super().event(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class ChoiceField(QComboBox):
    """A list to choose from; words that it has no room for end in dots and are its tool tip."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def is_cut(self) -> bool:
        """Whether the chosen words need more room than there is."""
        return self.fontMetrics().horizontalAdvance(self.currentText()) > self.room()

    def room(self) -> int:
        """Pixels that there are for the words."""
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        part = QStyle.SubControl.SC_ComboBoxEditField
        field = self.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, part, self)
        return field.width()

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and not self.toolTip() and self.is_cut():
            QToolTip.showText(event.globalPos(), self.currentText(), self)
            return True
        return super().event(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.isEditable() or not self.is_cut():
            super().paintEvent(event)
            return
        painter = QStylePainter(self)
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        option.currentText = self.fontMetrics().elidedText(
            self.currentText(), Qt.TextElideMode.ElideRight, self.room()
        )
        painter.drawComplexControl(QStyle.ComplexControl.CC_ComboBox, option)
        painter.drawControl(QStyle.ControlElement.CE_ComboBoxLabel, option)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


def _is_space(event: QEvent) -> bool:
    """Whether Qt asks if the field wants the Space key for itself."""
    return (
        event.type() == QEvent.Type.ShortcutOverride
        and isinstance(event, QKeyEvent)
        and event.key() == Qt.Key.Key_Space
    )
