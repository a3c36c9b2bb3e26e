"""The pyramid against brute force on random records and views."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gui.widgets.pyramid import BASE, CHUNK, FACTOR, Pyramid


def brute(samples, first, step):
    """Extremes of bins of `step` samples from `first` on, the slow way."""
    lows, highs = [], []
    for begin in range(first, len(samples), step):
        part = samples[begin : begin + step]
        part = part[~np.isnan(part)]
        lows.append(part.min() if part.size else np.nan)
        highs.append(part.max() if part.size else np.nan)
    return np.array(lows), np.array(highs)


def record(seed, size, holes):
    rng = np.random.default_rng(seed)
    samples = rng.normal(size=size).cumsum()
    for _ in range(holes):
        begin = int(rng.integers(0, size))
        samples[begin : begin + int(rng.integers(1, 300))] = np.nan
    return samples


def built(samples, seed):
    """Append in pieces of random sizes."""
    rng = np.random.default_rng(seed)
    pyramid = Pyramid()
    place = 0
    while place < len(samples):
        size = int(rng.choice([1, 7, 64, 133, 5000, 70000]))
        pyramid.append(samples[place : place + size])
        place += size
    return pyramid


@settings(max_examples=60)
@given(
    seed=st.integers(0, 2**32 - 1),
    size=st.integers(1, 2 * CHUNK + 1000),
    holes=st.integers(0, 6),
    ends=st.tuples(st.floats(0, 1), st.floats(0, 1)),
    pixels=st.integers(1, 4000),
)
def test_any_view_shows_the_exact_extremes(seed, size, holes, ends, pixels):
    samples = record(seed, size, holes)
    pyramid = built(samples, seed)
    start, stop = sorted(round(end * size) for end in ends)
    columns = pyramid.query(start, stop, pixels)
    if start == stop:
        assert columns.low.size == 0
        return
    if columns.step == 1:
        assert stop - start <= 2 * pixels
        assert np.array_equal(columns.low, samples[start:stop], equal_nan=True)
        return
    step = columns.step
    assert step & (step - 1) == 0
    assert columns.first % step == 0
    assert columns.first <= start < columns.first + step
    assert stop <= columns.first + step * columns.low.size
    assert columns.low.size <= pixels + 1
    low, high = brute(samples[: columns.first + step * columns.low.size], columns.first, step)
    assert np.array_equal(columns.low, low, equal_nan=True)
    assert np.array_equal(columns.high, high, equal_nan=True)


@settings(max_examples=60)
@given(
    seed=st.integers(0, 2**32 - 1),
    size=st.integers(1, 30000),
    holes=st.integers(0, 6),
    ends=st.tuples(st.floats(0, 1), st.floats(0, 1)),
)
def test_extremes_and_moments_of_any_stretch(seed, size, holes, ends):
    samples = record(seed, size, holes)
    pyramid = built(samples, seed)
    start, stop = sorted(round(end * size) for end in ends)
    part = samples[start:stop]
    k = np.arange(start, stop)[~np.isnan(part)]
    part = part[~np.isnan(part)]
    low, high = pyramid.extremes(start, stop)
    moments = pyramid.moments(start, stop)
    assert moments.count == part.size
    if not part.size:
        assert np.isnan([low, high, moments.mean]).all()
        return
    assert (low, high) == (part.min(), part.max())
    assert moments.mean == pytest.approx(part.mean(), rel=1e-12, abs=1e-9)
    if part.size > 1:
        assert moments.sigma == pytest.approx(part.std(ddof=1), rel=1e-9, abs=1e-9)
        dk = k - k.mean()
        slope = (dk @ (part - part.mean())) / (dk @ dk)
        assert moments.slope == pytest.approx(slope, rel=1e-7, abs=1e-9)


def test_digits_of_a_large_mean_with_little_scatter_are_kept():
    rng = np.random.default_rng(5)
    noise = 1e-6 * rng.normal(size=200_000)
    pyramid = Pyramid()
    pyramid.append(23.733621597 + noise)
    assert pyramid.moments(3, 199_990).sigma == pytest.approx(
        noise[3:199_990].std(ddof=1), rel=1e-6
    )


def test_cost_of_memory_is_a_few_percent_of_the_samples():
    pyramid = Pyramid()
    pyramid.append(np.zeros(BASE * FACTOR**3 * 4))
    entries = sum(2 * level.count for level in pyramid._levels)
    assert entries / len(pyramid) < 0.04


def test_no_samples():
    pyramid = Pyramid()
    assert len(pyramid) == 0
    assert pyramid.query(0, 100, 50).low.size == 0
    assert np.isnan(pyramid.extremes(0, 10)).all()
    assert pyramid.moments(0, 10).count == 0


def test_stretch_is_clipped_to_what_is_there():
    pyramid = Pyramid()
    pyramid.append(np.arange(10.0))
    assert pyramid.query(-5, 500, 100).low.tolist() == list(range(10))
    assert pyramid.extremes(-3, 5) == (0.0, 4.0)
    assert pyramid.raw(8, 5).size == 0


def test_bins_do_not_move_while_the_view_scrolls():
    samples = record(3, 50_000, 0)
    pyramid = built(samples, 3)
    one = pyramid.query(1000, 41_000, 500)
    other = pyramid.query(1037, 41_037, 500)
    assert one.step == other.step
    shift = (other.first - one.first) // one.step
    assert np.array_equal(one.low[shift:400], other.low[: 400 - shift])
