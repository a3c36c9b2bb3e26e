"""One injected error moves one parameter; what cannot be known is said by name."""

import json
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.fit.linear import Rows, fit_sensor
from core.fit.result import FitResult
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

G = 9.8106
GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))[
    "source001"
]
NOTHING = Conditions()
# Practicum, Table 2.1: X from, then Y from, at 0, 90, 180, 270 degrees.
TABLE_2_1 = np.array(GOLDEN["table_2_2"]["input"]["a_over_g"])
# What a quarter turn of the head further on gives: the derivative by the head angle.
AHEAD = TABLE_2_1[[1, 2, 3, 0, 5, 6, 7, 4]]


def accelerometer(axis: str = "z", *effects: str) -> SensorModel:
    chosen = effects or ("bias", "scale_factor", "cross_axis")
    return SensorModel(Sensor("accelerometer", axis, "code"), tuple(CATALOGUE[e] for e in chosen))


def head(rows: slice = slice(None), times: int = 1) -> Stimulus:
    a, ahead = (np.tile(x[rows] * G, (times, 1)) for x in (TABLE_2_1, AHEAD))
    return Stimulus(a, np.zeros_like(a), ahead, np.zeros_like(a))


def table(rates: np.ndarray) -> Stimulus:
    along = np.zeros((len(rates), 3))
    along[:, 2] = 1.0
    return Stimulus(along * G, along * rates[:, None], 0.0 * along, along, {"set_rate_dps": rates})


def gyro() -> SensorModel:
    effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"])
    return SensorModel(Sensor("gyro", "z", "code"), effects)


TRUTH = np.array([50.0, 1330.0, -7.0, 3.0])


@pytest.mark.parametrize("moved", range(4))
@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_one_injected_error_moves_only_its_parameter(axis: str, moved: int):
    model = accelerometer(axis)
    change = np.zeros(4)
    change[moved] = 0.37
    before = fit_sensor(model, head(), Rows.of(model.predict(head(), TRUTH)), NOTHING)
    after = fit_sensor(model, head(), Rows.of(model.predict(head(), TRUTH + change)), NOTHING)
    assert np.allclose(after.values - before.values, change, atol=1e-11)


def test_table_1_2():
    golden = GOLDEN["table_1_2"]
    y = Rows.of(np.array(golden["input"]["U"]))
    with pytest.raises(RankDeficient, match="4 rows") as raised:
        fit_sensor(accelerometer(), head(slice(0, 4)), y, NOTHING)
    assert raised.value.free == ("k_zx",)
    effects = (CATALOGUE["bias"], CATALOGUE["scale_factor"], CrossAxis("y"))
    model = SensorModel(Sensor("accelerometer", "z", "code"), effects)
    fit = fit_sensor(model, head(slice(0, 4)), y, NOTHING)
    expected = [golden["U_az0"], golden["k_z"], golden["k_zy"]]
    assert np.allclose(fit.values, expected, rtol=1e-7)
    assert np.allclose(fit.residuals, golden["residuals"], rtol=1e-7)
    assert np.sum(fit.residuals**2) == pytest.approx(golden["rss"], rel=1e-7)
    assert fit.dof == 1


def test_table_2_2():
    golden = GOLDEN["table_2_2"]
    for i, axis in enumerate("xyz"):
        y = np.array(golden["input"][f"U_a{axis}"])
        fit = fit_sensor(accelerometer(axis), head(), Rows.of(y), NOTHING)
        row = np.array(golden["K"][i])
        assert fit.value("bias") == pytest.approx(golden["U0"][i], rel=1e-7)
        assert fit.value("scale_factor") == pytest.approx(row[i], rel=1e-7)
        for j, name in enumerate("xyz"):
            if j != i:
                assert fit.value(f"cross_axis_{name}") == pytest.approx(row[j], rel=1e-7)
        s = golden["residual_sd"][i]
        assert np.sqrt(np.sum(fit.residuals**2) / fit.dof) == pytest.approx(s, rel=1e-7)
        assert fit.u("bias") == pytest.approx(golden["u_std_ols"]["U0"][i], rel=1e-7)
        assert fit.u("scale_factor") == pytest.approx(
            golden["u_std_ols"]["k_diag_x_y" if axis != "z" else "k_z_column"][i], rel=1e-7
        )
        assert np.allclose(fit.residuals, np.array(golden["residuals"])[:, i], atol=6e-5)
        assert fit.lack_of_fit is not None
        assert fit.lack_of_fit.pure_sd == pytest.approx(golden["pure_error_sd"][i], rel=1e-7)
        assert fit.lack_of_fit.p_value > 0.05
        assert fit.sigma_source == "residual"
        assert fit.dof == 4
        assert np.all(fit.t_dof == 4)
        assert np.isnan(fit.p_value)


