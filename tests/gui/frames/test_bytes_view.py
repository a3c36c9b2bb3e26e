"""Columns of bytes are pointed at by mouse and keys."""

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from drivers.teach.rows import Part, SheetRow
from gui.frames.bytes_view import BytesView
from gui.frames.state import BytesState, Named

STATE = BytesState(
    tuple(SheetRow(bytes((0xAA, n, 65, 66, n)), whole=True) for n in range(100)),
    (
        Named(Part("sync", 0, 1), "header", -1),
        Named(Part("field", 1, 2), "n", 0),
        Named(Part("check", 4, 5), "check", -1),
    ),
    5,
)


@pytest.fixture
def view(qtbot: QtBot) -> BytesView:
    made = BytesView()
    qtbot.addWidget(made)
    made.resize(600, 300)
    made.render(STATE)
    made.show()
    return made


def middle(view: BytesView, column: int) -> QPoint:
    return QPoint(view._x(column) + view._cell // 2, 100)


def test_dragging_points_at_columns_either_way(view: BytesView, qtbot: QtBot):
    seen: list[tuple[int, int]] = []
    view.selected.connect(lambda first, stop: seen.append((first, stop)))
    left = Qt.MouseButton.LeftButton
    qtbot.mousePress(view.viewport(), left, pos=middle(view, 3))
    view._point(view.column_at(middle(view, 1).x()))
    qtbot.mouseRelease(view.viewport(), left, pos=middle(view, 1))
    assert seen == [(3, 4), (1, 4)]


def test_keys_move_widen_add_and_remove(view: BytesView, qtbot: QtBot):
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=middle(view, 1))
    qtbot.keyClick(view, Qt.Key.Key_Right)
    with qtbot.waitSignal(view.selected) as moved:
        qtbot.keyClick(view, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert moved.args == [2, 4]
    with qtbot.waitSignal(view.selected) as narrowed:
        qtbot.keyClick(view, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert narrowed.args == [2, 3]
    with qtbot.waitSignal(view.add_requested):
        qtbot.keyClick(view, Qt.Key.Key_Return)
    with qtbot.waitSignal(view.remove_requested):
        qtbot.keyClick(view, Qt.Key.Key_Delete)


def test_a_double_click_points_at_a_whole_part(view: BytesView, qtbot: QtBot):
    with qtbot.waitSignal(view.selected) as pointed:
        qtbot.mouseDClick(view.viewport(), Qt.MouseButton.LeftButton, pos=middle(view, 4))
    assert pointed.args == [4, 5]


def test_the_latest_rows_are_followed_until_scrolled_up(view: BytesView):
    bar = view.verticalScrollBar()
    assert bar.value() == bar.maximum() > 0
    bar.setValue(3)
    view.render(STATE)
    assert bar.value() == 3
    bar.setValue(bar.maximum())
    view.render(BytesState(STATE.rows * 2, STATE.parts, 5))
    assert bar.value() == bar.maximum()


def test_parts_differ_in_colour_and_garbage_has_none(view: BytesView):
    rest = BytesState((SheetRow(b"\x01\x02\x03\x04\x05", whole=False),), STATE.parts, 5)
    whole = view.grab().toImage()
    view.render(rest)
    bare = view.grab().toImage()
    y = int(3.5 * view._line)
    colours = {whole.pixelColor(view._x(column) + 2, y).name() for column in (0, 1, 2, 4)}
    assert len(colours) == 4
    assert len({bare.pixelColor(view._x(column) + 2, y).name() for column in (0, 1, 2, 4)}) == 1


def test_text_is_shown_as_letters(view: BytesView):
    view.render(BytesState((SheetRow(b"1,2\r\n", whole=True),), (), 5, text=True))
    assert not view.grab().toImage().isNull()
    assert view._cell < view.fontMetrics().horizontalAdvance("DD") + 8
