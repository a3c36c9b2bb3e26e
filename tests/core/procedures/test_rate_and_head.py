"""The whole model (3.3): a three-axis gyro with known K, zero, b and Earth rate is recovered."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.g_sensitivity import HeadSite
from core.procedures.rate_and_head import fit_rate_and_head
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]
G, LATITUDE = 9.8106, 50.45
EARTH = 15.041067 / 3600.0
UP, NORTH = EARTH * np.sin(np.deg2rad(LATITUDE)), EARTH * np.cos(np.deg2rad(LATITUDE))
SITE = HeadSite(azimuth_known=True)
RATES = np.array([-40.0, -25, -10, 0, 10, 25, 40])
HEAD_ANGLES = (0.0, 90.0, 180.0, 270.0)
# Table 3.1 with the shaft to the north: which way X, Y, Z look; north, west, up.
N, W, U = np.eye(3)
AXES_NWU = np.array(
    [
        [N, W, U], [N, -U, W], [N, -W, -U], [N, U, -W],
        [-W, N, U], [U, N, W], [W, N, -U], [-U, N, -W],
    ]
)  # fmt: skip

K = np.array([[0.0240, 3e-4, -2e-4], [1e-4, -0.0251, 2e-4], [-3e-4, 1e-4, 0.0238]])
ZERO = np.array([0.010, -0.020, 0.005])
B = np.array([[2e-5, -1e-5, 3e-5], [4e-6, 5e-6, -6e-6], [-2e-5, 1e-5, 7e-6]])


def run_of(
    test: str,
    y: np.ndarray,
    mounts: tuple[str, ...],
    *,
    head: np.ndarray | None = None,
    rates: np.ndarray | None = None,
    se: float = np.nan,
) -> Run:
    n = len(y)
    unknown = np.full(n, np.nan)
    return plain_run(
        test=test,
        sensor="gyro",
        device="25-143",
        channels=("rate_x", "rate_y", "rate_z"),
        unit="V",
        y=y,
        y_se=np.full((n, 3), se),
        mount=mounts,
        head_deg=unknown if head is None else head,
        set_rate_dps=unknown if rates is None else rates,
    )


def answer(a: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Model (3.3), written out."""
    return ZERO + w @ K.T + a @ B.T


def table_run(slip: np.ndarray, noise: np.ndarray, se: float) -> Run:
    """Seven rates about each axis in turn, the axis up; `slip` (21,) is the table's error."""
    along = np.repeat(np.eye(3), len(RATES), axis=0)
    set_rates = np.tile(RATES, 3)
    y = answer(G * along, along * (set_rates + slip + UP)[:, None]) + noise
    mounts = tuple(f"{axis}_from" for axis in "XYZ" for _ in RATES)
    return run_of("rate_table", y, mounts, rates=set_rates, se=se)


def head_run(noise: np.ndarray, se: float, times: int = 2) -> Run:
    axes = np.tile(AXES_NWU, (times, 1, 1))
    y = answer(G * axes @ U, axes @ (NORTH * N + UP * U)) + noise
    mounts = (("X_from",) * 4 + ("Y_from",) * 4) * times
    return run_of("static_positions", y, mounts, head=np.tile(HEAD_ANGLES, 2 * times), se=se)


def exact() -> tuple[Run, Run]:
    return table_run(np.zeros(21), np.zeros((21, 3)), 1e-7), head_run(np.zeros((16, 3)), 1e-7)


TRUTH = {
    axis: {
        "bias": ZERO[i],
        "scale_factor": K[i, i],
        **{f"cross_axis_{'xyz'[j]}": K[i, j] for j in range(3) if j != i},
        **{f"g_sensitivity_{'xyz'[j]}": B[i, j] for j in range(3)},
    }
    for i, axis in enumerate("xyz")
}


def test_exact_data_give_the_truth():
    found = fit_rate_and_head(*exact(), Conditions(g_mps2=G, latitude_deg=LATITUDE), SITE)
    for sensor in found.sensors:
        assert set(sensor.fit.names) == set(TRUTH[sensor.axis])
        for name, value in TRUTH[sensor.axis].items():
            assert sensor.fit.value(name) == pytest.approx(value, abs=1e-11), name
        assert sensor.notes == ()
    assert found.procedure.endswith("(3.3)")


def test_the_result_is_a_triad_for_the_exports():
    found = fit_rate_and_head(*exact(), Conditions(g_mps2=G, latitude_deg=LATITUDE), SITE)
    triad = found.calibration().triad()
    assert np.allclose(triad.k, K, atol=1e-11)
    assert np.allclose(triad.bias, ZERO, atol=1e-11)


