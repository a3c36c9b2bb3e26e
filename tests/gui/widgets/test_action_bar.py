from itertools import pairwise

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QLineEdit, QTabWidget, QVBoxLayout, QWidget

from gui.widgets.action_bar import ActionBar
from gui.widgets.states import ActionBarState, measuring_actions

ALL = ("accumulate", "repeat", "discard", "load", "process", "export")


class Window(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.text = QLineEdit()
        self.check = QCheckBox("Termo calibration")
        self.bar = ActionBar()
        self.pressed: list[str] = []
        self.bar.triggered.connect(self.pressed.append)
        layout = QVBoxLayout(self)
        for part in (self.text, self.check, self.bar):
            layout.addWidget(part)


@pytest.fixture
def window(qtbot):
    widget = Window()
    qtbot.addWidget(widget)
    widget.resize(1400, 200)
    widget.bar.render(ActionBarState(measuring_actions(ALL), hands_free=False))
    with qtbot.waitActive(widget):
        widget.show()
        widget.activateWindow()
    return widget


def press(qtbot, window, key, modifier=Qt.KeyboardModifier.NoModifier):
    qtbot.keyClick(window.focusWidget() or window, key, modifier)


def test_words_of_the_old_programs(window):
    assert [window.bar.button(key).text() for key in ALL] == [
        "Accumulate Data",
        "Repeat",
        "Discard",
        "Load Data",
        "Process Data",
        "Export",
    ]


def test_keys(window, qtbot):
    control = Qt.KeyboardModifier.ControlModifier
    window.bar.setFocus()
    press(qtbot, window, Qt.Key.Key_Space)
    press(qtbot, window, Qt.Key.Key_Backspace)
    press(qtbot, window, Qt.Key.Key_Delete)
    press(qtbot, window, Qt.Key.Key_O, control)
    press(qtbot, window, Qt.Key.Key_F5)
    press(qtbot, window, Qt.Key.Key_E, control)
    assert window.pressed == list(ALL)


def test_space_stays_the_default_after_the_mouse(window, qtbot):
    window.bar.setFocus()
    qtbot.mouseClick(window.bar.button("repeat"), Qt.MouseButton.LeftButton)
    press(qtbot, window, Qt.Key.Key_Space)
    qtbot.mouseClick(window.check, Qt.MouseButton.LeftButton, pos=window.check.rect().center())
    checked = window.check.isChecked()
    press(qtbot, window, Qt.Key.Key_Space)
    assert window.check.isChecked() == checked
    assert window.pressed == ["repeat", "accumulate", "accumulate"]


def test_space_presses_what_was_walked_to_with_tab(window, qtbot):
    window.text.setFocus()
    press(qtbot, window, Qt.Key.Key_Tab)
    assert window.check.hasFocus()
    press(qtbot, window, Qt.Key.Key_Space)
    assert window.check.isChecked()
    assert window.pressed == []


def test_space_in_a_text_field_is_text(window, qtbot):
    window.text.setFocus()
    press(qtbot, window, Qt.Key.Key_Space)
    assert window.text.text() == " "
    assert window.pressed == []


def test_a_running_measurement_is_ended_by_escape_and_never_by_space(window, qtbot):
    items = measuring_actions(("load",), running=True, why_not="measuring")
    window.bar.render(ActionBarState(items, hands_free=False))
    window.bar.setFocus()
    press(qtbot, window, Qt.Key.Key_Space)
    press(qtbot, window, Qt.Key.Key_Backspace)
    assert window.pressed == []
    press(qtbot, window, Qt.Key.Key_Escape)
    assert window.pressed == ["stop"]
    assert "measuring" in window.bar.button("repeat").toolTip()


def test_same_place_whatever_runs(window):
    before = window.bar.button("accumulate").geometry().left()
    window.bar.render(ActionBarState(measuring_actions((), running=True)))
    window.bar.layout().activate()
    assert window.bar.button("stop").geometry().left() == before


def test_hands_free(window, qtbot):
    with qtbot.waitSignal(window.bar.hands_free_toggled) as told:
        press(qtbot, window, Qt.Key.Key_H, Qt.KeyboardModifier.ControlModifier)
    assert told.args == [True]
    window.bar.render(ActionBarState(measuring_actions(ALL), hands_free=None))
    assert not window.bar._hands_free.isVisible()


def test_key_hints_give_way_when_it_is_narrow(window, qtbot):
    assert window.bar.button("accumulate")._hint_shown
    window.resize(window.minimumSizeHint())
    qtbot.waitUntil(lambda: not window.bar.button("accumulate")._hint_shown)
    row = [window.bar.button(key).geometry() for key in ALL]
    assert all(a.right() < b.left() for a, b in pairwise(row))


def test_only_the_visible_tab_hears_the_key(qtbot):
    tabs = QTabWidget()
    qtbot.addWidget(tabs)
    bars = [ActionBar(), ActionBar()]
    heard = []
    for number, bar in enumerate(bars):
        bar.render(ActionBarState(measuring_actions(ALL)))
        bar.triggered.connect(lambda key, number=number: heard.append((number, key)))
        tabs.addTab(bar, str(number))
    with qtbot.waitActive(tabs):
        tabs.show()
        tabs.activateWindow()
    qtbot.keyClick(tabs, Qt.Key.Key_Space)
    tabs.setCurrentIndex(1)
    qtbot.keyClick(tabs, Qt.Key.Key_Space)
    assert heard == [(0, "accumulate"), (1, "accumulate")]


def test_accessible_names(window):
    for key in ALL:
        assert window.bar.button(key).accessibleName() == window.bar.button(key).text()
