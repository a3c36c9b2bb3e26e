"""Events pass between threads, so nobody may change them."""

from dataclasses import FrozenInstanceError, fields

import pytest

from core.errors import LinkError
from drivers.events import BadChecksum, BadValues, Ended, Garbage, Lost, Message

EVENTS = [
    Garbage(3, b"abc"), BadChecksum(1), BadValues(2), Lost(4, 10), Message("text", b"x", {}),
    Ended(LinkError("COM4", "gone")),
]  # fmt: skip


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: type(event).__name__)
def test_events_cannot_be_changed(event: object):
    name = fields(event)[0].name  # type: ignore[arg-type]
    with pytest.raises(FrozenInstanceError):
        setattr(event, name, 0)


def test_equal_events_are_equal():
    assert Lost(4, 10) == Lost(4, 10)
    assert Lost(4, 10) != Lost(4, 11)
    assert Ended(None) == Ended(None)
