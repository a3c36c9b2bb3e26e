"""Pages are made when they are opened, and only then."""

from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from gui.methods.tab import PAGES, MethodsTab


def test_the_first_page_comes_when_the_tab_is_seen_and_the_others_when_they_are_chosen(
    tab: MethodsTab, qtbot: QtBot
):
    assert list(tab.pages) == [next(iter(PAGES))]
    for row, key in enumerate(PAGES):
        item = tab.view.list.item(row)
        where = tab.view.list.visualItemRect(item).center()
        qtbot.mouseClick(tab.view.list.viewport(), Qt.MouseButton.LeftButton, pos=where)
        page = tab.pages[key]
        assert page.widget.isVisible()
        assert page.side.isVisible()
        assert item.text()
    assert list(tab.pages) == list(PAGES)


def test_a_page_that_was_made_is_shown_again(tab: MethodsTab):
    tab.open("tumble")
    first = tab.pages["tumble"]
    tab.open("gyrocompass")
    assert not first.widget.isVisible()
    tab.open("tumble")
    assert tab.pages["tumble"] is first
    assert first.widget.isVisible()


def test_no_page_holds_the_ports_or_wants_the_rig(tab: MethodsTab):
    assert tab.wanted() is None
    for key in PAGES:
        tab.open(key)
    assert tab.why_busy() == ""
    assert tab.wanted() is None


def test_a_tab_that_was_not_seen_makes_no_page(unseen_tab: MethodsTab):
    unseen_tab.after_paint()
    assert unseen_tab.pages == {}
    assert unseen_tab.wanted() is None
