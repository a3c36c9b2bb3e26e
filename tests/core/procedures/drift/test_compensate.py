"""From turn-ons to a table: the figures promised, intervals that hold, knots that are dragged."""

import numpy as np
import pytest

from core.errors import FitError
from core.fit.quantiles import student_t
from core.procedures.drift.compensate import compensate, cost_of, moved, with_knots
from core.procedures.drift.curves import Curves, curves_of
from core.procedures.drift.held_out import METHODS, residuals_of
from core.procedures.drift.turn_on import TurnOn


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def test_ten_knots_reach_the_floor_and_leave_the_quartic_behind(sharp: Curves, unseen: Curves):
    result = compensate(sharp, "deg/s", knots=10)
    left = rms(residuals_of(result.table, unseen))
    mean = sharp.mean
    floor = rms(unseen.y - mean[unseen.place])
    quartic = rms(unseen.y - METHODS["quartic"](sharp.t, mean, 10)[unseen.place])
    assert left <= 1.15 * floor
    assert quartic >= 2.5 * left
    assert result.table.bytes == 240 + 22
    # The scores that a user sees are honest: they foretell what turn-ons to come will show.
    assert result.score("table").rms == pytest.approx(left, rel=0.15)
    assert result.score("quartic").rms == pytest.approx(quartic, rel=0.15)


def test_the_number_of_knots_is_chosen_within_the_memory(sharp: Curves):
    free = compensate(sharp, "deg/s", limit=20)
    assert 6 <= len(free.table.times_s) <= 16
    small = compensate(sharp, "deg/s", limit=5)
    assert len(small.table.times_s) == 5
    assert (small.table.times_s[0], small.table.times_s[-1]) == (2.0, 120.0)


def test_values_between_calibrated_temperatures_are_right(make_turn_ons):
    every = compensate(curves_of(make_turn_ons(6, 5, np.arange(-40.0, 61.0, 20.0))), "deg/s")
    between = curves_of(make_turn_ons(7, 3, np.arange(-30.0, 60.0, 20.0)))
    left = residuals_of(every.table, between)
    assert rms(left) < 0.15 * rms(between.y)


@pytest.mark.slow
def test_intervals_of_the_table_hold_the_truth():
    rng = np.random.default_rng(31)
    knots = np.array([2.0, 5.0, 12.0, 21.0, 30.0])
    shapes = {0.0: np.array([0.0, 2.0, 1.0, 3.0, 3.5]), 40.0: np.array([0.0, -1.0, 0.5, 0.0, 4.0])}
    rate, trials, inside = 20.0, 250, []
    t = (np.arange(600) + 0.5) / rate
    factor = student_t(0.95, 4.0)
    for _ in range(trials):
        made = [
            TurnOn(
                f"{ambient}/{number}",
                ambient,
                np.interp(t, knots, values) * (1 + 0.02 * rng.standard_normal())
                + 0.3 * rng.standard_normal(600)
                + 5.0 * rng.standard_normal(),
                rate,
                np.full(600, ambient),
            )
            for ambient, values in shapes.items()
            for number in range(5)
        ]
        table = with_knots(curves_of(made), "deg/s", knots)
        truth = np.array(list(shapes.values()))
        inside.append(np.abs(table.values - truth) < factor * table.u)
    assert table.dof.tolist() == [4.0, 4.0]
    assert 0.93 < np.mean(inside) < 0.97


def test_dragged_knots_cost_more(sharp: Curves):
    best = compensate(sharp, "deg/s", knots=8).table
    dragged = best.times_s.copy()
    dragged[3] += 4.0
    assert cost_of(sharp, with_knots(sharp, "deg/s", dragged)) > cost_of(sharp, best)
    result = compensate(sharp, "deg/s", knots=8)
    worse = moved(result, dragged)
    assert worse.table.times_s[3] == dragged[3]
    assert worse.score("table").rms > result.score("table").rms
    assert worse.score("quartic") is result.score("quartic")
    assert worse.notes[-1].subject == "moved_knots"
    with pytest.raises(FitError, match="ascending order"):
        with_knots(sharp, "deg/s", [2.0, 50.0, 40.0, 120.0])
    with pytest.raises(FitError, match="nearer to each other than a block"):
        with_knots(sharp, "deg/s", [2.0, 50.0, 50.5, 120.0])


def test_a_plateau_of_the_chip_temperature_does_no_harm(make_turn_ons):
    flat = [
        TurnOn(one.label, one.ambient_c, one.y, one.rate, np.full_like(one.y, one.ambient_c))
        for one in make_turn_ons(8, 3, np.array([0.0, 20.0]))
    ]
    result = compensate(curves_of(flat), "deg/s", knots=10)
    assert np.all(np.isfinite(result.table.values))
    assert result.score("table").rms < 0.3 * result.score("none").rms
    note = next(note for note in result.notes if note.subject == "temperature_plateau")
    assert "at 0, 20 degC" in note.text
    warming = compensate(curves_of(make_turn_ons(8, 3, np.array([0.0, 20.0]))), "deg/s", knots=6)
    assert "temperature_plateau" not in [note.subject for note in warming.notes]


def test_doubts_are_said(make_turn_ons):
    lonely = compensate(curves_of(make_turn_ons(9, 1, np.array([0.0, 20.0]))), "deg/s")
    assert "no_repetition" in [note.subject for note in lonely.notes]
    assert np.isnan(lonely.table.u).all()
    with pytest.raises(KeyError):
        lonely.score("table")
    noisy = compensate(curves_of(make_turn_ons(9, 3, kind="smooth", noise=4e-3)), "deg/s")
    assert "alignment_noise" in [note.subject for note in noisy.notes]
    rng = np.random.default_rng(1)
    walks = [
        TurnOn(str(i), 0.0, np.cumsum(rng.normal(size=1000)), 20.0, np.zeros(1000))
        for i in range(5)
    ]
    assert "no_gain" in [note.subject for note in compensate(curves_of(walks), "deg/s").notes]


def test_a_limit_that_does_not_fit_is_refused(sharp: Curves):
    with pytest.raises(FitError, match="between 2 and 59"):
        compensate(sharp, "deg/s", limit=80)
    with pytest.raises(FitError, match="the memory limit allows 2 to 8"):
        compensate(sharp, "deg/s", limit=8, knots=9)
