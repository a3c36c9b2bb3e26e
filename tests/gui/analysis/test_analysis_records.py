"""Which record is chosen when one goes; what is told of those that cannot be used."""

from dataclasses import dataclass
from pathlib import Path

import pytest

from gui.analysis.records import Refusals, beside
from gui.messages import Messages


@dataclass(frozen=True)
class Row:
    path: Path | None
    error: str = ""


GOOD, BAD = Row(Path("a.csv")), Row(Path("b.csv"), "line 1: no numbers")


@pytest.mark.parametrize(
    ("keys", "gone", "chosen"), [((1, 2, 3), 2, 3), ((1, 2, 3), 3, 2), ((4,), 4, 0)]
)
def test_the_next_is_chosen_else_the_last(keys: tuple[int, ...], gone: int, chosen: int):
    assert beside(keys, gone) == chosen


def test_a_refused_record_is_told_once_and_taken_back(qapp: object):
    messages = Messages()
    refusals = Refusals("drift", messages)
    refusals.tell((GOOD, BAD), "{name} is none", "Remove it.")
    assert messages.current is not None
    assert (messages.current.what, messages.current.remedy) == ("b.csv is none", "Remove it.")
    messages.dismiss()
    refusals.tell((GOOD, BAD), "{name} is none", "Remove it.")
    assert messages.current is None
    refusals.tell((GOOD, BAD, Row(Path("c.csv"), "empty")), "{name} is none", "")
    assert messages.current is not None
    refusals.tell((GOOD,), "{name} is none", "")
    assert messages.current is None
