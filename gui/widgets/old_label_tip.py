"""The English word of the old programs, as the tool tip of what has none of its own."""

from PySide6.QtCore import QPoint
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QTabBar,
    QToolTip,
    QWidget,
)

from gui.languages.anchors import old_label


def show_old_label(event: QHelpEvent) -> bool:
    """Show the old label of what lies under the mouse; False if there is none.

    Qt hands the request for a tool tip up to the window when nothing on the way has one.
    """
    widget = QApplication.widgetAt(event.globalPos())
    label = "" if widget is None else old_label_at(widget, event.globalPos())
    if label:
        QToolTip.showText(event.globalPos(), label, widget)
    return bool(label)


def old_label_at(widget: QWidget, place: QPoint) -> str:
    """The old label of a widget, or of its part at a place on the screen; empty for none."""
    return next((label for words in _words(widget, place) if (label := old_label(words))), "")


def _words(widget: QWidget, place: QPoint) -> list[str]:
    """What is written there; the lines of a heading each for itself."""
    if isinstance(widget, QLabel | QAbstractButton):
        return [widget.text()]
    if isinstance(widget, QGroupBox):
        return [widget.title()]
    if isinstance(widget, QComboBox):
        return [widget.currentText()]
    if isinstance(widget, QTabBar):
        return [widget.tabText(widget.tabAt(widget.mapFromGlobal(place)))]
    header = widget.parentWidget()
    if isinstance(header, QHeaderView) and header.model() is not None:
        column = header.logicalIndexAt(widget.mapFromGlobal(place))
        words = str(header.model().headerData(column, header.orientation()) or "")
        return [*words.split("\n")[::-1], words]
    return []
