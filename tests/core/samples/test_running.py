"""Running moments against numpy over the whole."""

import numpy as np
import pytest

from core.samples.running import LatestMoments, RunningMoments


@pytest.fixture
def data() -> np.ndarray:
    rng = np.random.default_rng(8)
    return rng.normal([8388607.0, -3.0], [1.0, 0.25], (1000, 2))


@pytest.mark.parametrize("cuts", [[1000], [1, 2, 400, 999, 1000], [333, 333, 1000]])
def test_blocks_give_the_moments_of_the_whole(data, cuts):
    running = RunningMoments(2)
    start = 0
    for stop in cuts:
        running.feed(data[start:stop])
        start = stop
    found = running.moments
    assert found.n == 1000
    assert found.mean == pytest.approx(data.mean(axis=0), rel=1e-12)
    # A plain sum of squares of numbers of 8e6 would be wrong in the fifth digit here.
    assert found.std == pytest.approx(data.std(axis=0, ddof=1), rel=1e-9)
    assert np.array_equal(found.low, data.min(axis=0))
    assert np.array_equal(found.high, data.max(axis=0))
    assert np.array_equal(found.last, data[-1])


def test_nothing_and_one_sample_claim_nothing():
    running = RunningMoments(2)
    assert np.isnan(running.moments.mean).all()
    running.feed(np.array([[1.0, 2.0]]))
    assert np.array_equal(running.moments.mean, [1.0, 2.0])
    assert np.isnan(running.moments.std).all()


def test_the_latest_samples_alone(data):
    latest = LatestMoments(100, 2)
    assert latest.moments.n == 0
    for part in np.split(data, [70, 71, 500, 930]):
        latest.feed(part)
    found = latest.moments
    assert found.n == 100
    assert found.mean == pytest.approx(data[-100:].mean(axis=0), rel=1e-12)
    assert found.std == pytest.approx(data[-100:].std(axis=0, ddof=1), rel=1e-9)
