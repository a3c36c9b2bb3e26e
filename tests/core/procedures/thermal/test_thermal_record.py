"""The public record through and through; coverage with errors that have memory."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.thermal.record import fit_record, residuals
from core.samples.run import Run
from tests.plain_run import plain_run


def test_the_public_record_as_published(rates: Run, forces: Run):
    gyros, accelerometers = fit_record(rates, order=3), fit_record(forces, order=3)
    explained = [trend.explained for trend in (*gyros.trends, *accelerometers.trends)]
    assert explained == pytest.approx([0.570, 0.997, 0.535, 0.982, 0.881, 0.945], abs=6e-4)
    assert "one_orientation" in [note.subject for note in accelerometers.notes]
    assert "one_orientation" not in [note.subject for note in gyros.notes]
    left = residuals(rates, gyros)
    assert left.std(axis=0) == pytest.approx([trend.rms_after for trend in gyros.trends])


def test_orders_are_chosen_and_hysteresis_is_said(rates: Run):
    result = fit_record(rates)
    y = result.trends[1]
    assert y.order == 3
    assert [score.bias for score in y.scores] == list(range(6))
    assert y.scores[3].rms < 0.3 * y.scores[1].rms
    x = result.trends[0]
    assert abs(x.hysteresis.value) > x.rms_after
    assert sum(note.subject == "hysteresis" for note in result.notes) == 3


def test_scores_are_those_of_leaving_out(rates: Run):
    """The sums over stretches against refitting by hand."""
    run = rates.rows(np.arange(0, 8400, 20))
    (_, y, _), t = fit_record(run).trends, run.temperature_c
    bins = np.minimum((t - t.min()) / np.ptp(t) * 12, 11).astype(int)
    squares, count = 0.0, 0
    for fold in range(1, 11):
        held = bins == fold
        fit = np.polynomial.Polynomial.fit(t[~held], run.y[~held, 1], 3)
        squares += np.sum((run.y[held, 1] - fit(t[held])) ** 2)
        count += held.sum()
    assert y.scores[3].rms == pytest.approx(np.sqrt(squares / count), rel=1e-6)


def test_the_polynomial_is_refused_outside(rates: Run):
    trend = fit_record(rates).trends[1]
    inside = trend.at(np.array([0.0, 40.0]))
    t = np.array([0.0, 40.0]) - trend.reference_c
    by_hand = sum(one.value * t**power for power, one in enumerate(trend.coefficients))
    assert inside == pytest.approx(by_hand)
    with pytest.raises(FitError, match=r"85\.0 degC is outside the measured -17\.6 \.\.\. 74\.0"):
        trend.at(np.array([20.0, 85.0]))
    assert np.isfinite(trend.at(np.array([85.0]), extrapolate=True)).all()


def test_what_cannot_be_fitted_is_refused(rates: Run):
    flat = replace(rates, temperature_c=20.0 + 0.01 * np.sin(np.arange(8400.0)))
    with pytest.raises(FitError, match="needs a span of 5 degC"):
        fit_record(flat)
    with pytest.raises(FitError, match="50 rows"):
        fit_record(rates.rows(range(50)))
    broken = np.array(rates.temperature_c)
    broken[7] = np.nan
    with pytest.raises(FitError, match="row 8: the temperature is not a number"):
        fit_record(replace(rates, temperature_c=broken))
    with pytest.raises(FitError, match="order 9"):
        fit_record(rates, order=9)


def test_a_one_way_ramp_has_no_hysteresis():
    n = 2000
    t = np.linspace(-20.0, 60.0, n)
    result = fit_record(ramp(t, 0.01 * t[:, None]))
    assert np.isnan(result.trends[0].hysteresis.value)
    assert result.notes == ()
    assert result.trends[0].coefficients[1].value == pytest.approx(0.01)


def ramp(t: np.ndarray, y: np.ndarray) -> Run:
    n = len(t)
    return plain_run(
        test="record",
        sensor="gyro",
        device="",
        channels=("w",),
        axes=("z",),
        unit="deg/s",
        y=y,
        temperature_c=t,
        t_s=np.arange(n, dtype=float),
    )


@pytest.mark.slow
def test_intervals_hold_the_truth_though_errors_have_memory():
    rng = np.random.default_rng(5)
    n, trials, memory = 3000, 400, 0.9
    t = 25.0 + 40.0 * np.sin(np.linspace(0.0, 6.0, n))
    hits = np.zeros(3)
    for _ in range(trials):
        white = rng.standard_normal(n + 100)
        noise = np.convolve(white, memory ** np.arange(60))[100 : n + 100]
        run = ramp(t, (1.0 + 0.02 * (t - 25) + 1e-4 * (t - 25) ** 2 + 0.1 * noise)[:, None])
        trend = fit_record(run, order=2).trends[0]
        assert trend.reference_c == 25.0
        truth = (1.0, 0.02, 1e-4)
        pairs = zip(trend.coefficients, truth, strict=True)
        hits += [abs(one.value - true) < one.expanded() for one, true in pairs]
    assert np.all((hits / trials > 0.92) & (hits / trials < 0.98))
