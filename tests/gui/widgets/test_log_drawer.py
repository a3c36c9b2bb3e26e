from datetime import UTC, datetime

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from core.errors import Severity
from gui.widgets.log_drawer import KEPT, LogDrawer
from gui.widgets.states import LogEntry

AT = datetime(2025, 11, 22, 12, 4, 11, tzinfo=UTC)


@pytest.fixture
def drawer(qtbot):
    widget = LogDrawer()
    qtbot.addWidget(widget)
    widget.resize(600, 300)
    widget.show()
    return widget


def test_newest_is_in_the_line_and_on_top(drawer):
    drawer.append(LogEntry(AT, Severity.INFO, "Connected.", "link"))
    drawer.append(LogEntry(AT, Severity.ERROR, "COM4 vanished.", "link"))
    assert drawer._newest.text() == "12:04:11  COM4 vanished."
    model = drawer._model
    assert [model.index(row, 2).data() for row in range(2)] == ["COM4 vanished.", "Connected."]
    words = model.index(0, 0).data(Qt.ItemDataRole.AccessibleTextRole)
    assert words.startswith("error, 12:04:11")
    assert not model.index(0, 0).data(Qt.ItemDataRole.DecorationRole).isNull()


def test_opens_and_closes_by_key(drawer, qtbot):
    with qtbot.waitActive(drawer):
        drawer.activateWindow()
    assert not drawer._table.isVisible()
    with qtbot.waitSignal(drawer.toggled) as told:
        qtbot.keyClick(drawer, Qt.Key.Key_L, Qt.KeyboardModifier.ControlModifier)
    assert told.args == [True]
    assert drawer._table.isVisible()
    drawer.set_open(False)
    assert not drawer._table.isVisible()


def test_copy(drawer, qtbot):
    drawer.append(LogEntry(AT, Severity.WARNING, "Lost 3 samples.", "link"))
    drawer.set_open(True)
    qtbot.keyClick(drawer._table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QGuiApplication.clipboard().text() == (
        "2025-11-22T12:04:11.000+00:00\twarning\tlink\tLost 3 samples."
    )


def test_keeps_a_bounded_number(drawer):
    for number in range(KEPT + 5):
        drawer.append(LogEntry(AT, Severity.INFO, str(number)))
    assert drawer._model.rowCount() == KEPT
    assert drawer._model.index(KEPT - 1, 2).data() == "5"
