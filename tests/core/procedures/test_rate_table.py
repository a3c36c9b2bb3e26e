"""Rate-table runs: the practicum's Table 3.2, one injected error at a time, bad input, coverage."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.rate_table import calibrate_rate_table, whole_turns_s
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))
TABLE_3_2 = GOLDEN["source001"]["table_3_2"]
RATES = np.arange(-100.0, 101.0, 20.0)
PLAIN = Conditions()
EARTH_DPS = 15.041067 / 3600.0


def run_of(
    rates: np.ndarray,
    y: np.ndarray,
    *,
    se: np.ndarray | None = None,
    mounts: tuple[str, ...] | None = None,
    axes: tuple[str, ...] | None = None,
    extra: dict[str, np.ndarray] | None = None,
) -> Run:
    y = y[:, None] if y.ndim == 1 else y
    n, c = y.shape
    return plain_run(
        test="rate_table",
        sensor="gyro",
        device="ADXRS610",
        channels=tuple(f"gyro_{i + 1}" for i in range(c)),
        axes=axes or ("z",) * c,
        y=y,
        y_se=np.full((n, c), np.nan) if se is None else se.reshape(n, c),
        mount=mounts or ("",) * n,
        set_rate_dps=rates,
        extra=extra or {},
    )


def line(rates: np.ndarray, k: float | np.ndarray = -79.4, zero: float = -438.0) -> np.ndarray:
    return zero + k * rates


def noise(shape: tuple[int, ...], sigma: float = 1.0, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(0.0, sigma, shape)


def subjects(notes) -> list[str]:
    return [note.subject for note in notes]


def test_table_3_2():
    y = np.array(TABLE_3_2["input"]["U"])
    sensor = calibrate_rate_table(run_of(RATES, y), PLAIN).sensors[0]
    assert sensor.line.symbol == "k_z"
    assert sensor.line.slope.value == pytest.approx(TABLE_3_2["k_z"], rel=1e-7)
    assert sensor.line.slope.unit == "code/(deg/s)"
    assert sensor.line.slope.u == pytest.approx(TABLE_3_2["u_k_z"], rel=1e-7)
    assert sensor.line.zero.value == pytest.approx(TABLE_3_2["U_0Sigma"], rel=1e-7)
    assert sensor.line.zero.u == pytest.approx(TABLE_3_2["u_U0"], rel=1e-7)
    assert sensor.bias.value == pytest.approx(TABLE_3_2["bias_dps"], rel=1e-7)
    # The golden value leaves the uncertainty of k_z out, which adds 0.4 %.
    assert sensor.bias.u == pytest.approx(TABLE_3_2["u_bias_dps"], rel=0.005)
    assert np.allclose(sensor.line.fit.residuals, TABLE_3_2["residuals_code"], atol=1e-6)
    assert np.allclose(sensor.residuals_dps, TABLE_3_2["residuals_dps"], atol=1e-8)
    assert np.allclose(sensor.measured_dps, TABLE_3_2["omega_cal_dps"], rtol=1e-7)
    assert np.sum(sensor.line.fit.residuals**2) == pytest.approx(TABLE_3_2["rss"], rel=1e-7)
    rejected = next(note for note in sensor.notes if note.subject == "not_straight")
    assert "straight line is rejected (p = 0.0011)" in rejected.text
    assert "negative_scale_factor" in subjects(sensor.notes)


@pytest.mark.parametrize(("change", "moves"), [({"k": -79.5}, "slope"), ({"zero": -430.0}, "zero")])
def test_one_injected_error_moves_only_its_parameter(change: dict[str, float], moves: str):
    before = calibrate_rate_table(run_of(RATES, line(RATES)), PLAIN).sensors[0].line
    after = calibrate_rate_table(run_of(RATES, line(RATES, **change)), PLAIN).sensors[0].line
    for name in ("slope", "zero"):
        moved = getattr(after, name).value - getattr(before, name).value
        assert moved == pytest.approx(
            {"slope": -0.1, "zero": 8.0}[name] * (name == moves), abs=1e-9
        )


def test_nine_sensors_at_once_keep_their_names():
    ks = -79.4 + np.arange(9.0)
    y = line(RATES[:, None], ks) + noise((11, 9))
    found = calibrate_rate_table(run_of(RATES, y), PLAIN)
    assert [sensor.channel for sensor in found.sensors] == [f"gyro_{i}" for i in range(1, 10)]
    for sensor, k in zip(found.sensors, ks, strict=True):
        assert abs(sensor.line.slope.value - k) < sensor.line.slope.expanded(0.999)
    assert found.sensor("gyro_3").line.slope.value == found.sensors[2].line.slope.value
    with pytest.raises(KeyError):
        found.sensor("gyro_10")


def test_three_axes_by_re_mounting():
    k = np.array([[-79.0, 0.9, -0.4], [0.3, 81.0, 1.2], [-0.7, 0.2, -80.0]])
    zero = np.array([[10.0, 20, 30], [11, 21, 31], [12, 22, 32]])  # by mount
    rates = np.tile(RATES, 3)
    mounts = tuple(m for m in ("X_from", "Y_to", "Z_from") for _ in RATES)
    signs = {"X_from": 1.0, "Y_to": -1.0, "Z_from": 1.0}
    y = np.array(
        [
            zero["XYZ".index(mount[0])] + k[:, "XYZ".index(mount[0])] * signs[mount] * rate
            for mount, rate in zip(mounts, rates, strict=True)
        ]
    )
    found = calibrate_rate_table(run_of(rates, y, mounts=mounts, axes=("x", "y", "z")), PLAIN)
    for i, sensor in enumerate(found.sensors):
        lines = {line.symbol: line for line in (sensor.line, *sensor.others)}
        for j, axis in enumerate("xyz"):
            symbol = f"k_{sensor.axis}" if i == j else f"k_{sensor.axis}{axis}"
            assert lines[symbol].slope.value == pytest.approx(k[i, j], abs=1e-10)
            assert lines[symbol].zero.value == pytest.approx(zero[j, i], abs=1e-8)
        assert sensor.line.symbol == f"k_{'xyz'[i]}"


def test_the_earth_is_taken_out_of_the_zero():
    rates, k = np.array([-40.0, -20, 0, 20, 40]), 0.024
    up = EARTH_DPS * np.sin(np.deg2rad(50.45))
    y = 0.01 + k * (rates + up) + noise((5,), 2e-8)
    run = run_of(rates, y, se=np.full((5, 1), 2e-8))
    found = calibrate_rate_table(run, Conditions(latitude_deg=50.45)).sensors[0]
    assert found.line.zero.value == pytest.approx(0.01, abs=1e-7)
    assert "earth_rate" not in subjects(found.notes)
    blind = calibrate_rate_table(run, PLAIN).sensors[0]
    assert (blind.bias.value - found.bias.value) * 3600.0 == pytest.approx(11.60, abs=0.01)
    assert "earth_rate" in subjects(blind.notes)


def test_a_coarse_gyro_does_not_speak_of_the_earth():
    found = calibrate_rate_table(run_of(RATES, line(RATES) + noise((11,), 2.0)), PLAIN)
    assert "earth_rate" not in subjects(found.sensors[0].notes)


def test_the_freedom_of_the_standard_errors_is_used():
    y, se = line(RATES) + noise((11,)), np.ones((11, 1))
    few = run_of(RATES, y, se=se, extra={"se_dof": np.full(11, 8.0)})
    slope = calibrate_rate_table(few, PLAIN).sensors[0].line.slope
    assert slope.dof < 88.0
    assert np.isinf(calibrate_rate_table(run_of(RATES, y, se=se), PLAIN).sensors[0].line.slope.dof)


def test_hysteresis_needs_both_ways():
    rates = np.concatenate([RATES, RATES[-2::-1]])
    came = np.concatenate([np.ones(11), -np.ones(10)])
    y = line(rates) - 79.4 * 0.05 * came + noise((21,), 0.5)
    found = calibrate_rate_table(run_of(rates, y), PLAIN).sensors[0]
    assert found.hysteresis is not None
    assert found.hysteresis.mean.value == pytest.approx(0.1, abs=0.01)
    # The order of measuring counts, not that of the rows.
    mixed = run_of(rates, y).rows(np.random.default_rng(2).permutation(21))
    again = calibrate_rate_table(mixed, PLAIN).sensors[0].hysteresis
    assert again is not None
    assert again.mean.value == pytest.approx(found.hysteresis.mean.value, rel=1e-9)
    one_way = calibrate_rate_table(run_of(RATES, line(RATES) + noise((11,))), PLAIN).sensors[0]
    assert one_way.hysteresis is None


# --- bad input ---------------------------------------------------------------------------------


def test_equal_rates_are_refused_in_words():
    rates = np.full(5, 20.0)
    with pytest.raises(FitError, match=r"same rate \(20 deg/s\).*two rates"):
        calibrate_rate_table(run_of(rates, noise((5,))), PLAIN)


def test_two_rates_give_numbers_without_uncertainty_and_say_so():
    rates = np.array([-50.0, 50.0])
    found = calibrate_rate_table(run_of(rates, line(rates)), PLAIN).sensors[0]
    assert found.line.slope.value == pytest.approx(-79.4)
    assert np.isnan(found.line.slope.u)
    assert "two_rates" in subjects(found.notes)
    assert "no_uncertainty" in subjects(found.line.fit.notes)


def test_the_sign_of_an_earlier_calibration_is_compared():
    y = line(-RATES) + noise((11,))
    found = calibrate_rate_table(run_of(RATES, y), PLAIN, expected={"gyro_1": -79.4})
    note = next(n for n in found.sensors[0].notes if n.subject == "sign_reversed")
    assert "wrong way" in note.text


@pytest.mark.parametrize(("factor", "unit"), [(180 / np.pi, "rad/s"), (3600.0, "deg/h")])
def test_rates_in_another_unit_are_recognised(factor: float, unit: str):
    y = line(RATES * factor) + noise((11,))
    found = calibrate_rate_table(run_of(RATES, y), PLAIN, expected={"gyro_1": -79.4})
    note = next(n for n in found.sensors[0].notes if n.subject == "wrong_unit")
    assert unit in note.text


def test_a_scale_factor_far_from_the_expected_is_doubted():
    y = line(RATES, k=-60.0) + noise((11,))
    found = calibrate_rate_table(run_of(RATES, y), PLAIN, expected={"gyro_1": -79.4})
    assert "scale_factor_unexpected" in subjects(found.sensors[0].notes)
    good = calibrate_rate_table(run_of(RATES, y), PLAIN, expected={"gyro_1": -61.0})
    assert subjects(good.sensors[0].notes) == ["negative_scale_factor"]


def test_clipped_codes_are_left_out_and_named():
    y = np.clip(line(RATES) + noise((11,)), -6000.0, 6000.0)
    found = calibrate_rate_table(run_of(RATES, y), PLAIN)
    note = next(n for n in found.notes if n.subject == "clipped")
    assert "gyro_1: at -100, 80, 100 deg/s" in note.text
    assert "6000" in note.text
    sensor = found.sensors[0]
    assert sensor.line.slope.value == pytest.approx(-79.4, abs=0.1)
    assert list(sensor.line.rows) == [1, 2, 3, 4, 5, 6, 7, 8]
    assert "not_straight" not in subjects(sensor.notes)


def test_a_stopped_table_is_named_by_row():
    y = line(RATES) + noise((11,))
    y[8] = line(np.array(0.55 * RATES[8]))
    found = calibrate_rate_table(run_of(RATES, y), PLAIN)
    note = next(n for n in found.notes if n.subject == "wrong_rate")
    assert note.text.startswith("row 9, 60 deg/s")
    assert "55 % of the accumulation" in note.text


def test_mixed_units_within_a_run_are_named_by_row():
    rates = RATES.copy()
    rates[-2] = np.deg2rad(RATES[-2])
    found = calibrate_rate_table(run_of(rates, line(RATES) + noise((11,))), PLAIN)
    note = next(n for n in found.notes if n.subject == "wrong_rate")
    assert "rad/s" in note.text


def test_a_dead_sensor_is_left_out_and_named():
    y = np.column_stack([line(RATES) + noise((11,)), np.full(11, 5.0)])
    found = calibrate_rate_table(run_of(RATES, y), PLAIN)
    assert [sensor.channel for sensor in found.sensors] == ["gyro_1"]
    assert subjects(found.notes) == ["dead"]
    with pytest.raises(FitError, match="same in every row"):
        calibrate_rate_table(run_of(RATES, np.full(11, 5.0)), PLAIN)


def test_a_sensor_that_does_not_answer_is_named():
    found = calibrate_rate_table(run_of(RATES, noise((11,))), PLAIN)
    assert subjects(found.sensors[0].notes) == ["insensitive"]


def test_errors_that_go_together_are_the_tables():
    slip = noise((11, 1), 0.2, seed=3)
    y = line(RATES[:, None] + slip, -79.4 + np.arange(6.0)) + noise((11, 6), 0.3)
    found = calibrate_rate_table(run_of(RATES, y), PLAIN)
    assert "common_error" in subjects(found.notes)
    alone = calibrate_rate_table(run_of(RATES, line(RATES[:, None]) + noise((11, 6))), PLAIN)
    assert "common_error" not in subjects(alone.notes)


@pytest.mark.parametrize(
    ("run", "says"),
    [
        (run_of(RATES[:0], np.zeros((0, 1))), "no rows"),
        (run_of(RATES, np.where(RATES == 20, np.nan, line(RATES))), "row 7: the output gyro_1"),
        (run_of(np.where(RATES == 20, np.nan, RATES), line(RATES)), "row 7: the set rate"),
        (
            run_of(RATES, line(RATES), mounts=("X_from",) * 11),
            "gyro_1: no row turns about z, their own axis",
        ),
    ],
)
def test_what_cannot_be_fitted_is_refused_in_words(run: Run, says: str):
    with pytest.raises(FitError, match=says):
        calibrate_rate_table(run, PLAIN)


@pytest.mark.parametrize(
    ("rate", "wanted", "expected"),
    [
        (0.0, 30.0, 30.0),
        (20.0, 30.0, 36.0),
        (-100.0, 30.0, 28.8),
        (1.0, 30.0, 360.0),
        (12.0, 30.0, 30.0),
    ],
)
def test_accumulations_of_whole_turns(rate: float, wanted: float, expected: float):
    assert whole_turns_s(rate, wanted) == pytest.approx(expected)


@pytest.mark.slow
@pytest.mark.parametrize(("u_rate", "known"), [(0.0, True), (0.2, True), (0.2, False)])
def test_scale_factor_and_bias_cover_with_and_without_a_worn_table(u_rate: float, known: bool):
    rng = np.random.default_rng(11)
    conditions = Conditions(rate_u_dps=u_rate) if known else PLAIN
    truth = {"slope": -79.4, "zero": -438.0}
    inside = {"slope": 0, "zero": 0, "bias": 0}
    trials = 1200
    base = run_of(RATES, line(RATES))
    for _ in range(trials):
        turned = RATES + rng.normal(0.0, u_rate, 11)
        y = (line(turned) + rng.normal(0.0, 1.3, 11))[:, None]
        se = np.full((11, 1), 1.3) if known else np.full((11, 1), np.nan)
        sensor = calibrate_rate_table(replace(base, y=y, y_se=se), conditions).sensors[0]
        for name, value in truth.items():
            found = getattr(sensor.line, name)
            inside[name] += abs(found.value - value) < found.expanded()
        inside["bias"] += abs(sensor.bias.value - 438.0 / 79.4) < sensor.bias.expanded()
    assert all(0.93 < count / trials < 0.97 for count in inside.values()), inside