@pytest.mark.parametrize(
    ("rows", "free"),
    [
        (slice(0, 2), {"U0", "k_z", "k_zx", "k_zy"}),
        (slice(0, 3), {"k_zx"}),
        (slice(0, 3, 2), {"k_zx", "k_zy"}),
        (slice(4, 8), {"k_zy"}),
    ],
)
def test_too_few_positions_name_what_stays_free(rows: slice, free: set[str]):
    y = np.arange(len(TABLE_2_1[rows]), dtype=float)
    with pytest.raises(RankDeficient) as raised:
        fit_sensor(accelerometer(), head(rows), Rows.of(y), NOTHING)
    assert set(raised.value.free) == free


def test_equal_rates_leave_the_bias_and_the_scale_factor_free():
    rates = np.full(5, 20.0)
    with pytest.raises(RankDeficient) as raised:
        fit_sensor(gyro(), table(rates), Rows.of(rates), NOTHING)
    assert raised.value.free == ("U0", "k_z")


def test_as_many_rows_as_parameters_have_no_uncertainty():
    rates = np.array([-50.0, 50.0])
    fit = fit_sensor(gyro(), table(rates), Rows.of(3.0 + 2.0 * rates), NOTHING)
    assert np.allclose(fit.values, [3.0, 2.0])
    assert fit.sigma_source == "none"
    assert np.all(np.isnan(fit.stderr))
    assert [note.subject for note in fit.notes] == ["no_uncertainty"]


def test_an_unknown_drift_that_no_residual_can_show_is_told():
    rates = np.array([-50.0, 50.0])
    rows = Rows.of(3.0 + 2.0 * rates, np.ones(2))
    fit = fit_sensor(gyro(), table(rates), rows, Conditions(repeatability=np.nan))
    assert fit.u("bias") == pytest.approx(np.sqrt(0.5))
    assert [note.subject for note in fit.notes] == ["no_check"]


def test_two_rates_with_known_errors_have_an_uncertainty_and_no_test():
    rates = np.array([-50.0, 50.0])
    fit = fit_sensor(gyro(), table(rates), Rows.of(2.0 * rates, np.array([0.3, 0.4])), NOTHING)
    assert fit.u("scale_factor") == pytest.approx(0.5 / 100.0)
    assert np.isnan(fit.p_value)
    assert fit.notes == ()


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_an_output_that_is_no_number_is_refused_with_its_row(bad: float):
    y = np.zeros(8)
    y[4] = bad
    with pytest.raises(FitError, match="row 5"):
        fit_sensor(accelerometer(), head(), Rows.of(y), NOTHING)


def test_an_unknown_input_is_refused_by_parameter():
    stimulus = table(np.array([-1.0, 0.0, 1.0]))
    stimulus.a[:] = np.nan
    model = gyro().with_effect(CATALOGUE["g_sensitivity"])
    with pytest.raises(FitError, match="b_zx, b_zy, b_zz"):
        fit_sensor(model, stimulus, Rows.of(np.zeros(3)), NOTHING)


def test_exact_data_give_exact_parameters_and_tiny_uncertainties():
    y = accelerometer().predict(head(times=2), TRUTH)
    fit = fit_sensor(accelerometer(), head(times=2), Rows.of(y), NOTHING)
    assert np.allclose(fit.values, TRUTH, rtol=1e-14)
    assert np.all(fit.stderr < 1e-10)
    assert np.all(fit.stderr > 0)


