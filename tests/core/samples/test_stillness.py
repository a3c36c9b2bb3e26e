"""Rest, motion, slow fine adjustment and motion during an accumulation."""

import numpy as np
import pytest
from scipy.signal import butter, lfilter

from core.arrays import frozen, frozen_int
from core.samples.block import Channel, SampleBlock
from core.samples.stillness import StillnessDetector, moved

RATE = 200.0
CHANNELS = (Channel("X", "code", "acc.x"), Channel("T", "degC", "temp"))


def feed(detector: StillnessDetector, x: np.ndarray, first: int = 0, size: int = 20) -> list[bool]:
    """Feed in blocks; the temperature column runs away and must not matter."""
    rest = []
    for a in range(0, len(x), size):
        part = x[a : a + size]
        index = np.arange(first + a, first + a + len(part))
        data = np.column_stack([part, index * 10.0])
        detector.feed(SampleBlock(CHANNELS, frozen_int(index), frozen(data), RATE))
        rest.append(detector.at_rest)
    return rest


def test_rest_is_seen_through_white_and_filtered_noise() -> None:
    rng = np.random.default_rng(4)
    coloured = lfilter(*butter(2, 0.1), rng.normal(size=4500))[500:]
    for x in (rng.normal(0, 5, 4000), coloured):
        detector = StillnessDetector(RATE, "acc.")
        rest = feed(detector, x)
        assert not any(rest[:9]), "nothing is claimed before the window is full"
        assert np.mean(rest[10:]) > 0.99


def test_turning_the_head_is_motion_and_rest_returns_within_the_window() -> None:
    rng = np.random.default_rng(5)
    t = np.arange(0, 6, 1 / RATE)
    angle = np.interp(t, [2.0, 4.0], [0.0, 90.0])
    x = 13000 * np.cos(np.radians(angle)) + rng.normal(0, 5, len(t))
    rest = np.array(feed(StillnessDetector(RATE, "acc."), x))
    times = (np.arange(len(rest)) + 1) * 20 / RATE
    assert rest[(times > 1.0) & (times < 2.0)].all()
    assert not rest[(times > 2.3) & (times < 4.0)].any()
    assert rest[times > 5.2].all()


def test_a_slow_fine_adjustment_is_motion() -> None:
    rng = np.random.default_rng(6)
    t = np.arange(0, 3, 1 / RATE)
    x = 13000 * np.sin(np.radians(0.2 * t)) + rng.normal(0, 5, len(t))
    rest = feed(StillnessDetector(RATE, "acc."), x)
    assert not any(rest[12:])


def test_a_gap_starts_the_window_anew() -> None:
    detector = StillnessDetector(RATE, "acc.")
    x = np.random.default_rng(7).normal(size=400)
    feed(detector, x)
    assert detector.full
    index = np.r_[400:410, 900:910]
    data = np.column_stack([np.zeros(20), np.zeros(20)])
    detector.feed(SampleBlock(CHANNELS, frozen_int(index), frozen(data), RATE))
    assert not detector.full
    detector.reset()
    assert not detector.at_rest


def test_the_mean_is_that_of_the_window() -> None:
    detector = StillnessDetector(RATE, "acc.")
    feed(detector, np.r_[np.zeros(400), np.full(200, 5.0)])
    assert detector.mean() == pytest.approx([5.0])


@pytest.mark.parametrize("kind", ["step", "ramp", "bump"])
def test_motion_during_an_accumulation_is_found(kind: str) -> None:
    rng = np.random.default_rng(8)
    n = 2000
    motion = {
        "step": np.where(np.arange(n) > 1300, 20.0, 0.0),
        "ramp": np.linspace(0, 20.0, n),
        "bump": np.where((np.arange(n) > 600) & (np.arange(n) < 900), 40.0, 0.0),
    }[kind]
    data = np.column_stack([rng.normal(0, 5, n) + motion, rng.normal(0, 5, n)])
    assert moved(data).tolist() == [True, False]


@pytest.mark.slow
def test_a_quiet_accumulation_is_not_accused() -> None:
    rng = np.random.default_rng(9)
    accused = 0
    for _ in range(300):
        coloured = lfilter(*butter(2, 0.1), rng.normal(size=(2500, 2)), axis=0)[500:]
        accused += bool(moved(coloured).any())
    assert accused == 0
