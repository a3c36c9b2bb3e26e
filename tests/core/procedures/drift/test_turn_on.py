"""What cannot be averaged is refused by name; records become turn-ons."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.drift.turn_on import TurnOn, check_turn_ons, turn_ons_of, with_ambients
from core.samples.run import Run
from tests.plain_run import plain_run


def flat(label: str = "a", ambient: float = 20.0, n: int = 200, rate: float = 10.0) -> TurnOn:
    return TurnOn(label, ambient, np.zeros(n), rate, np.full(n, 25.0))


def record(t: np.ndarray, number: np.ndarray, **columns: np.ndarray) -> Run:
    n = len(t)
    return plain_run(
        test="record",
        sensor="gyro",
        device="G7",
        channels=("x", "y"),
        axes=("x", "y"),
        unit="deg/s",
        y=np.column_stack([np.arange(n), -np.arange(n)]).astype(float),
        y_se=np.full((n, 2), np.nan),
        run=number,
        temperature_c=np.linspace(20.0, 30.0, n),
        t_s=t,
        extra=columns,
    )


def test_samples_between_two_times():
    one = replace(flat(), start_s=0.5)
    assert one.end_s == 20.5
    assert one.within(1.5, 2.0) == slice(10, 15)


def test_equal_turn_ons_give_their_length_as_horizon():
    assert check_turn_ons([flat("a"), flat("b")], np.nan) == 20.0


def test_different_lengths_are_refused_unless_a_horizon_is_stated():
    long = flat("long", n=300)
    with pytest.raises(FitError, match=r"short ends at 20 s, long at 30 s; state a horizon"):
        check_turn_ons([flat("short"), long], np.nan)
    assert check_turn_ons([flat("short"), long], 18.0) == 18.0
    with pytest.raises(FitError, match="before the horizon of 25 s"):
        check_turn_ons([flat("short"), long], 25.0)


def test_different_rates_are_refused():
    with pytest.raises(FitError, match="b has 20 samples per second, a 10"):
        check_turn_ons([flat("a"), flat("b", rate=20.0, n=400)], np.nan)


def test_temperatures_that_nearly_coincide_are_taken_for_a_slip():
    with pytest.raises(FitError, match=r"sets at 20 and at 20\.4 degC"):
        check_turn_ons([flat("a"), flat("b", ambient=20.4)], np.nan)


def test_no_number_is_named_by_its_place():
    broken = np.zeros(200)
    broken[7] = np.nan
    with pytest.raises(FitError, match="b: sample 8 is not a number"):
        check_turn_ons([flat("a"), replace(flat("b"), y=broken)], np.nan)
    with pytest.raises(FitError, match="no turn-on"):
        check_turn_ons([], np.nan)


def test_a_record_is_cut_at_its_run_numbers():
    t = np.tile(np.arange(100) * 0.02 + 0.01, 2)
    run = record(t, np.repeat([3, 4], 100), ambient_c=np.full(200, -10.0))
    first, second = turn_ons_of(run, 1)
    assert (first.label, second.label) == ("G7, turn-on 3", "G7, turn-on 4")
    assert first.rate == 50.0
    assert first.start_s == 0.01
    assert first.ambient_c == -10.0
    assert second.y[0] == -100.0


def test_a_gap_is_refused_with_its_rows():
    t = np.arange(100) * 0.02
    t[60:] += 0.02
    with pytest.raises(FitError, match=r"rows 60 and 61 are 0\.04 s apart, the others 0\.02 s"):
        turn_ons_of(record(t, np.ones(100, dtype=int)), 0)


def test_sets_are_found_by_the_chip_where_the_chamber_is_not_known():
    starts = (20.2, -9.8, 19.9, -10.1, 41.0)
    ones = [replace(flat(f"{s}", np.nan), temperature_c=np.full(200, s)) for s in starts]
    known = [one.ambient_c for one in with_ambients(ones)]
    assert known == pytest.approx([20.05, -9.95, 20.05, -9.95, 41.0])
    nothing = replace(flat("n", np.nan), temperature_c=np.full(200, np.nan))
    with pytest.raises(FitError, match="both unknown"):
        with_ambients([nothing])
