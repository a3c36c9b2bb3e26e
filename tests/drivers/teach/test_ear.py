"""The ear keeps the latest bytes."""

import time

import pytest

from drivers.teach.ear import Ear, Heard


def test_only_the_latest_bytes_are_kept():
    ear = Ear(kept=5)
    assert ear.heard == Heard()
    assert ear.feed(b"abc") == []
    ear.feed(b"defg")
    assert (ear.heard.tail, ear.heard.total) == (b"cdefg", 7)
    assert (ear.channels, ear.rate, ear.flush()) == ((), 0.0, [])


def test_the_rate_waits_until_it_can_be_told():
    assert Heard(b"ab", 2, 0.1, 2).bytes_per_s == 0.0
    assert Heard(b"ab", 250, 2.0, 200).bytes_per_s == pytest.approx(100.0)


def test_what_had_waited_in_the_system_does_not_count(monkeypatch: pytest.MonkeyPatch):
    moments = iter([10.0, 10.001, 10.1, *(10.1 + 0.1 * i for i in range(1, 20))])
    monkeypatch.setattr(time, "monotonic", lambda: next(moments))
    ear = Ear()
    for waited in (4000, 2000):
        ear.feed(b"x" * waited)
    for _ in range(20):
        ear.feed(b"x" * 50)
    assert ear.heard.bytes_per_s == pytest.approx(500.0)