def test_known_errors_weight_the_rows():
    rates = np.array([-1.0, 0.0, 1.0])
    se = np.array([1.0, 1e3, 1.0])
    fit = fit_sensor(gyro(), table(rates), Rows.of(np.array([0.0, 500.0, 2.0]), se), NOTHING)
    assert fit.value("scale_factor") == pytest.approx(1.0)
    assert fit.value("bias") == pytest.approx(1.0, abs=1e-3)
    assert fit.u("scale_factor") == pytest.approx(np.sqrt(0.5))
    assert np.all(np.isinf(fit.t_dof))


def test_a_rejected_model_enlarges_its_uncertainties_and_says_so():
    rates = np.linspace(-100.0, 100.0, 11)
    y = 2.0 * rates + 1e-3 * rates**2
    fit = fit_sensor(gyro(), table(rates), Rows.of(y, np.full(11, 0.1)), NOTHING)
    plain = fit_sensor(gyro(), table(rates), Rows.of(y), NOTHING)
    assert fit.p_value < 1e-6
    assert [note.subject for note in fit.notes] == ["model_rejected"]
    assert np.allclose(fit.stderr, plain.stderr)
    assert np.all(fit.t_dof == 9)


def test_the_head_error_acts_where_the_output_changes_with_the_angle():
    arcsec = 10.0
    y = accelerometer().predict(head(), TRUTH)
    known = Rows.of(y, np.full(8, 1e-6))
    fit = fit_sensor(accelerometer(), head(), known, Conditions(head_u_arcsec=arcsec))
    # Z up or down: the angle changes nothing but the small cross term.
    slope = TRUTH[1] * G * arcsec / 206264.806
    assert np.allclose(fit.sigma[[1, 3, 5, 7]], slope, rtol=1e-6)
    assert np.all(fit.sigma[[0, 2, 4, 6]] < 0.01 * slope)
    # Cross terms: u_a / sqrt(2) of the scale factor, METROLOGY of the practicum's eight positions.
    expected = TRUTH[1] * arcsec / 206264.806 / np.sqrt(2.0)
    assert fit.u("cross_axis_x") == pytest.approx(expected, rel=1e-4)
    assert fit.shared.shape == (4, 17)
    part = fit.shared @ fit.shared.T
    assert np.allclose(part, fit.covariance, rtol=1e-6)


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        (Conditions(rate_u_dps=0.2), lambda rates: np.full(11, 0.2)),
        (Conditions(rate_u_ppm=500.0), lambda rates: 5e-4 * np.abs(rates)),
        (
            Conditions(rate_u_dps=0.2, rate_u_ppm=500.0),
            lambda rates: np.hypot(0.2, 5e-4 * np.abs(rates)),
        ),
    ],
)
def test_the_error_of_a_worn_table_is_effective_variance(conditions: Conditions, expected):
    rates = np.linspace(-100.0, 100.0, 11)
    y = -438.0 - 79.4 * rates
    fit = fit_sensor(gyro(), table(rates), Rows.of(y, np.full(11, 1.3)), conditions)
    assert np.allclose(fit.sigma, np.hypot(1.3, 79.4 * expected(rates)), rtol=1e-9)


def test_the_uncertainty_of_g_is_common_to_all_rows():
    u_g = 1e-3
    y = accelerometer().predict(head(), TRUTH)
    fit = fit_sensor(
        accelerometer(),
        head(),
        Rows.of(y, np.full(8, 1e-9)),
        Conditions(g_mps2=G, u_g_mps2=u_g),
    )
    assert np.allclose(fit.stderr[1:], np.abs(TRUTH[1:]) * u_g / G, rtol=1e-4)
    assert fit.u("bias") < 1e-6
    correlation = fit.correlation
    assert correlation[1, 2] == pytest.approx(-1.0, abs=1e-6)
    assert correlation[1, 3] == pytest.approx(1.0, abs=1e-6)


def test_repeated_rows_tell_a_lack_of_fit():
    rates = np.tile(np.linspace(-100.0, 100.0, 11), 2)
    noise = np.random.default_rng(5).normal(0.0, 0.3, 22)
    y = 2.0 * rates + 3e-4 * rates**2 + noise
    fit = fit_sensor(gyro(), table(rates), Rows.of(y), NOTHING)
    assert "lack_of_fit" in [note.subject for note in fit.notes]
    straight = fit_sensor(gyro(), table(rates), Rows.of(2.0 * rates + noise), NOTHING)
    assert straight.notes == ()


