import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.allan.deviation import overlapping, variance_of_phase
from core.allan.streaming import Accumulator, LiveAllan
from core.allan.taus import quantised, stride_of
from core.errors import FitError


def strided(y, m):
    """The definition, from phase decimated by the stride of each factor."""
    result = []
    for step in m.tolist():
        stride = stride_of(step)
        phase = np.concatenate(([0.0], np.cumsum(y)))[::stride]
        q = step // stride
        second = phase[2 * q :] - 2.0 * phase[q:-q] + phase[: -2 * q]
        result.append(np.mean(second**2) / (2.0 * step**2))
    return np.array(result)


@pytest.fixture(scope="module")
def record():
    rng = np.random.default_rng(4)
    return rng.normal(size=30_000) + 0.01 * np.cumsum(rng.normal(size=30_000))


def test_equal_to_strided_phase(record):
    live = LiveAllan(100.0)
    live.push(record)
    curve = live.curve()
    np.testing.assert_allclose(curve.variance, strided(record, curve.m), rtol=1e-11)
    assert curve.m[-1] <= len(record) // 3 * 1.01
    assert curve.mode == "streaming"
    assert curve.n == len(record)


@settings(max_examples=25)
@given(
    sizes=st.lists(st.sampled_from([1, 2, 7, 100, 1000, 4097]), max_size=40),
    looks=st.sets(st.integers(9, 30_000), max_size=5),
)
def test_the_cutting_into_pushes_does_not_matter(record, sizes, looks):
    whole = LiveAllan(100.0)
    whole.push(record)
    expected = whole.curve()
    live = LiveAllan(100.0)
    cuts = {one for one in np.cumsum(sizes).tolist() if one < len(record)} | looks
    for part in np.split(record, sorted(cuts)):
        live.push(part)
        if live.count in looks:
            live.curve()  # looking must not change anything
    curve = live.curve()
    np.testing.assert_array_equal(curve.pairs, expected.pairs)
    np.testing.assert_allclose(curve.variance, expected.variance, rtol=5e-13)


def test_short_factors_equal_full_overlap(record):
    live = LiveAllan(100.0)
    for part in np.array_split(record, 30):
        live.push(part)
    curve = live.curve()
    short = curve.m < 32
    phase = np.concatenate(([0.0], np.cumsum(record)))
    np.testing.assert_allclose(
        curve.variance[short], variance_of_phase(phase, curve.m[short]), rtol=1e-10
    )


def test_a_gap_is_a_cut_however_it_is_told(record):
    told, holed = LiveAllan(100.0), LiveAllan(100.0)
    told.push(record[:10_000])
    told.cut()
    told.push(record[10_050:])
    with_holes = record.copy()
    with_holes[10_000:10_050] = np.nan
    holed.push(with_holes)
    one, other = told.curve(), holed.curve()
    np.testing.assert_allclose(one.variance, other.variance, rtol=1e-12)
    assert [note.subject for note in one.notes] == ["gaps"]
    batch = overlapping(with_holes, 100.0, m=one.m[:20], gaps="stretches")
    np.testing.assert_allclose(one.deviation[:16], batch.deviation[:16], rtol=1e-10)


def test_memory_does_not_grow_with_the_record():
    def kept(live):
        return sum(
            level._tail.nbytes + level._carry.nbytes + sum(one.nbytes for one in level._waiting)
            for level in live._accumulator._levels
        )

    rng = np.random.default_rng(0)
    live = LiveAllan(1000.0)
    sizes = []
    for _ in range(3):
        for _ in range(300):
            live.push(rng.normal(size=1000))
        sizes.append(kept(live))
    assert sizes[-1] < 150_000
    assert sizes[-1] < 1.5 * sizes[0]


def test_a_large_offset_costs_no_digits(record):
    live, plain = LiveAllan(100.0), LiveAllan(100.0)
    codes = np.rint(record * 10.0)
    live.push(codes + 2.0**40)
    plain.push(codes)
    np.testing.assert_allclose(live.curve().variance, plain.curve().variance, rtol=1e-14)


class TestRefusals:
    def test_too_early(self):
        live = LiveAllan(10.0)
        live.push(np.arange(8.0))
        with pytest.raises(FitError, match="8 samples so far"):
            live.curve()

    def test_nothing_at_all(self):
        live = LiveAllan(10.0)
        live.push(np.empty(0))
        live.cut()
        with pytest.raises(FitError, match="0 samples so far"):
            live.curve()

    def test_stuck(self):
        live = LiveAllan(10.0)
        live.push(np.full(500, 3.5))
        with pytest.raises(FitError, match="500 samples so far are equal"):
            live.curve()

    def test_a_link_that_loses_every_other_sample(self):
        live = LiveAllan(10.0)
        samples = np.random.default_rng(0).normal(size=100)
        samples[::2] = np.nan
        live.push(samples)
        with pytest.raises(FitError, match="check the link"):
            live.curve()

    @pytest.mark.parametrize("rate", [0.0, np.nan])
    def test_no_rate(self, rate):
        with pytest.raises(ValueError, match="rate must be positive"):
            LiveAllan(rate)

    def test_factors_that_are_no_multiples(self):
        with pytest.raises(ValueError, match="33 is not a multiple of its stride 2"):
            Accumulator(np.array([1, 33]))
        Accumulator(quantised(np.array([1, 33])))
