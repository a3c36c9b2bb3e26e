from dataclasses import replace

import numpy as np
import pytest

from core.errors import FormatError
from core.plans.plan import Step
from core.records.json_fields import dump, load_object
from core.records.session.events import (
    Event,
    Position,
    RawRange,
    counting,
    event_from_json,
    event_to_json,
)

NOW = "2024-05-14T06:30:15+00:00"


@pytest.fixture
def position(means):
    return Position(
        id=3,
        attempt=2,
        step=Step(13, "Y from ODH", "Y_from", 90.0),
        measured_utc=NOW,
        accumulation=means(4.0),
        temperature_c=float("nan"),
        set_temperature_c=-40.0,
        raw=RawRange("a.calrec", 512, 9000),
    )


def round_trip(event, channels):
    return event_from_json(load_object(dump(event_to_json(event), indent=None), "j"), channels)


def test_a_position_comes_back_to_the_last_bit(position):
    event = Event(3, NOW, "accepted", position, targets=(1, 2))
    back = round_trip(event, position.accumulation.channels)
    assert (back.id, back.kind, back.targets) == (3, "accepted", (1, 2))
    assert back.position is not None
    for name in ("id", "attempt", "step", "measured_utc", "set_temperature_c", "raw"):
        assert getattr(back.position, name) == getattr(position, name)
    assert np.isnan(back.position.temperature_c)
    for name in ("mean", "std", "se", "se_dof", "slope", "slope_se"):
        np.testing.assert_array_equal(
            getattr(back.position.accumulation, name), getattr(position.accumulation, name)
        )
    for name in ("n", "seconds", "lost", "first", "notes"):
        assert getattr(back.position.accumulation, name) == getattr(position.accumulation, name)


def test_other_events_come_back():
    event = Event(9, NOW, "restored", targets=(4,), instead_of=(6, 7), reason="undo")
    assert repr(round_trip(event, ())) == repr(event)


def test_a_position_with_other_channels_is_refused(position):
    event = Event(3, NOW, "accepted", position)
    with pytest.raises(FormatError, match=r"position\.mean must be 2 numbers, found '7 items'"):
        round_trip(event, position.accumulation.channels[:2])


def test_which_positions_count(position):
    def measured(number, kind="accepted", targets=()):
        return Event(number, NOW, kind, replace(position, id=number), targets)

    def ids(*events):
        return [one.id for one in counting(events)]

    assert ids(measured(1), measured(2)) == [1, 2]
    assert ids(measured(1), measured(2, "rejected")) == [1]
    superseded = (measured(1), measured(2, targets=(1,)))
    assert ids(*superseded) == [2]
    discarded = (*superseded, Event(3, NOW, "discarded", targets=(2,)))
    assert ids(*discarded) == []
    restored = (*discarded, Event(4, NOW, "restored", targets=(1, 2)))
    assert ids(*restored) == [1, 2]
    assert ids(*restored, Event(5, NOW, "restored", targets=(1,), instead_of=(2,))) == [1]
