"""Words that have less room on the screen than they need."""

from collections.abc import Iterator

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QTextDocument
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QScrollArea,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QTableView,
    QWidget,
)

from gui.widgets.fields import ChoiceField

_LEAST_CHOICE = 80
"""Pixels of a shortened choice that have to be seen at least."""


def cut_words(window: QWidget) -> Iterator[str]:
    """Yield what of a window cannot be read to its end, each with its place and its lack of room.

    A heading or a name that is shortened on purpose has a tool tip with all of it.
    """
    for widget in window.findChildren(QWidget):
        if not widget.isVisible():
            continue
        for text, needed, given in _lines(widget):
            if needed > given + 1 and not _told(text, widget.toolTip()):
                yield f"{_path(widget)}: {text!r} needs {needed} px and has {given}"
        if _has_words(widget) and (hidden := _hidden(widget)):
            yield f"{_path(widget)}: {hidden} px lie outside of what holds it"


def _told(text: str, tip: str) -> bool:
    return bool(tip) and (text in tip or tip in text)


def _lines(widget: QWidget) -> Iterator[tuple[str, int, int]]:
    """Texts of a widget, with the pixels that they need and have."""
    for kind, lines in _LINES:
        if isinstance(widget, kind):
            yield from lines(widget)
            return


def _button(button: QAbstractButton) -> Iterator[tuple[str, int, int]]:
    if button.text():
        needed = min(button.sizeHint().width(), button.minimumSizeHint().width())
        yield button.text(), needed, button.width()


def _box(box: QGroupBox) -> Iterator[tuple[str, int, int]]:
    yield box.title(), box.minimumSizeHint().width(), box.width()


def _tabs(bar: QTabBar) -> Iterator[tuple[str, int, int]]:
    for place in range(bar.count()):
        if bar.isTabVisible(place):
            needed = bar.fontMetrics().horizontalAdvance(bar.tabText(place).replace("&", ""))
            yield bar.tabText(place), needed, bar.tabRect(place).width()


def _number(line: QLineEdit) -> Iterator[tuple[str, int, int]]:
    if isinstance(line.parentWidget(), QAbstractSpinBox):
        margins = line.textMargins()
        # Qt keeps two pixels at both sides of what is typed.
        needed = line.fontMetrics().horizontalAdvance(line.text()) + 4
        yield line.text(), needed, line.width() - margins.left() - margins.right()


def _label(label: QLabel) -> Iterator[tuple[str, int, int]]:
    if not label.text() or label.pixmap():
        return
    if label.wordWrap():
        yield f"{label.text()} (height)", label.heightForWidth(label.width()), label.height()
        yield label.text(), _longest_word(label), label.width()
    else:
        yield label.text(), label.sizeHint().width(), label.width()


def _longest_word(label: QLabel) -> int:
    document = QTextDocument()
    document.setHtml(label.text())
    words = document.toPlainText().split() or [""]
    return max(label.fontMetrics().horizontalAdvance(word) for word in words)


def _sections(header: QHeaderView) -> Iterator[tuple[str, int, int]]:
    model = header.model()
    if model is None or header.orientation() is not Qt.Orientation.Horizontal:
        return
    for column in range(header.count()):
        if header.isSectionHidden(column):
            continue
        text = str(model.headerData(column, header.orientation()) or "")
        told = str(
            model.headerData(column, header.orientation(), Qt.ItemDataRole.ToolTipRole) or ""
        )
        if text and text not in told:
            needed = header.sectionSizeFromContents(column).width()
            yield text, needed, header.sectionSize(column)


def _table(table: QTableView) -> Iterator[tuple[str, int, int]]:
    off = table.horizontalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAlwaysOff
    if off and not isinstance(table.parentWidget(), QTableView):
        yield "all columns", table.horizontalHeader().length(), table.viewport().width()


def _choice(combo: QComboBox) -> Iterator[tuple[str, int, int]]:
    option = QStyleOptionComboBox()
    combo.initStyleOption(option)
    field = combo.style().subControlRect(
        QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, combo
    )
    needed = combo.fontMetrics().horizontalAdvance(combo.currentText())
    # Such a field shortens its words and tells them by its tool tip.
    least = min(needed, _LEAST_CHOICE) if isinstance(combo, ChoiceField) else needed
    yield combo.currentText(), least, field.width()


_LINES = (
    (QLabel, _label),
    (QAbstractButton, _button),
    (QGroupBox, _box),
    (QHeaderView, _sections),
    (QTableView, _table),
    (QTabBar, _tabs),
    (QComboBox, _choice),
    (QLineEdit, _number),
)


def _has_words(widget: QWidget) -> bool:
    return isinstance(widget, QLabel | QAbstractButton | QComboBox | QAbstractSpinBox)


def _hidden(widget: QWidget) -> int:
    """Pixels of its width that a parent cuts off and no scroll bar can bring back."""
    parent = widget.parentWidget()
    while parent is not None and not widget.isWindow():
        place = QRect(widget.mapTo(parent, QPoint()), widget.size())
        area = parent.parentWidget()
        if isinstance(area, QScrollArea) and parent is area.viewport():
            if area.horizontalScrollBar().maximum() > 0 and area.horizontalScrollBar().isVisible():
                return 0
            return max(0, place.right() - parent.width() + 1, -place.left())
        if parent.isWindow():
            return max(0, place.right() - parent.width() + 1, -place.left())
        hidden = max(0, place.right() - parent.width() + 1, -place.left())
        if hidden:
            return hidden
        parent = parent.parentWidget()
    return 0


def _path(widget: QWidget) -> str:
    names: list[str] = []
    one: QWidget | None = widget
    while one is not None and not one.isWindow():
        name = type(one).__name__
        if not name.startswith("Q") or one is widget:
            names.append(name)
        one = one.parentWidget()
    return " < ".join(names[:4])
