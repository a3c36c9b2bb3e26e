import numpy as np
import pytest

from core.allan.record import sample_index, survey
from core.errors import FitError, Severity


@pytest.fixture
def record():
    return np.random.default_rng(3).normal(size=2000)


def test_a_clean_record_is_one_stretch_without_notes(record):
    found = survey(record)
    assert found.stretches.tolist() == [[0, 2000]]
    assert found.n == 2000
    assert found.longest == (0, 2000)
    assert found.notes == ()
    assert not found.integral
    assert found.mean == pytest.approx(record.mean())


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_values_that_are_not_finite_are_gaps_and_refused_by_default(record, bad):
    record[1500] = bad
    with pytest.raises(FitError, match="1 samples lost, the first after sample 1500 of 2000"):
        survey(record)


def test_the_longest_stretch_is_taken_on_demand_and_said(record):
    record[[700, 701, 1900]] = np.nan
    found = survey(record, gaps="longest")
    assert found.stretches.tolist() == [[702, 1900]]
    (note,) = found.notes
    assert (note.subject, note.severity) == ("gaps", Severity.WARNING)
    assert "1198 of 2000" in note.text


def test_stretches_leave_out_the_holes_only(record):
    record[[0, 700, 701, 1999]] = np.nan
    found = survey(record, gaps="stretches")
    assert found.stretches.tolist() == [[1, 700], [702, 1999]]
    assert found.n == 1996


def test_a_jump_of_the_counter_is_a_gap_and_counted(record):
    index = np.arange(2000)
    index[1200:] += 17
    with pytest.raises(FitError, match="17 samples lost"):
        survey(record, index)
    assert survey(record, index, "stretches").stretches.tolist() == [[0, 1200], [1200, 2000]]


def test_holes_and_jumps_together(record):
    index = np.arange(2000)
    index[1200:] += 17
    record[1200] = np.nan
    found = survey(record, index, "stretches")
    assert found.stretches.tolist() == [[0, 1200], [1201, 2000]]


def test_a_counter_that_runs_back_is_refused(record):
    index = np.arange(2000)
    index[800:] -= 5
    with pytest.raises(FitError, match="do not increase at sample 800"):
        survey(record, index, "stretches")


@pytest.mark.parametrize("n", [0, 1, 8])
def test_too_short_is_said(n):
    with pytest.raises(FitError, match=f"has {n} usable samples"):
        survey(np.arange(n, dtype=float))


def test_nothing_but_holes_is_refused():
    with pytest.raises(FitError, match="gaps"):
        survey(np.full(100, np.nan), gaps="longest")


def test_a_constant_record_is_refused():
    with pytest.raises(FitError, match="stuck or not connected"):
        survey(np.full(5000, 12866.3))


def test_codes_are_recognised_in_any_type():
    codes = np.random.default_rng(0).integers(-50, 50, 1000)
    for kind in (np.int16, np.int32, np.int64, np.float32, np.float64):
        found = survey(codes.astype(kind))
        assert found.integral
        assert (found.lowest, found.highest) == (codes.min(), codes.max())


def test_two_columns_are_a_mistake_of_the_caller():
    with pytest.raises(ValueError, match="one-dimensional"):
        survey(np.zeros((10, 2)))


def test_sample_numbers_must_be_as_many_as_samples(record):
    with pytest.raises(ValueError, match="5 sample numbers"):
        survey(record, np.arange(5))


class TestSampleIndex:
    def test_uniform_stamps_with_small_jitter(self):
        time = 5.0 + np.arange(1000) / 200.0
        time += np.random.default_rng(0).uniform(-1e-4, 1e-4, 1000)
        index, rate = sample_index(time)
        assert index.tolist() == list(range(1000))
        assert rate == pytest.approx(200.0, rel=1e-4)

    def test_missing_samples_are_steps(self):
        time = np.delete(np.arange(1000) * 0.01, [400, 401, 402])
        index, rate = sample_index(time)
        assert np.diff(index).max() == 4
        assert rate == pytest.approx(100.0)

    def test_arrival_times_in_bursts_are_not_uniform(self):
        time = np.floor(np.arange(1000) * 0.01 / 0.033) * 0.033 + np.arange(1000) * 1e-6
        with pytest.raises(FitError, match="not uniform in time"):
            sample_index(time)

    def test_a_rate_that_changes_is_not_uniform(self):
        time = np.concatenate((np.arange(600) * 0.01, 6.0 + np.arange(400) * 0.0125))
        with pytest.raises(FitError, match="not uniform"):
            sample_index(time)

    def test_time_that_runs_back_names_the_place(self):
        time = np.arange(100) * 0.01
        time[60:] -= 0.2
        with pytest.raises(FitError, match="does not increase at sample 60"):
            sample_index(time)

    def test_few_stamps(self):
        with pytest.raises(FitError, match="has 5 time stamps"):
            sample_index(np.arange(5.0))
