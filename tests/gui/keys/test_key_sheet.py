"""The sheet of keys tells what the window really answers to, and nothing else."""

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QWidget
from pytestqt.qtbot import QtBot

from core.errors import Severity
from gui.app import TABS
from gui.keys.own_keys import own_keys
from gui.keys.sheet import KeySheet, sheet_of
from gui.keys.showing import FILE
from gui.rig.dial_view import Dial
from gui.widgets.banner import Banner
from gui.widgets.distance_view import DistanceView
from gui.widgets.matrix_view import MatrixView
from gui.widgets.plot import Plot
from gui.widgets.states import BannerState, MatrixState, StepState
from gui.widgets.step_list import StepList
from gui.widgets.strip_canvas import StripCanvas
from tests.gui.window_driver import Driver

DIGITS = ["1", "2", "3", "4", "5", "6", "7", "8", "9"]


@pytest.fixture
def operator(open_app: Callable[[], Driver]) -> Driver:
    driver = open_app()
    driver.app.open_simulated("sim://pointer?speed=20&seed=3&name=keys")
    driver.until(lambda: driver.tab.bench.linked)
    methods = driver.app.tabs["Methods"].widget.list
    for row in range(methods.count()):
        methods.setCurrentRow(row)
    return driver


def sheet(operator: Driver) -> KeySheet:
    return sheet_of(operator.app.window, operator.app.window.tabs)


def test_every_tab_and_the_whole_window_stand_on_the_sheet(operator: Driver):
    groups = {
        title: {line.keys for line in group.lines}
        for group in sheet(operator).groups
        for title in group.title.split(", ")
    }
    assert {"Everywhere", *TABS} <= set(groups)
    assert {"F1", "F10", "F11", "Ctrl+1", "Ctrl+Tab", "Ctrl+D", "Ctrl+L"} <= groups["Everywhere"]
    for title in ("Dividing head", "Rate table", "Accuracy"):
        wanted = {"Space", "Backspace", "Del", "Ctrl+Z", "Esc", "F5", "Ctrl+O", "Ctrl+E", "Ctrl+H"}
        assert wanted <= groups[title]
    assert "Ctrl+H" not in groups["Archive"]


def test_every_shortcut_of_the_window_stands_on_the_sheet(operator: Driver):
    lines = [line for group in sheet(operator).groups for line in group.lines]
    told = {key for line in lines for key in line.keys.split()}
    own = own_keys()
    for shortcut in operator.app.window.findChildren(QShortcut):
        if shortcut.key().isEmpty() or not shortcut.isEnabled():
            continue
        key = shortcut.key().toString(QKeySequence.SequenceFormat.NativeText)
        parent = shortcut.parent()
        by_itself = {
            one
            for kind in type(parent).__mro__
            for keys, _ in own.get(kind.__name__, ("", ()))[1]
            for one in keys.split()
        }
        copying = key == "Ctrl+C"  # the system's own
        assert isinstance(parent, QAbstractButton) or key in by_itself or copying, (parent, key)
        assert key in told or copying


def test_every_widget_that_answers_keys_has_its_lines(operator: Driver):
    own = own_keys()
    for widget in operator.app.window.findChildren(QWidget):
        for kind in type(widget).__mro__:
            answers = "keyPressEvent" in kind.__dict__ and kind.__module__.startswith("gui.")
            assert not answers or kind.__name__ in own, kind


def pressed(keys: str) -> Iterator[tuple[Qt.Key, Qt.KeyboardModifier]]:
    for one in DIGITS if "…" in keys else keys.split():
        combination = QKeySequence(one)[0]
        yield combination.key(), combination.keyboardModifiers()


def a_matrix() -> MatrixView:
    matrix = MatrixView()
    matrix.render(MatrixState("K =", ((("1", ""),),)))
    return matrix


def a_message() -> Banner:
    banner = Banner()
    banner.render(BannerState(Severity.INFO, "Exported"))
    return banner


WIDGETS: dict[str, Callable[[], QWidget]] = {
    "Dial": Dial,
    "StepList": StepList,
    "StripCanvas": StripCanvas,
    "Plot": Plot,
    "MatrixView": a_matrix,
    "Banner": a_message,
    "DistanceView": DistanceView,
}
"""Those of Allan and Drift need records, and are pressed in the tests of their tabs."""


@pytest.mark.parametrize("name", WIDGETS)
def test_every_key_of_a_widget_is_answered(qtbot: QtBot, name: str):
    widget = WIDGETS[name]()
    qtbot.addWidget(widget)
    if isinstance(widget, StepList):
        widget.render([StepState(str(place)) for place in range(9)])
    for keys, _ in own_keys()[name][1]:
        for key, modifiers in pressed(keys):
            event = QKeyEvent(QEvent.Type.KeyPress, key, modifiers)
            widget.keyPressEvent(event)
            assert event.isAccepted(), keys


def test_the_sheet_is_searched_and_saved(operator: Driver, tmp_path: Path):
    operator.key(Qt.Key.Key_F1)
    view = operator.app.guidance.keys.view
    operator.until(view.isVisible)
    assert not view.isModal()
    operator.bot.keyClicks(view._find, "hands")
    texts = {label.text() for label in view._scroll.widget().findChildren(QLabel)}
    assert "Ctrl+H" in texts
    assert "F11" not in texts
    operator.click(view._print)
    assert (tmp_path / "data" / FILE).read_bytes().startswith(b"%PDF")
    operator.bot.keyClick(view, Qt.Key.Key_Escape)
    assert not view.isVisible()


def test_no_key_has_two_meanings_in_a_tab(operator: Driver):
    window = operator.app.window
    always = Counter(
        action.shortcut().toString()
        for action in window.findChildren(QAction)
        if action.associatedObjects()
        and not action.shortcut().isEmpty()
        and action.shortcutContext() is Qt.ShortcutContext.WindowShortcut
    )
    assert max(always.values()) == 1, always
    for place in range(window.tabs.count()):
        window.tabs.setCurrentIndex(place)
        QApplication.processEvents()
        page = window.tabs.currentWidget()
        here = Counter(
            shortcut.key().toString()
            for shortcut in window.findChildren(QShortcut)
            if not shortcut.key().isEmpty()
            and shortcut.isEnabled()
            and shortcut.context() is Qt.ShortcutContext.WindowShortcut
            and shortcut.parent().isVisible()
            and (page.isAncestorOf(shortcut.parent()) or shortcut.parent() is page)
        )
        both = here + always
        twice = {key for key, times in both.items() if times > 1}
        assert not twice, (window.tabs.tabText(place), twice)
