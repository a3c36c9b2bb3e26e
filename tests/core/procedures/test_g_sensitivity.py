"""g-sensitivity: Table 3.3, injected errors, and the Earth that goes one to one into it."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.fit.estimate import Estimate
from core.plans.orientation import BaseOrientation
from core.procedures.g_sensitivity import HeadSite, fit_g_sensitivity
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))
TABLE_3_3 = GOLDEN["source001"]["table_3_3"]
G = 9.8106
KYIV = Conditions(g_mps2=G, latitude_deg=50.45)
NOWHERE = Conditions(g_mps2=G)
FOUR = ([0.0, 90.0, 180.0, 270.0], ("X_from",) * 4)
EIGHT = ([0.0, 90.0, 180.0, 270.0] * 2, ("X_from",) * 4 + ("Y_from",) * 4)
# Table 3.1.
A_OVER_G = np.array(
    [[0, 0, 1], [0, -1, 0], [0, 0, -1], [0, 1, 0], [0, 0, 1], [1, 0, 0], [0, 0, -1], [-1, 0, 0]]
)
# The same positions with the shaft to the north: where X, Y, Z look; N W U and their opposites.
N, W, U = np.eye(3)
AXES_NWU = np.array(
    [
        [N, W, U], [N, -U, W], [N, -W, -U], [N, U, -W],
        [-W, N, U], [U, N, W], [W, N, -U], [-U, N, -W],
    ]
)  # fmt: skip
EARTH_DPH = 15.041067


def run_of(
    y: np.ndarray,
    positions: tuple[list[float], tuple[str, ...]] = EIGHT,
    *,
    se: float = math.nan,
    axes: tuple[str, ...] = ("z",),
    temperature: float = math.nan,
) -> Run:
    y = y[:, None] if y.ndim == 1 else y
    n, c = y.shape
    return plain_run(
        test="static_positions",
        sensor="gyro",
        device="Gyro31",
        channels=tuple(f"gyro_{i + 1}" for i in range(c)),
        axes=axes,
        y=y,
        y_se=np.full((n, c), se),
        mount=positions[1],
        head_deg=np.array(positions[0]),
        temperature_c=np.full(n, temperature),
    )


def sky(latitude: float) -> np.ndarray:
    """Rate of the Earth (8, 3) on the case axes, deg/s, shaft to the north."""
    phi = np.deg2rad(latitude)
    return AXES_NWU @ np.array([np.cos(phi), 0.0, np.sin(phi)]) * EARTH_DPH / 3600.0


def test_table_3_3():
    k = Estimate(-79.378668, 0.0062882, 9.0, "code/(deg/s)")
    y = np.array(TABLE_3_3["input"]["U"])
    found = fit_g_sensitivity(run_of(y, FOUR), NOWHERE, scale_factors={"gyro_1": k})
    sensor = found.sensors[0]
    assert sensor.axes == ("y", "z")  # (3.9): b_zx is not determined
    assert sensor.b("y").value == pytest.approx(TABLE_3_3["b_zy"], rel=1e-7)
    assert sensor.b("z").value == pytest.approx(TABLE_3_3["b_zz"], rel=1e-6)
    assert sensor.b("y").unit == "code/(m/s^2)"
    assert sensor.fit.value("bias") == pytest.approx(TABLE_3_3["U_0"], rel=1e-9)
    assert np.allclose(sensor.fit.residuals, TABLE_3_3["residuals"], atol=1e-9)
    golden = TABLE_3_3["with_k_z_from_table_3_2"]
    assert sensor.b_dps("y").value == pytest.approx(golden["b_zy_dps_per_mps2"], rel=1e-7)
    assert sensor.b_dps("z").value == pytest.approx(golden["b_zz_dps_per_mps2"], rel=1e-6)
    assert sensor.b_dps_per_g("y").value == pytest.approx(golden["b_zy_dps_per_g"], rel=1e-7)
    assert sensor.b_dps_per_g("z").value == pytest.approx(golden["b_zz_dps_per_g"], rel=1e-6)
    assert sensor.bias.value == pytest.approx(golden["bias_dps"], rel=1e-7)
    assert sensor.b_dph_per_g("z").value == pytest.approx(3600 * golden["b_zz_dps_per_g"], rel=1e-6)
    assert sensor.b_dph_per_g("z").unit == "(deg/h)/g"
    assert sensor.fit.dof == 1


def test_eight_positions_are_the_formulas_3_8():
    u = np.random.default_rng(1).normal(-700.0, 10.0, 8)
    sensor = fit_g_sensitivity(run_of(u), NOWHERE).sensors[0]
    assert sensor.b("x").value == pytest.approx((u[5] - u[7]) / (2 * G))
    assert sensor.b("y").value == pytest.approx((u[3] - u[1]) / (2 * G))
    assert sensor.b("z").value == pytest.approx((u[0] - u[2] + u[4] - u[6]) / (4 * G))
    assert sensor.fit.value("bias") == pytest.approx(u.mean())


@pytest.mark.parametrize("moved", range(4))
def test_one_injected_error_moves_only_its_parameter(moved: int):
    truth = np.array([-700.0, 0.4, -1.2, 0.3])
    change = np.zeros(4)
    change[moved] = 0.5
    design = np.column_stack([np.ones(8), G * A_OVER_G])
    before, after = (
        fit_g_sensitivity(run_of(design @ values), NOWHERE).sensors[0].fit.values
        for values in (truth, truth + change)
    )
    assert np.allclose(after - before, change, atol=1e-10)


def cvg(latitude: float, seed: int = 1) -> Run:
    """A gyro of 0.024 V/(deg/s) without any g-sensitivity, quiet enough to feel the Earth."""
    quiet = np.random.default_rng(seed).normal(0.0, 1e-7, 8)
    return run_of(0.01 + 0.024 * sky(latitude)[:, 2] + quiet, se=1e-7)


SLOPE = {"gyro_1": Estimate(0.024, 1e-7, math.inf, "V/(deg/s)")}
TO_THE_NORTH = HeadSite(azimuth_known=True)


def test_without_latitude_the_earth_is_taken_for_g_sensitivity():
    sensor = fit_g_sensitivity(cvg(50.45), NOWHERE, scale_factors=SLOPE).sensors[0]
    assert sensor.b_dph_per_g("z").value == pytest.approx(11.60, abs=0.02)
    (note,) = sensor.notes
    assert note.subject == "earth_rate"
    assert "b_zz of gyro_1" in note.text
    assert "15.0 deg/h" in note.text


def test_with_latitude_and_azimuth_nothing_is_left():
    sensor = fit_g_sensitivity(cvg(50.45), KYIV, TO_THE_NORTH, SLOPE).sensors[0]
    for axis in "xyz":
        found = sensor.b_dph_per_g(axis)
        assert abs(found.value) < 4 * found.u < 0.2
    assert sensor.bias.value == pytest.approx(0.01 / 0.024, abs=4e-6)
    assert sensor.notes == ()


def test_latitude_without_azimuth_leaves_the_level_part_and_says_so():
    sensor = fit_g_sensitivity(cvg(50.45), KYIV, scale_factors=SLOPE).sensors[0]
    assert abs(sensor.b_dph_per_g("z").value) < 0.1
    (note,) = sensor.notes
    assert note.subject == "earth_azimuth"
    assert "9.6 deg/h" in note.text


def test_the_azimuth_of_the_shaft_counts():
    wrong = HeadSite(BaseOrientation(psi_deg=90.0), azimuth_known=True)
    sensor = fit_g_sensitivity(cvg(50.45), KYIV, wrong, SLOPE).sensors[0]
    worst = max(abs(sensor.b_dph_per_g(axis).value) for axis in "xy")
    assert worst > 5.0


def test_a_stated_stability_decides_whether_the_earth_matters():
    coarse = HeadSite(bias_stability_dps=0.02)
    assert fit_g_sensitivity(cvg(50.45), NOWHERE, coarse, SLOPE).sensors[0].notes == ()
    noisy = run_of(np.random.default_rng(1).normal(0.0, 1.0, 8))
    k = {"gyro_1": Estimate(-79.4, 0.01, 9.0, "code/(deg/s)")}
    assert fit_g_sensitivity(noisy, NOWHERE, scale_factors=k).sensors[0].notes == ()
    fine = HeadSite(bias_stability_dps=1e-4)
    notes = fit_g_sensitivity(noisy, NOWHERE, fine, k).sensors[0].notes
    assert [note.subject for note in notes] == ["earth_rate"]


def test_without_a_scale_factor_codes_stay_codes():
    sensor = fit_g_sensitivity(run_of(np.arange(8.0)), NOWHERE).sensors[0]
    with pytest.raises(FitError, match="gyro_1: no scale factor"):
        sensor.b_dps("z")


def test_the_result_answers_by_name_and_exports():
    y = np.column_stack([np.arange(8.0), np.arange(8.0)[::-1]])
    run = run_of(y, axes=("x", "z"), temperature=25.0)
    found = fit_g_sensitivity(run, NOWHERE)
    assert found.sensor("gyro_2").axis == "z"
    assert found.temperature_c == 25.0
    with pytest.raises(KeyError):
        found.sensor("gyro_9")
    calibration = found.calibration()
    assert calibration.channels == ("gyro_1", "gyro_2")
    assert calibration.sensor == "gyro"
    assert calibration.provenance.device == "Gyro31"
    assert not calibration.is_triad
    names = calibration.fits[0].names
    assert names == ("bias", "g_sensitivity_x", "g_sensitivity_y", "g_sensitivity_z")


@pytest.mark.parametrize(
    ("run", "conditions", "says"),
    [
        (run_of(np.zeros((0, 1)), ([], ())), NOWHERE, "no rows"),
        (run_of(np.arange(8.0)), Conditions(), "gravity is missing"),
        (run_of(np.arange(3.0), ([30.0] * 3, ("X_from",) * 3)), NOWHERE, "acts alike"),
        (run_of(np.array([1.0, np.nan, 3, 4]), FOUR), NOWHERE, "row 2"),
    ],
)
def test_what_cannot_be_fitted_is_refused_in_words(run: Run, conditions: Conditions, says: str):
    with pytest.raises(FitError, match=says):
        fit_g_sensitivity(run, conditions)


def test_g_sensitivity_alone_makes_no_triad():
    y = np.random.default_rng(2).normal(size=(8, 3))
    found = fit_g_sensitivity(run_of(y, axes=("x", "y", "z")), NOWHERE)
    assert not found.calibration().is_triad
