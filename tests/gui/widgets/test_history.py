import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.arrays import frozen
from core.samples.block import Channel
from gui.widgets.history import FILL, History

CHANNELS = (Channel("GyroOut", "V"), Channel("Temperature", "degC"))


def filled(index, rate=100.0):
    history = History(CHANNELS, rate)
    index = np.asarray(index, dtype=np.int64)
    history.append(index, frozen(np.column_stack([np.sin(index / 50.0), index])))
    return history


def test_time_starts_at_the_first_sample():
    history = filled(np.arange(1000, 2000))
    assert (history.first, history.end) == (1000, 2000)
    assert history.seconds(1100) == 1.0
    assert history.number(1.004) == 1100
    assert history.value(1, 1234) == 1234.0


def test_short_gap_is_a_hole_in_the_curve():
    history = filled([0, 1, 2, 10, 11])
    (columns,) = history.columns(1, 0, 12, 100)
    assert np.isnan(columns.low[3:10]).all()
    assert columns.low[10] == 10.0
    assert np.isnan(history.value(1, 5))


def test_long_gap_costs_no_memory_and_parts_the_curve():
    history = filled([*range(100), *range(10**9, 10**9 + 50)])
    assert [len(segment[0]) for segment in history._segments] == [100, 50]
    one, other = history.columns(1, 0, 10**9 + 50, 1000)
    assert (one.first, one.low[0]) == (0, 0.0)
    assert other.first == 10**9
    assert other.high[-1] == 10**9 + 49
    assert np.isnan(history.value(1, 500_000))
    assert history.extremes(1, 50, 10**9 + 10) == (50.0, 10**9 + 9.0)
    assert np.isnan(history.extremes(1, 5000, 6000)).all()


@given(
    st.lists(st.tuples(st.integers(1, 400), st.sampled_from([0, 1, 30, FILL, FILL + 1, 10**6]))),
    st.integers(0, 10**7),
    st.integers(0, 10**7),
)
def test_statistics_over_gaps(runs, begin, length):
    index = []
    place = 0
    for size, gap in runs:
        index.extend(range(place, place + size))
        place += size + gap
    history = History(CHANNELS, 10.0)
    numbers = np.array(index, dtype=np.int64)
    values = np.cos(numbers * 0.1) + 3.0
    if numbers.size:
        half = numbers.size // 2
        data = frozen(np.column_stack([values, numbers]))
        history.append(numbers[:half], data[:half])
        history.append(numbers[half:], data[half:])
    inside = (numbers >= begin) & (numbers < begin + length)
    found = history.statistics(0, begin, begin + length)
    assert found.count == inside.sum()
    if found.count > 1:
        assert found.mean == pytest.approx(values[inside].mean())
        assert found.sigma == pytest.approx(values[inside].std(ddof=1), abs=1e-12)
        assert (found.low, found.high) == (values[inside].min(), values[inside].max())
        t = numbers[inside] / 10.0
        slope = np.cov(t, values[inside])[0, 1] / t.var(ddof=1)
        assert found.slope == pytest.approx(slope, rel=1e-6, abs=1e-9)


def test_numbers_must_increase():
    history = filled([5, 6, 7])
    with pytest.raises(ValueError, match="do not follow 7"):
        history.append(np.array([7]), np.zeros((1, 2)))
    with pytest.raises(ValueError, match="do not follow"):
        history.append(np.array([9, 9]), np.zeros((2, 2)))
    history.append(np.empty(0, dtype=np.int64), np.empty((0, 2)))
    assert history.end == 8


def test_rate_must_be_known():
    with pytest.raises(ValueError, match="positive rate"):
        History(CHANNELS, 0.0)


def test_empty_history():
    history = History(CHANNELS, 10.0)
    assert history.columns(0, 0, 100, 100) == []
    assert history.statistics(0, 0, 100).count == 0
    assert np.isnan(history.value(0, 0))
