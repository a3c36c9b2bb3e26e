"""The program notices that it stood still."""

import time

import pytest

from core.samples.block import SampleBlock
from drivers.events import Message
from drivers.pauses import LEAST_S, Pauses, waking_clock
from drivers.rawlog import Mark, RawLog, read_rawlog
from drivers.reader import Reader
from drivers.transport import EndOfStream
from tests.drivers.links import Letters, Script, finish


def test_only_long_pauses_count():
    now = iter([10.0, 10.1, 12.0, 12.0 + LEAST_S, 15.2 + LEAST_S, 99.0, 99.5])
    pauses = Pauses(lambda: next(now))
    assert [pauses.seconds() for _ in range(3)] == [0.0, 0.0, LEAST_S]
    assert pauses.seconds() == pytest.approx(3.2)
    pauses.begin()
    assert pauses.seconds() == 0.0


def test_the_clock_goes_on():
    before = waking_clock()
    time.sleep(0.01)
    assert 0.01 <= waking_clock() - before < 10.0


def test_a_reader_tells_that_it_was_asleep(tmp_path):
    log = RawLog(tmp_path / "a.calrec", {})
    script = Script([b"ab", 0.05, b"cd", EndOfStream()])
    reader = Reader(lambda: script, Letters(), log)
    slept = iter([0.0, 7.25])
    reader._pauses.seconds = lambda: next(slept, 0.0)
    events = finish(reader)
    kinds = [type(event).__name__ for event in events]
    assert kinds == ["SampleBlock", "Message", "SampleBlock", "Ended"]
    assert events[1] == Message("paused", b"", {"gap_s": "7.250"})
    assert isinstance(events[2], SampleBlock)
    (mark,) = [part for part in read_rawlog(tmp_path / "a.calrec") if isinstance(part, Mark)]
    assert (mark.kind, mark.fields) == ("paused", {"gap_s": 7.25})
