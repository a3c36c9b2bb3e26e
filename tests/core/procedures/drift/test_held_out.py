"""Residuals on turn-ons that a method has not seen; the number of knots that they ask for."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.drift.compensate import compensate
from core.procedures.drift.curves import Curves, curves_of
from core.procedures.drift.held_out import (
    METHODS,
    KnotScore,
    broken_line,
    fewest_knots,
    knot_scores,
    method_scores,
    node_scores,
    residuals_of,
    score_of_knots,
)


def test_polynomials_fit_what_is_one_and_nothing_else():
    t = np.linspace(2.0, 120.0, 40)
    curve = (1.0 + 0.1 * t - 0.002 * t**2 + 1e-5 * t**3)[None, :]
    assert METHODS["cubic"](t, curve, 0) == pytest.approx(curve)
    assert METHODS["quartic"](t, curve, 0) == pytest.approx(curve)
    assert np.abs(METHODS["cubic"](t, curve**2, 0) - curve**2).max() > 0.1


def test_residuals_on_others_stop_falling_where_the_bends_end(sharp: Curves):
    scores = knot_scores(sharp, 24)
    rms = np.array([score.rms for score in scores])
    assert [score.knots for score in scores] == list(range(2, 25))
    assert rms[0] > 4.0 * rms[8]
    assert rms[-1] > 0.97 * rms.min()
    assert 6 <= fewest_knots(scores) <= 16


def test_the_fewest_knots_that_are_as_good():
    scores = tuple(KnotScore(n, rms) for n, rms in ((2, 9.0), (3, 5.05), (4, 4.99), (5, 5.0)))
    assert fewest_knots(scores) == 3


def test_every_method_is_scored_on_what_it_has_not_seen(sharp: Curves):
    scores = {score.method: score for score in method_scores(sharp, 10)}
    assert set(scores) == set(METHODS)
    # By hand for one method: leave a rank out, smooth the mean of the others.
    squares = []
    for rank in range(5):
        smooth = broken_line(sharp.t, sharp.mean_without(rank), np.array([2.0, 60.0, 120.0]))
        held = sharp.ranks == rank
        squares.append((sharp.y[held] - smooth[sharp.place[held]]) ** 2)
    by_hand = np.sqrt(np.mean(squares))
    assert by_hand > scores["table"].rms
    nothing = float(np.sqrt(np.mean(sharp.y**2)))
    assert scores["none"].rms == pytest.approx(nothing)
    assert scores["none"].by_temperature.shape == (11,)
    assert scores["none"].left.shape == (11, len(sharp.t))
    assert np.sqrt(np.mean(scores["none"].left ** 2)) == pytest.approx(nothing)
    assert score_of_knots(sharp, np.array([2.0, 60.0, 120.0])).rms == pytest.approx(by_hand)
    assert scores["table"].bytes == 240
    assert scores["angles"].bytes == 440


def test_no_repetition_no_score(make_turn_ons):
    lonely = curves_of(make_turn_ons(3, 1, np.array([0.0, 20.0])))
    assert knot_scores(lonely, 8) == ()
    assert method_scores(lonely, 8) == ()
    with pytest.raises(ValueError, match="repeated"):
        score_of_knots(lonely, np.array([2.0, 120.0]))


def test_a_table_is_tried_on_other_turn_ons(sharp: Curves, unseen: Curves, make_turn_ons):
    table = compensate(sharp, "deg/s", knots=10).table
    left = residuals_of(table, unseen)
    assert left.shape == unseen.y.shape
    assert np.sqrt(np.mean(left**2)) < 0.2 * np.sqrt(np.mean(unseen.y**2))
    with pytest.raises(FitError, match="outside the measured"):
        residuals_of(table, curves_of(make_turn_ons(4, 2, np.array([75.0]))))


def test_a_missing_temperature_is_replaced_by_its_neighbours(sharp: Curves):
    times = compensate(sharp, "deg/s", knots=10).table.times_s
    left = node_scores(sharp, times)
    assert np.isnan(left[[0, -1]]).all()
    by_temperature = method_scores(sharp, 10)[0].by_temperature
    assert np.all(left[1:-1] < 0.2 * by_temperature[1:-1])
    halved = curves_of_every_second(sharp)
    assert np.nanmean(node_scores(halved, times)) > np.nanmean(left)


def curves_of_every_second(curves: Curves) -> Curves:
    """Without every second temperature, so that gaps are twice as wide."""
    kept = curves.place % 2 == 0
    return replace(
        curves,
        y=curves.y[kept],
        place=curves.place[kept] // 2,
        labels=tuple(np.array(curves.labels)[kept]),
        start_c=curves.start_c[kept],
        chip_c=curves.chip_c[::2],
        temperatures_c=curves.temperatures_c[::2],
    )
