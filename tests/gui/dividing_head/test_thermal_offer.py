"""A session of several temperatures is offered to the tab that joins them."""

from pathlib import Path

import pytest
from PySide6.QtCore import QObject

from gui.dividing_head.thermal_offer import SOURCE, ThermalOffer
from gui.messages import Messages

pytestmark = pytest.mark.usefixtures("qapp")


@pytest.fixture
def parent() -> QObject:
    return QObject()


def test_it_is_offered_once_and_opens_the_tab(parent: QObject):
    opened: list[tuple[str, Path]] = []
    messages = Messages(parent)
    offer = ThermalOffer(messages, lambda *given: not opened.append(given), parent)
    offer.offer(Path("cycle"), 9)
    assert messages.current is not None
    assert "9 temperatures" in messages.current.what
    messages.press("open")
    assert opened == [("Thermal", Path("cycle"))]
    assert messages.current is None
    offer.offer(Path("cycle"), 9)
    assert messages.current is None


def test_one_temperature_is_no_cycle(parent: QObject):
    messages = Messages(parent)
    ThermalOffer(messages, lambda *given: True, parent).offer(Path("one"), 1)
    assert messages.current is None


def test_buttons_of_other_banners_are_not_ours(parent: QObject):
    opened: list[tuple[str, Path]] = []
    messages = Messages(parent)
    offer = ThermalOffer(messages, lambda *given: not opened.append(given), parent)
    offer.offer(Path("cycle"), 2)
    messages.action.emit("other", "open")
    assert opened == []
    messages.action.emit(SOURCE, "open")
    assert len(opened) == 1
