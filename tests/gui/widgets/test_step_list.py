import pytest
from PySide6.QtCore import QPoint, Qt

from gui.widgets.states import Pose, StepMark, StepState
from gui.widgets.step_list import StepList


def plan(now=1, count=8):
    marks = [StepMark.DONE if row < now else StepMark.TO_COME for row in range(count)]
    marks[now] = StepMark.NOW
    return tuple(
        StepState(f"{row + 1}  {90 * row}°", mark, Pose("X_from", 90 * row), group="X from ODH")
        for row, mark in enumerate(marks)
    )


@pytest.fixture
def steps(qtbot):
    widget = StepList()
    qtbot.addWidget(widget)
    widget.resize(320, 400)
    widget.show()
    widget.render(plan())
    return widget


def test_current_step_is_shown(steps):
    assert steps.currentIndex().row() == 1
    steps.render(plan(7))
    assert steps.currentIndex().row() == 7
    assert steps.visualRect(steps.currentIndex()).bottom() <= steps.viewport().height()


def test_looking_around_is_not_undone_by_a_new_value(steps, qtbot):
    qtbot.keyClick(steps, Qt.Key.Key_Down)
    assert steps.currentIndex().row() == 2
    changed = list(plan())
    changed[0] = StepState("1  0°", StepMark.DONE, Pose("X_from", 0), "12.3", group="X from ODH")
    steps.render(changed)
    assert steps.currentIndex().row() == 2


def test_click_enter_and_digit_choose(steps, qtbot):
    chosen = []
    steps.chosen.connect(chosen.append)
    place = steps.visualRect(steps.model().index(2, 0)).center()
    qtbot.mouseClick(steps.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.keyClick(steps, Qt.Key.Key_Down)
    qtbot.keyClick(steps, Qt.Key.Key_Return)
    qtbot.keyClick(steps, Qt.Key.Key_1)
    qtbot.keyClick(steps, Qt.Key.Key_9)
    assert chosen == [2, 3, 0]


def test_click_beside_the_rows_chooses_nothing(steps, qtbot):
    chosen = []
    steps.chosen.connect(chosen.append)
    steps.render(plan(0, 1))
    qtbot.mouseClick(steps.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(20, 380))
    assert chosen == []


def test_first_row_of_a_group_is_taller_by_its_heading(steps):
    first = steps.visualRect(steps.model().index(0, 0)).height()
    second = steps.visualRect(steps.model().index(1, 0)).height()
    assert first > second >= 64


def test_words_for_tool_tip_and_screen_reader(steps):
    index = steps.model().index(1, 0)
    assert "Y down" in index.data(Qt.ItemDataRole.ToolTipRole)
    assert "now" in index.data(Qt.ItemDataRole.AccessibleTextRole)


def test_rows_without_picture_are_drawn(steps):
    steps.render(
        [StepState(f"{rate} deg/s", mark) for rate, mark in zip((-100, 0), StepMark, strict=False)]
    )
    assert steps.model().rowCount() == 2
    assert not steps.grab().isNull()
    steps.render(())
    assert steps.model().rowCount() == 0
