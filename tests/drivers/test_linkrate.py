"""The rate by a line through bursty arrival times."""

import math

import numpy as np
import pytest

from drivers.linkrate import LinkRate


def test_bursts_of_an_adapter_do_not_matter():
    rng = np.random.default_rng(1)
    rate = LinkRate()
    for burst in range(1200):
        arrival = burst * 0.016 + rng.exponential(0.002)
        rate.add(arrival, math.floor(burst * 0.016 * 200.0))
    assert rate.hz() == pytest.approx(200.0, rel=2e-4)


def test_unknown_for_a_second():
    rate = LinkRate()
    assert math.isnan(rate.hz())
    for step in range(20):
        rate.add(100.0 + step * 0.05, step * 10)
    assert math.isnan(rate.hz())
    rate.add(101.0, 200)
    assert rate.hz() == pytest.approx(200.0)
    assert not rate.due(101.4)
    assert rate.due(101.5)


def test_follows_a_change_after_a_minute():
    rate = LinkRate()
    index = 0
    for step in range(4000):
        index += 10 if step < 2000 else 5
        rate.add(step * 0.05, index)
    assert rate.hz() == pytest.approx(100.0)
