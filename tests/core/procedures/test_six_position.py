"""RQ split, the source's nine parameters with the sign corrected, the public six-pose record."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.six_position import (
    SixPosition,
    calibrate_six,
    joined_k,
    rotation_vector,
    split_k,
)
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

G = 9.8106
CASE = Conditions(g_mps2=G)
DATA = Path(__file__).parents[2] / "data" / "imucal_ferraris"
STEPS = load_plans()["six_positions"].steps
UP = np.array([[0, 0, 1], [0, -1, 0], [0, 0, -1], [0, 1, 0], [1, 0, 0], [-1, 0, 0]], dtype=float)
"""Which way the specific force points in the plan's positions, by hand."""


def turned(about: np.ndarray, angle_deg: float) -> np.ndarray:
    """Rodrigues: components of a fixed vector in axes that were turned."""
    axis = about / np.linalg.norm(about)
    cross = np.cross(np.eye(3), axis)
    angle = np.radians(angle_deg)
    return np.eye(3) - np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def matrix_t(yz: float, zy: float, zx: float) -> np.ndarray:
    """T as the source prints it."""
    return np.array([[1.0, -yz, zy], [0.0, 1.0, -zx], [0.0, 0.0, 1.0]])


def run_of(y: np.ndarray, se: float = np.nan, repeats: int = 1) -> Run:
    n = len(y)
    steps = STEPS * repeats
    return plain_run(
        device="MPU",
        channels=("ax", "ay", "az"),
        y=y,
        y_se=np.full((n, 3), se),
        run=np.arange(n) // 6 + 1,
        mount=tuple(step.mount for step in steps),
        head_deg=np.array([step.head_deg for step in steps]),
    )


def measured(k: np.ndarray, bias: np.ndarray, noise: float = 0.0, repeats: int = 1, seed: int = 0):
    exact = np.tile(G * UP @ k.T + bias, (repeats, 1))
    y = exact + noise * np.random.default_rng(seed).standard_normal(exact.shape)
    return run_of(y, noise or np.nan, repeats)


SCALE, SKEW = np.array([800.0, -820.0, 790.0]), np.array([0.01, 0.02, -0.015])
MOUNT = turned(np.array([1.0, -2.0, 0.5]), 1.2)
BIAS = np.array([30.0, -12.0, 55.0])
K = np.diag(SCALE) @ np.linalg.inv(matrix_t(*SKEW)) @ MOUNT


def estimates(found: SixPosition) -> list:
    skew = found.skew
    return [*found.scale, skew.yz, skew.zy, skew.zx, *found.mounting]


def test_k_is_split_and_joined_to_the_last_digit():
    scale, skew, rotation = split_k(K)
    assert scale == pytest.approx(SCALE, rel=1e-13)
    assert skew == pytest.approx(SKEW, abs=1e-14)
    assert rotation == pytest.approx(MOUNT, abs=1e-14)
    assert joined_k(scale, skew, rotation) == pytest.approx(K, abs=1e-10)


def test_a_rotation_vector_is_axis_times_angle():
    about = np.array([2.0, -1.0, 2.0]) / 3.0
    assert rotation_vector(turned(about, 25.0)) == pytest.approx(np.radians(25.0) * about)
    assert rotation_vector(np.eye(3)) == pytest.approx(np.zeros(3))


def test_every_parameter_of_the_source_comes_back():
    found = calibrate_six(measured(K, BIAS), CASE)
    values = [one.value for one in estimates(found)]
    mounting = 1.2 * np.array([1.0, -2.0, 0.5]) / np.linalg.norm([1.0, -2.0, 0.5])
    assert values == pytest.approx([*SCALE, *np.degrees(SKEW), *mounting], rel=1e-9)
    assert found.triad.bias == pytest.approx(BIAS)
    assert found.residual_mg == pytest.approx(np.zeros(3), abs=1e-9)


