"""The ear keeps the latest bytes."""

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