def test_left_out_the_earth_goes_into_zero_and_g_sensitivity():
    found = fit_rate_and_head(*exact(), Conditions(g_mps2=G), SITE).sensor("rate_z")
    assert found.b_dph_per_g("z").value == pytest.approx(
        B[2, 2] / K[2, 2] * G * 3600.0 + 11.60, abs=0.05
    )
    assert "earth_rate" in [note.subject for note in found.notes]


def test_a_table_that_only_turned_about_z_leaves_the_cross_axes_out():
    table, head = exact()
    about_z = table.rows(range(14, 21))
    about_z = replace(
        about_z, channels=("rate_z",), axes=("z",), y=about_z.y[:, 2:], y_se=about_z.y_se[:, 2:]
    )
    conditions = Conditions(g_mps2=G, latitude_deg=LATITUDE)
    (sensor,) = fit_rate_and_head(about_z, head, conditions, SITE).sensors
    assert sensor.channel == "rate_z"
    assert not [name for name in sensor.fit.names if name.startswith("cross")]
    assert sensor.fit.value("scale_factor") == pytest.approx(K[2, 2], rel=1e-4)


def test_tables_3_2_and_3_3_are_refused_unless_the_operator_insists():
    rates, u = (np.array(GOLDEN["table_3_2"]["input"][key]) for key in ("omega_dps", "U"))
    one = {"channels": ("gyro_1",), "axes": ("z",), "unit": "code"}
    table = run_of("rate_table", np.tile(u[:, None], 3), ("",) * 11, rates=rates)
    table = replace(table, **one, y=table.y[:, :1], y_se=table.y_se[:, :1], device="ADXRS610")
    u = np.array(GOLDEN["table_3_3"]["input"]["U"])
    head = run_of(
        "static_positions", np.tile(u[:, None], 3), ("X_from",) * 4, head=np.array(HEAD_ANGLES)
    )
    head = replace(head, **one, y=head.y[:, :1], y_se=head.y_se[:, :1], device="Gyro31")
    conditions = Conditions(g_mps2=G)
    with pytest.raises(FitError, match=r"'ADXRS610'.*'Gyro31'.*-3\.53 deg/s"):
        fit_rate_and_head(table, head, conditions)
    (sensor,) = fit_rate_and_head(table, head, conditions, same_unit=True).sensors
    assert {note.subject for note in sensor.notes} == {"different_units", "zero_differs"}


def test_runs_without_a_common_output_or_unit_are_refused():
    table, head = exact()
    conditions = Conditions(g_mps2=G)
    with pytest.raises(FitError, match="table run is in code, the head run in V"):
        fit_rate_and_head(replace(table, unit="code"), head, conditions)
    with pytest.raises(FitError, match="no output stands in both"):
        fit_rate_and_head(replace(table, channels=("a", "b", "c")), head, conditions)


def test_a_sensor_that_was_dead_on_the_table_is_named():
    table, head = exact()
    y = table.y.copy()
    y[:, 1] = 0.0
    with pytest.raises(FitError, match="rate_y did not answer"):
        fit_rate_and_head(replace(table, y=y), head, Conditions(g_mps2=G))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("slip", "stated", "known"),
    [(0.0, False, True), (0.05, True, True), (0.0, False, False)],
    ids=["good table", "worn table", "no standard errors"],
)
def test_intervals_cover_the_truth_of_a_three_axis_gyro(slip: float, stated: bool, known: bool):
    rng = np.random.default_rng(33)
    noise = 2e-5
    conditions = Conditions(
        g_mps2=G, latitude_deg=LATITUDE, rate_u_dps=slip if stated else float("nan")
    )
    trials = 1000
    inside = {axis: dict.fromkeys(TRUTH[axis], 0) for axis in "xyz"}
    for _ in range(trials):
        table = table_run(rng.normal(0.0, slip, 21), rng.normal(0.0, noise, (21, 3)), noise)
        head = head_run(rng.normal(0.0, noise, (16, 3)), noise)
        if not known:
            table = replace(table, y_se=np.full((21, 3), np.nan))
            head = replace(head, y_se=np.full((16, 3), np.nan))
        for sensor in fit_rate_and_head(table, head, conditions, SITE).sensors:
            for name, half in zip(sensor.fit.names, sensor.fit.expanded(), strict=True):
                error = sensor.fit.value(name) - TRUTH[sensor.axis][name]
                inside[sensor.axis][name] += abs(error) < half
    shares = np.array([[count / trials for count in inside[axis].values()] for axis in "xyz"])
    assert np.all((shares > 0.93) & (shares < 0.97)), shares
