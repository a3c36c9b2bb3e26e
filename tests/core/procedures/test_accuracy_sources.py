"""Angles by a calibration against Monte Carlo, and the resolution of reported ones."""

from dataclasses import replace

import numpy as np
import pytest

from core.procedures.accuracy_sources import (
    PLANE,
    angle_uncertainty,
    codes_of,
    own_source,
    reported_sources,
)
from core.procedures.angle_errors import PITCH, ROLL
from core.procedures.attitude import attitude
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

G = 9.8106
K = np.array([[-1335.0, -13.0, -73.0], [36.0, -1339.0, 12.0], [1.0, 14.0, 1335.0]])


def run_of(y: np.ndarray, **changes) -> Run:
    n = len(y)
    unknown = np.full(n, np.nan)
    run = plain_run(
        test="accuracy",
        channels=("a", "b", "c"),
        y=y,
        mount=("X_from",) * 4 + ("Y_from",) * 4 if n == 8 else ("",) * n,
        head_deg=np.tile([0.0, 90.0, 180.0, 270.0], 2) if n == 8 else unknown,
    )
    return replace(run, **changes)


def test_codes_are_put_in_the_order_of_the_axes():
    y = np.arange(6.0).reshape(2, 3)
    codes = codes_of(run_of(y, axes=("z", "x", "y"), y_se=y / 10.0))
    assert codes is not None
    assert np.array_equal(codes.mean, y[:, [1, 2, 0]])
    assert np.array_equal(codes.se, y[:, [1, 2, 0]] / 10.0)
    assert np.isnan(codes.std).all()


def test_two_of_three_codes_are_none():
    run = run_of(np.ones((2, 3)), sensor="gyro", extra={"acc_x": np.ones(2), "acc_y": np.ones(2)})
    assert codes_of(run) is None


def test_noise_of_the_mean_and_of_samples_become_angles_as_monte_carlo_has_them():
    table_2_1 = np.array(
        [[0, 0, 1], [0, -1, 0], [0, 0, -1], [0, 1, 0], [0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0]]
    )
    calibration = calibrate(run_of(G * table_2_1 @ K.T), Conditions(g_mps2=G))
    a = G * np.array([[0.1, 0.5, 0.8], [0.0, -0.9, -0.3]])
    se = np.array([[2.0, 1.0, 0.5], [1.0, 3.0, 2.0]])
    extra = {f"std_acc_{axis}": 10.0 * se[:, i] for i, axis in enumerate("xyz")}
    codes = codes_of(run_of(a @ K.T, y_se=se, extra=extra))
    assert codes is not None
    source, _ = own_source(codes, calibration, "code")
    rng = np.random.default_rng(1)
    for row in range(2):
        y = codes.mean[row] + se[row] * rng.normal(size=(100_000, 3))
        drawn = attitude(y @ np.linalg.inv(K).T, np.zeros((len(y), 3, 3)))
        for name, angles in ((PITCH, drawn.pitch), (ROLL, drawn.roll), (PLANE, drawn.plane)):
            spread = np.rad2deg(np.std(np.unwrap(np.deg2rad(angles), period=2 * np.pi)))
            if name == ROLL and row == 1:
                continue  # drawn around the seam of 180 degrees
            assert source.u_mean[name][row] == pytest.approx(spread, rel=0.02), (name, row)
            assert source.noise[name][row] == pytest.approx(10.0 * spread, rel=0.02)


@pytest.mark.parametrize(
    ("angles", "step"),
    [([0.0, 30.0], 1.0), ([0.03, 30.02], 0.01), ([0.1, 0.118], 0.001), ([np.pi, np.e], 0.0)],
)
def test_the_resolution_of_reported_angles(angles: list[float], step: float):
    reported = np.array(angles)
    run = run_of(np.ones((2, 3)), extra={"unit_pitch_deg": reported, "unit_roll_deg": reported})
    (source,) = reported_sources(run)
    assert source.id == "inter"
    for name in (PITCH, ROLL, PLANE):
        assert np.allclose(source.u_mean[name], step / np.sqrt(12.0))
    assert np.isnan(source.heading).all()


def test_a_unit_without_pitch_or_roll_reports_nothing():
    assert reported_sources(run_of(np.ones((2, 3)), extra={"unit_pitch_deg": np.ones(2)})) == []


def test_uncertainties_by_name():
    found = angle_uncertainty(np.array([[0.0, 0.0, G]]), np.eye(3)[None] * 1e-4)
    assert set(found) == {PITCH, ROLL, PLANE}
    assert np.allclose([found[name][0] for name in found], np.rad2deg(0.01 / G))