def test_the_sign_that_the_source_lost():
    true = (0.01, 0.02, -0.015)
    upper = np.diag(np.abs(SCALE)) @ np.linalg.inv(matrix_t(*true))
    found = calibrate_six(measured(upper, BIAS), CASE)
    assert np.radians(found.nine.skew_deg) == pytest.approx(true, abs=1e-12)
    assert found.nine.residual_mg == pytest.approx(np.zeros(3), abs=1e-9)
    # alpha_zy = p_x4/p_x2 + alpha_yz alpha_zx as printed misses by twice its size.
    x = found.nine.fits[0]
    printed = x.value("cross_axis_z") / x.value("scale_factor") + true[0] * true[2]
    assert printed == pytest.approx(-0.0203, abs=1e-4)


@pytest.mark.parametrize(("angle", "low", "high"), [(0.5, 4.0, 9.0), (2.0, 16.0, 36.0)])
def test_nine_parameters_have_no_mounting(angle: float, low: float, high: float):
    k = np.diag(np.abs(SCALE)) @ turned(np.array([1.0, 1.0, 1.0]), angle)
    found = calibrate_six(measured(k, BIAS), CASE)
    assert low < found.nine.residual_mg.max() < high
    assert found.residual_mg.max() < 1e-6
    (note,) = found.notes
    assert note.subject == "nine_parameters"
    assert f"turned by {angle:.3g} deg" in note.text


def test_without_mounting_the_forms_agree():
    upper = np.diag(SCALE) @ np.linalg.inv(matrix_t(*SKEW))
    assert calibrate_six(measured(upper, BIAS, 0.5, 4), CASE).notes == ()


def public_record() -> tuple[Run, dict]:
    with (DATA / "static_accelerometer.csv").open(encoding="utf-8") as file:
        rows = [
            (row["part"], *(float(row[f"acc_{a}"]) for a in "xyz")) for row in csv.DictReader(file)
        ]
    parts = ("z_p", "y_a", "z_a", "y_p", "x_p", "x_a")
    pieces = [np.array([row[1:] for row in rows if row[0] == part]) for part in parts]
    run = run_of(np.array([piece.mean(axis=0) for piece in pieces]))
    errors = np.array([piece.std(axis=0) / np.sqrt(len(piece)) for piece in pieces])
    return replace(run, y_se=errors), json.loads((DATA / "example_cal.json").read_text("utf-8"))


def test_the_public_six_pose_record():
    run, published = public_record()
    found = calibrate_six(replace(run, y_se=np.full((6, 3), np.nan)), Conditions(g_mps2=9.81))
    expected = np.array(published["K_a"]) @ np.array(published["R_a"])
    assert found.triad.k == pytest.approx(expected, rel=1e-12, abs=1e-10)
    # The published bias is that of each axis' own two poses; the fit uses all six.
    assert found.triad.bias == pytest.approx([-7.8739, -55.9432, -31.0309], abs=1e-3)
    pairs = [(run.y[4, 0] + run.y[5, 0]) / 2, (run.y[1, 1] + run.y[3, 1]) / 2]
    assert pairs == pytest.approx(published["b_a"][:2])
    assert "nine_parameters" in [note.subject for note in found.notes]
    assert all(one.u > 0 for one in estimates(found))
    # Each pose's own noise hides what was different between them; it must be found.
    honest = calibrate_six(run, Conditions(g_mps2=9.81, repeatability=np.nan))
    assert honest.triad.k == pytest.approx(expected, abs=2e-3)
    assert honest.calibration.fits[0].sigma_source == "partly"


def test_no_triad_is_refused():
    run = measured(K, BIAS)
    with pytest.raises(FitError, match="Q needs three sensors"):
        calibrate_six(replace(run, axes=("x", "y", "y")), CASE)
    with pytest.raises(FitError, match="not determined: k_x"):
        calibrate_six(run.rows([0, 1, 2, 3]), CASE)


@pytest.mark.slow
def test_intervals_hold_the_truth():
    mounting = 1.2 * np.array([1.0, -2.0, 0.5]) / np.linalg.norm([1.0, -2.0, 0.5])
    truth = np.array([*SCALE, *np.degrees(SKEW), *mounting])
    trials, hits = 400, np.zeros(9)
    for seed in range(trials):
        found = estimates(calibrate_six(measured(K, BIAS, 3.0, 2, seed), CASE))
        hits += [abs(one.value - t) < one.expanded() for one, t in zip(found, truth, strict=True)]
    assert 0.93 < np.mean(hits / trials) < 0.97
    assert np.all((hits / trials > 0.915) & (hits / trials < 0.98))
