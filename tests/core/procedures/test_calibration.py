"""Derived quantities of a calibration: bias in input units, misalignment, their uncertainties."""

from dataclasses import replace

import numpy as np
import pytest

from core.arrays import frozen
from core.errors import FitError
from core.fit.result import FitResult
from core.model.effect import Parameter
from core.procedures.calibration import Calibration, Provenance
from core.samples.run import Conditions

NAMES = {"x": "yz", "y": "xz", "z": "xy"}
ROOT = np.random.default_rng(5).normal(size=(4, 4)) * 0.3
COVARIANCE = ROOT @ ROOT.T


def a_fit(axis: str, values: list[float]) -> FitResult:
    names = ["bias", "scale_factor", *(f"cross_axis_{other}" for other in NAMES[axis])]
    return FitResult(
        parameters=tuple(Parameter(name, name, "code") for name in names),
        values=frozen(values),
        covariance=frozen(COVARIANCE),
        shared=frozen(np.zeros((4, 1))),
        t_dof=frozen([4.0] * 4),
        fitted=frozen([]),
        residuals=frozen([]),
        sigma=frozen([]),
        free=frozen([]),
        sigma_source="residual",
        chi2=4.0,
        dof=4,
        p_value=float("nan"),
        condition=1.0,
        lack_of_fit=None,
        notes=(),
    )


def a_calibration() -> Calibration:
    return Calibration(
        sensor="accelerometer",
        unit="code",
        channels=("X", "Y", "Z"),
        axes=("x", "y", "z"),
        fits=(
            a_fit("x", [30.0, -1300.0, 12.0, -7.0]),
            a_fit("y", [10.0, 1310.0, 3.0, 4.0]),
            a_fit("z", [-20.0, 1320.0, 5.0, 6.0]),
        ),
        conditions=Conditions(g_mps2=9.81),
        temperature_c=25.0,
        notes=(),
        provenance=Provenance("test", "unit"),
    )


def test_bias_is_the_output_over_the_scale_factor() -> None:
    value, u = a_calibration().bias_in_input(0)
    assert value == pytest.approx(-30.0 / 1300.0)
    draws = np.random.default_rng(6).multivariate_normal(
        [30.0, -1300.0, 12.0, -7.0], COVARIANCE, 200000
    )
    assert u == pytest.approx(np.std(draws[:, 0] / draws[:, 1]), rel=0.01)


def test_misalignment_is_the_cross_axis_over_the_scale_factor() -> None:
    value, u = a_calibration().misalignment(0)
    np.testing.assert_allclose(value, [-12.0 / 1300.0, 7.0 / 1300.0])
    draws = np.random.default_rng(7).multivariate_normal(
        [30.0, -1300.0, 12.0, -7.0], COVARIANCE, 200000
    )
    np.testing.assert_allclose(u, np.std(draws[:, 2:] / draws[:, [1]], axis=0), rtol=0.01)


def test_three_sensors_are_a_triad_in_whatever_order_they_come() -> None:
    calibration = a_calibration()
    order = [2, 0, 1]
    shuffled = replace(
        calibration,
        channels=tuple(calibration.channels[i] for i in order),
        axes=tuple(calibration.axes[i] for i in order),
        fits=tuple(calibration.fits[i] for i in order),
    )
    np.testing.assert_array_equal(shuffled.triad().k, calibration.triad().k)
    np.testing.assert_array_equal(
        calibration.triad().k,
        [[-1300.0, 12.0, -7.0], [3.0, 1310.0, 4.0], [5.0, 6.0, 1320.0]],
    )


def test_two_sensors_are_none() -> None:
    calibration = a_calibration()
    two = replace(calibration, channels=("X", "Y"), axes=("x", "y"), fits=calibration.fits[:2])
    assert not two.is_triad
    with pytest.raises(FitError, match="three sensors"):
        two.triad()
