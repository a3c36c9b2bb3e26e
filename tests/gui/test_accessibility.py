"""What a screen reader tells, what no dialog may interrupt, what must fit the screen."""

import ast
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)

from tests.gui.window_driver import Driver

ROOT = Path(__file__).parents[2]
ASKED = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
)
MODAL = {
    "exec",
    "getOpenFileName",
    "getOpenFileNames",
    "getSaveFileName",
    "getExistingDirectory",
    "getText",
    "getItem",
    "QMessageBox",
    "QInputDialog",
    "setModal",
}


def labelled(widget: QWidget) -> bool:
    """Whether a label is its buddy."""
    parent = widget.parentWidget()
    while parent is not None:
        if any(label.buddy() is widget for label in parent.findChildren(QLabel)):
            return True
        parent = parent.parentWidget()
    return False


def told(widget: QWidget) -> str:
    """What a screen reader has to say of a widget."""
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return widget.accessibleName() or text or ("label" if labelled(widget) else "")


def owned_by_qt(widget: QWidget) -> bool:
    """Parts within a combined widget, of which only the whole is walked to."""
    parent = widget.parentWidget()
    name = widget.objectName()
    return (
        name.startswith("qt_")
        or isinstance(parent, QAbstractSpinBox | QComboBox)
        or (parent is not None and "QComboBoxPrivate" in parent.metaObject().className())
        or widget.metaObject().className() in ("QTableCornerButton", "QHeaderView")
        or name in ("ScrollLeftButton", "ScrollRightButton")
        or type(parent).__name__ in ("QTabBar", "QDockWidget", "QLineEdit", "QFileDialog")
        or widget.metaObject().className().startswith("QDockWidget")
    )


def test_everything_that_can_be_walked_to_has_a_name(open_app: Callable[[], Driver]):
    app = open_app().app
    app.open_simulated("pointer")
    window = app.window
    methods = app.tabs["Methods"].widget.list
    for place in range(window.tabs.count()):
        window.tabs.setCurrentIndex(place)
        QApplication.processEvents()
    for row in range(methods.count()):
        methods.setCurrentRow(row)
    nameless = {
        (type(widget).__module__, type(widget).__name__, path(widget))
        for widget in window.findChildren(QWidget)
        if isinstance(widget, ASKED)
        and widget.focusPolicy() is not Qt.FocusPolicy.NoFocus
        and not owned_by_qt(widget)
        and not told(widget)
    }
    assert not nameless, "\n".join(map(str, sorted(nameless)))


def path(widget: QWidget) -> str:
    names = []
    parent = widget.parentWidget()
    while parent is not None and len(names) < 4:
        if type(parent).__module__.startswith("gui."):
            names.append(type(parent).__name__)
        parent = parent.parentWidget()
    return " < ".join(names)


def test_no_dialog_holds_the_window_up():
    """Every call that would open a modal dialog; `setModal(False)` says that one is not."""
    found = []
    for file in sorted((ROOT / "gui").rglob("*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            name = _called(node)
            if name not in MODAL:
                continue
            assert isinstance(node, ast.Call)
            no_modal = name == "setModal" and getattr(node.args[0], "value", None) is False
            main_loop = name == "exec" and file.name == "app.py"
            if not no_modal and not main_loop:
                found.append(f"{file.relative_to(ROOT)}:{node.lineno} {name}")
    assert not found


def _called(node: ast.AST) -> str:
    if not isinstance(node, ast.Call):
        return ""
    function = node.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


@pytest.mark.parametrize("size", [QSize(1280, 800), QSize(1920, 1080)])
def test_buttons_and_names_of_fields_are_not_cut(open_app: Callable[[], Driver], size: QSize):
    app = open_app().app
    app.open_simulated("pointer")
    window = app.window
    window.resize(size)
    cut = set()
    for place in range(window.tabs.count()):
        window.tabs.setCurrentIndex(place)
        for _ in range(3):
            QApplication.processEvents()
        for widget in window.findChildren(QAbstractButton):
            if not widget.isVisible() or not widget.text() or owned_by_qt(widget):
                continue
            needed = widget.fontMetrics().horizontalAdvance(widget.text())
            if widget.width() < needed:
                cut.add((window.tabs.tabText(place), widget.text(), widget.width(), needed))
            corner = widget.mapTo(window, QPoint(widget.width(), 0))
            if corner.x() > window.width():
                cut.add((window.tabs.tabText(place), widget.text(), "outside", corner.x()))
    assert not cut
    assert window.width() == size.width(), "a tab is wider than the screen"


def test_all_tabs_are_reached_by_keys(open_app: Callable[[], Driver]):
    operator = open_app()
    tabs = operator.app.window.tabs
    control = Qt.KeyboardModifier.ControlModifier
    for place in range(min(9, tabs.count())):
        operator.key(Qt.Key(Qt.Key.Key_1 + place), control)
        assert tabs.currentIndex() == place
    operator.key(Qt.Key.Key_0, control)
    assert tabs.currentIndex() == 9
    operator.key(Qt.Key.Key_1, control)
    for place in range(1, tabs.count()):
        operator.key(Qt.Key.Key_Tab, control)
        assert tabs.currentIndex() == place
    operator.key(Qt.Key.Key_Tab, control)
    assert tabs.currentIndex() == 0