def test_few_degrees_of_freedom_of_the_errors_reach_the_parameters():
    rates = np.linspace(-100.0, 100.0, 11)
    y, se = 2.0 * rates, np.full(11, 0.5)
    fit = fit_sensor(gyro(), table(rates), Rows(y, se, np.full(11, 5.0)), NOTHING)
    well = fit_sensor(gyro(), table(rates), Rows(y, se, np.full(11, np.inf)), NOTHING)
    # Equal rows: the bias is a plain mean, so Welch and Satterthwaite add their degrees up.
    assert fit.t_dof[0] == pytest.approx(55.0)
    assert 20.0 < fit.t_dof[1] < 55.0
    # Meier (1953) with the mean leverage 2/11 of a line: 1 + 4 (1 - leverage) / dof.
    assert (fit.u("bias") / well.u("bias")) ** 2 == pytest.approx(1 + 4 * (1 - 2 / 11) / 5)


def fitted_by_definition(y: np.ndarray, x: np.ndarray) -> tuple[float, float]:
    """(3.6) as printed."""
    n = len(x)
    k = (x.sum() * y.sum() - n * (x * y).sum()) / (x.sum() ** 2 - n * (x**2).sum())
    return k, (y.sum() - k * x.sum()) / n


def test_table_3_2_is_the_line_of_3_6():
    golden = GOLDEN["table_3_2"]
    rates, y = (np.array(golden["input"][key]) for key in ("omega_dps", "U"))
    fit = fit_sensor(gyro(), table(rates), Rows.of(y), NOTHING)
    assert (fit.value("scale_factor"), fit.value("bias")) == pytest.approx(
        fitted_by_definition(y, rates)
    )
    assert fit.value("scale_factor") == pytest.approx(golden["k_z"], rel=1e-7)
    assert fit.value("bias") == pytest.approx(golden["U_0Sigma"], rel=1e-7)
    assert fit.u("scale_factor") == pytest.approx(golden["u_k_z"], rel=1e-7)
    assert fit.u("bias") == pytest.approx(golden["u_U0"], rel=1e-7)


def test_a_large_offset_costs_no_digits():
    rates = 1000.0 + np.arange(11.0)
    y = 8e6 + 1e-3 * rates
    fit = fit_sensor(gyro(), table(rates), Rows.of(y), NOTHING)
    assert isinstance(fit, FitResult)
    # The rounding of y itself is 1e-9, its slope over 10 deg/s 1e-10.
    assert fit.value("scale_factor") == pytest.approx(1e-3, abs=1e-9)


@pytest.mark.parametrize("drift", [5.0, 20.0, 1e3])
def test_drift_far_above_the_noise_gives_the_intervals_of_the_residuals(drift: float):
    """Ten seconds of samples make a tenth of a code; the practicum's residuals are of three."""
    noise = np.random.default_rng(8).normal(0.0, drift, 16)
    y = accelerometer().predict(head(times=2), TRUTH) + noise
    drifting = Conditions(repeatability=np.nan)
    fit = fit_sensor(accelerometer(), head(times=2), Rows.of(y, np.ones(16)), drifting)
    by_residuals = fit_sensor(accelerometer(), head(times=2), Rows.of(y), NOTHING)
    assert fit.sigma_source == "partly"
    assert fit.values == pytest.approx(by_residuals.values)
    assert fit.expanded() == pytest.approx(by_residuals.expanded(), rel=0.1)


@pytest.mark.parametrize("told", [True, False])
def test_one_residual_in_twenty_leaves_its_limits(told: bool):
    rng = np.random.default_rng(31)
    model, stimulus = accelerometer(), head()
    truth = model.predict(stimulus, TRUTH)
    outside = 0
    for _ in range(1000):
        y = truth + rng.normal(0.0, 2.0, len(truth))
        se = np.full(len(truth), 2.0) if told else None
        conditions = Conditions(g_mps2=G, repeatability=0.0)
        fit = fit_sensor(model, stimulus, Rows.of(y, se), conditions)
        # A rejected fit is one of them, and keeps its limits.
        outside += int(np.sum(np.abs(fit.residuals) > fit.residual_limits()))
    assert 0.042 < outside / 8000 < 0.058
