"""Effects of records against solutions by other ways."""

import numpy as np
import pytest

from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.record import (
    PhaseError,
    Telegraph,
    TemperatureRate,
    ThermalHysteresis,
    ThermalLag,
    branch,
    lagged,
)
from core.model.catalogue.record_slow import BiasCurve, SlowPickup
from core.model.effect import Kind, Sensor
from core.model.stimulus import Stimulus

GYRO = Sensor("gyro", "z", "V")
T = np.arange(0.0, 3600.0, 10.0)


def stimulus(**columns: np.ndarray) -> Stimulus:
    zero = np.zeros((len(T), 3))
    return Stimulus(zero, zero, zero, zero, {"t_s": T, **columns})


def test_lag_is_the_solution_of_its_differential_equation():
    ramp = 20.0 + 0.01 * T
    # T' = (ramp - T)/tau has T = ramp - c tau (1 - exp(-t/tau)).
    exact = ramp - 0.01 * 300.0 * (1.0 - np.exp(-T / 300.0))
    assert lagged(ramp, T, 300.0) == pytest.approx(exact, abs=1e-9)


def test_the_column_of_lag_is_the_lagged_temperature_from_its_mean():
    warm = 20.0 + np.sin(T / 500.0)
    (column,) = ThermalLag(200.0).columns(stimulus(temperature_c=warm), GYRO).T
    wave = lagged(warm, T, 200.0)
    assert column == pytest.approx(wave - wave.mean())


def test_rate_is_the_derivative_in_degrees_a_minute():
    warm = 20.0 + 2.0 * np.sin(T / 500.0)
    (column,) = TemperatureRate(15.0).columns(stimulus(temperature_c=warm), GYRO).T
    exact = 60.0 * 2.0 / 500.0 * np.cos(T / 500.0)
    assert column[3:-3] == pytest.approx(exact[3:-3], abs=1e-3)
    assert column == pytest.approx(exact, abs=6e-3)  # one-sided at the ends


def test_the_time_of_a_rate_is_refined_but_not_below_the_rows():
    first, *_, last = TemperatureRate().instances(stimulus(temperature_c=20.0 + 0.01 * T), GYRO)
    ((_, least),) = first.shape
    shorter, longer = (one.shape[0][1] for one in first.near())
    assert (shorter, longer) == (least, 1.25 * least)
    ((_, most),) = last.shape
    assert [one.shape[0][1] for one in last.near()] == [most / 1.25, most * 1.25]


def test_hysteresis_stands_on_one_branch_until_the_temperature_turns():
    warm = np.concatenate([np.linspace(20.0, 30.0, 100), np.linspace(30.0, 20.0, 100)])
    stands = branch(warm, 2.0, 1.0)
    assert np.all(stands[:100] == pytest.approx(1.0))
    turned = np.flatnonzero(warm[100:] <= 28.0)[0] + 100
    assert np.all(stands[turned:] == pytest.approx(-1.0))
    slow = branch(np.repeat(warm, 7), 2.0, 1.0)  # its rate does not matter
    assert slow[::7] == pytest.approx(stands)


def test_hysteresis_is_offered_up_to_ten_degrees():
    warm = 20.0 + 40.0 * np.sin(T / 500.0)
    one = ThermalHysteresis().instances(stimulus(temperature_c=warm), GYRO)
    widths = {dict((p.name, v) for p, v in each.shape)["width"] for each in one}  # noqa: C402
    assert max(widths) == pytest.approx(10.0)


def test_phase_error_is_a_product():
    delay, q = 14.0 + 0.1 * np.sin(T / 400.0), 0.07 + 0.01 * np.cos(T / 300.0)
    (column,) = PhaseError().columns(stimulus(ExcitationDelay=delay, QuadratureAmpl=q), GYRO).T
    assert column == pytest.approx((delay - delay.mean()) * q)


def test_telegraph_goes_between_two_levels_and_has_no_instance_before_the_data():
    assert Telegraph().instances(stimulus(), GYRO) == ()
    effect = Telegraph(((3, 7), (5, 9, 11)), (-8.0, -12.0))
    first, second = effect.instances(stimulus(), GYRO)
    (column,) = first.columns(stimulus(), GYRO).T
    assert column[:9].tolist() == [0, 0, 0, 1, 1, 1, 1, 0, 0]
    assert second.log_odds == -12.0
    assert [value for _, value in second.shape] == [6.0, 10.0, 12.0]


def test_a_curve_of_temperature_bends_only_over_a_wide_range():
    narrow = BiasCurve().instances(stimulus(temperature_c=20.0 + T / 1000.0), GYRO)
    wide = BiasCurve().instances(stimulus(temperature_c=20.0 + T / 100.0), GYRO)
    assert [len(each.parameters(GYRO)) for each in narrow] == [1, 2]
    assert [len(each.parameters(GYRO)) for each in wide] == [1, 2, 3]


def test_slow_lines_go_from_three_to_twenty_periods():
    cycles = [each.shape[0][1] for each in SlowPickup().instances(stimulus(), GYRO)]
    assert min(cycles) == 3.0
    assert 19.0 < max(cycles) < 20.0
    assert all(isinstance(each, SlowPickup) for each in SlowPickup(5.0).near())


def test_noise_and_facts_add_no_columns():
    for name in ("markov", "quantization", "dropouts", "missing_codes", "clipping"):
        effect = CATALOGUE[name]
        assert effect.kind in (Kind.NOISE, Kind.FACT)
        assert effect.columns(stimulus(), GYRO).shape == (len(T), 0)
        assert effect.tests == ("record",)
