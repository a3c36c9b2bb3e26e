"""The first columns of a wide table stay while it is scrolled by the keyboard."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QTableView
from pytestqt.qtbot import QtBot

from gui.widgets.kept_columns import WideTable
from gui.widgets.result_table import ResultTable
from gui.widgets.states import TableState

COLUMNS = 9
WIDE = TableState(
    "Differences",
    "",
    ("channel", "parameter", *(f"number {n}" for n in range(COLUMNS - 2))),
    tuple(
        (f"acc_{axis}", "scale factor", *(f"{n}.{row:05d}" for n in range(COLUMNS - 2)))
        for row, axis in enumerate("xyz" * 4)
    ),
    words=2,
)


@pytest.fixture
def view(qtbot: QtBot) -> Iterator[WideTable]:
    table = ResultTable()
    qtbot.addWidget(table)
    table.render(WIDE)
    table.resize(430, 500)
    table.show()
    qtbot.waitExposed(table)
    (found,) = table.findChildren(WideTable)
    yield found
    table.hide()  # and so it is held until here


def kept(view: WideTable) -> QTableView:
    (found,) = [one for one in view.findChildren(QTableView) if one is not view]
    return found


def walk(view: WideTable, qtbot: QtBot, key: Qt.Key, times: int) -> None:
    for _ in range(times):
        qtbot.keyClick(view, key)


def test_the_last_column_is_reached_by_the_keyboard_and_the_names_stay(
    view: WideTable, qtbot: QtBot
) -> None:
    assert not kept(view).isVisible()
    view.setFocus()
    view.setCurrentIndex(view.model().index(1, 0))
    walk(view, qtbot, Qt.Key.Key_Right, COLUMNS - 1)
    assert view.currentIndex().column() == COLUMNS - 1
    assert view.visualRect(view.currentIndex()).right() <= view.viewport().width()
    assert kept(view).isVisible()
    shown = [not kept(view).isColumnHidden(column) for column in range(COLUMNS)]
    assert shown == [True, True] + [False] * (COLUMNS - 2)
    for column in (0, 1):
        assert kept(view).columnWidth(column) == view.columnWidth(column)
    assert kept(view).rowHeight(3) == view.rowHeight(3)
    assert kept(view).horizontalHeader().height() == view.horizontalHeader().height()


def test_on_the_way_back_no_cell_hides_below_the_names(view: WideTable, qtbot: QtBot) -> None:
    view.setFocus()
    view.setCurrentIndex(view.model().index(0, COLUMNS - 1))
    for column in range(COLUMNS - 2, 1, -1):
        walk(view, qtbot, Qt.Key.Key_Left, 1)
        assert view.currentIndex().column() == column
        assert view.visualRect(view.currentIndex()).left() >= view.kept_width
    walk(view, qtbot, Qt.Key.Key_Left, 2)
    assert view.currentIndex().column() == 0
    assert not kept(view).isVisible()


def test_a_click_on_a_name_that_stays_chooses_its_row(view: WideTable, qtbot: QtBot) -> None:
    view.horizontalScrollBar().setValue(view.horizontalScrollBar().maximum())
    spot = QPoint(10, view.visualRect(view.model().index(4, 0)).center().y())
    target = view.viewport().childAt(spot) or view.viewport()
    qtbot.mouseClick(target, Qt.MouseButton.LeftButton, pos=spot)
    assert {index.row() for index in view.selectionModel().selectedRows()} == {4}


def test_names_as_wide_as_the_table_leave_it_to_the_numbers(view: WideTable, qtbot: QtBot) -> None:
    view.window().resize(180, 500)
    qtbot.waitUntil(lambda: view.viewport().width() < 200)
    view.horizontalScrollBar().setValue(50)
    assert not kept(view).isVisible()


def test_another_table_in_its_place_keeps_its_own_columns(view: WideTable) -> None:
    table = view.parent()
    assert isinstance(table, ResultTable)
    view.horizontalScrollBar().setValue(60)
    narrow = TableState("", "", ("what", "a", "b"), (("mean", "1", "2"),), words=1)
    table.render(narrow)
    assert not kept(view).isVisible()
    assert [kept(view).isColumnHidden(column) for column in range(3)] == [False, True, True]
