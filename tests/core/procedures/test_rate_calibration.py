"""A rate-table result for the exports: single sensors, and a triad from three mountings."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.rate_calibration import calibration_of
from core.procedures.rate_table import calibrate_rate_table
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

RATES = np.array([-60.0, -40, -20, 0, 20, 40, 60])
K = np.array([[-79.0, 0.9, -0.4], [0.3, 81.0, 1.2], [-0.7, 0.2, -80.0]])
ZERO = np.array([10.0, -20.0, 30.0])
U_RATE = 0.1


def run_of(y: np.ndarray, rates: np.ndarray, mounts: tuple[str, ...], axes: tuple[str, ...]) -> Run:
    n, c = y.shape
    return plain_run(
        test="rate_table",
        sensor="gyro",
        channels=tuple(f"gyro_{i}" for i in range(c)),
        axes=axes,
        y=y,
        y_se=np.full((n, c), 0.5),
        mount=mounts,
        set_rate_dps=rates,
        temperature_c=np.full(n, 25.0),
    )


def three_mountings(rng: np.random.Generator) -> Run:
    along = np.repeat(np.eye(3), len(RATES), axis=0)
    rates = np.tile(RATES, 3)
    turned = rates + rng.normal(0.0, U_RATE, 21)
    y = ZERO + (along * turned[:, None]) @ K.T + rng.normal(0.0, 0.5, (21, 3))
    mounts = tuple(f"{axis}_from" for axis in "XYZ" for _ in RATES)
    return run_of(y, rates, mounts, ("x", "y", "z"))


def test_three_mountings_make_a_triad():
    run = three_mountings(np.random.default_rng(1))
    found = calibrate_rate_table(run, Conditions(rate_u_dps=U_RATE))
    calibration = calibration_of(found)
    assert calibration.is_triad
    assert calibration.temperature_c == 25.0
    assert calibration.provenance.device == "PW09"
    triad = calibration.triad()
    assert np.all(np.abs(triad.k - K) < 4 * triad.u_k())
    assert np.all(np.abs(triad.bias - ZERO) < 4 * triad.u_bias())
    symbols = {p.symbol for fit in calibration.fits for p in fit.parameters}
    assert symbols == {
        "U0",
        *(f"k_{i}" for i in "xyz"),
        *(f"k_{i}{j}" for i in "xyz" for j in "xyz" if i != j),
    }
    assert len(calibration.fits[0].residuals) == 21


def test_the_table_correlates_the_sensors_as_monte_carlo_has_it():
    conditions = Conditions(rate_u_dps=U_RATE)
    rng = np.random.default_rng(2)
    drawn = np.array(
        [
            calibration_of(calibrate_rate_table(three_mountings(rng), conditions)).triad().k[:, 0]
            for _ in range(300)
        ]
    )
    triad = calibration_of(calibrate_rate_table(three_mountings(rng), conditions)).triad()
    # The responses of all three sensors to the rate about x come from the same seven rows.
    places = [1, 5, 9]
    expected = triad.covariance[np.ix_(places, places)]
    scale = np.sqrt(np.diag(expected))
    assert np.allclose(drawn.std(axis=0), scale, rtol=0.15)
    assert np.corrcoef(drawn.T)[0, 1] == pytest.approx(
        expected[0, 1] / scale[0] / scale[1], abs=0.15
    )


def test_one_mounting_is_one_line_a_sensor():
    y = ZERO[:1] + K[0, 0] * RATES[:, None] + np.random.default_rng(3).normal(0.0, 0.5, (7, 1))
    found = calibrate_rate_table(run_of(y, RATES, ("",) * 7, ("z",)), Conditions())
    calibration = calibration_of(found)
    assert calibration.fits[0] is found.sensors[0].line.fit
    assert not calibration.is_triad
    with pytest.raises(FitError):
        calibration.triad()
