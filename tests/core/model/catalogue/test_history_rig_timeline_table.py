"""Effects of the rig, of what came before, of time: columns by hand, what rows can show."""

import numpy as np
import pytest

from core.model.catalogue.history import Hysteresis, SettlingLag
from core.model.catalogue.listing import CATALOGUE
from core.model.catalogue.rig import (
    HeadEccentricity,
    HeadPeriodicError,
    MountingAngle,
    RemountBias,
    ShaftTilt,
)
from core.model.catalogue.table import TableSlip, Wobble, WrongRate
from core.model.catalogue.timeline import BiasJump, Pickup, RunBias, WarmUp
from core.model.effect import Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_ARCSEC, STANDARD_GRAVITY

G = STANDARD_GRAVITY
HEAD = np.array([0.0, 90.0, 180.0, 270.0] * 3)
MOUNT = np.repeat([0.0, 1.0, 0.0], 4)
N = len(HEAD)
S, C = np.sin(np.radians(HEAD)), np.cos(np.radians(HEAD))
NONE = np.zeros(N)
A = G * np.column_stack([NONE, -S, C])
DA = G * np.column_stack([NONE, -C, -S])
T = 60.0 * np.arange(N)
ON_HEAD = Stimulus(
    A,
    0.0 * A,
    DA,
    0.0 * A,
    {
        "head_deg": HEAD,
        "mount": MOUNT,
        "run": np.repeat([1.0, 2.0], 6),
        "t_s": T,
        "temperature_c": 20.0 + T / 60.0,
        "order": np.arange(N, dtype=float),
    },
)
Z = Sensor("accelerometer", "z", "V", (0.01 / G, 0.02 / G, 1.0 / G))
W = np.array([-10.0, 0.0, 10.0, 20.0, 10.0, 0.0])
ON_TABLE = Stimulus(
    np.zeros((6, 3)),
    np.column_stack([0 * W, 0 * W, W]),
    np.zeros((6, 3)),
    np.tile([0.0, 0.0, 1.0], (6, 1)),
    {
        "set_rate_dps": W,
        "accumulation_s": np.full(6, 9.0),
        "run": np.ones(6),
        "order": np.arange(6.0),
        "AntiNodeAmplitude": np.array([1.0, 1.1, 0.9, 1.0, 1.0, 1.0]),
    },
)
GYRO = Sensor("gyro", "z", "V", (0.0, 0.0, 2.0))


def test_an_angle_acts_through_the_slope_of_the_sensor():
    slope = RAD_PER_ARCSEC * (-0.02 * C - S)
    found = MountingAngle(1).columns(ON_HEAD, Z)[:, 0]
    assert found == pytest.approx(slope * (MOUNT == 1.0))
    dial = HeadEccentricity().columns(ON_HEAD, Z)
    assert dial == pytest.approx(np.column_stack([slope * S, slope * C]))


def test_a_tilted_shaft_is_felt_along_it_and_turns_its_sign_with_the_unit():
    found = ShaftTilt().columns(ON_HEAD, Z)[:, 0]
    assert np.abs(found) == pytest.approx(np.full(N, 0.01 * RAD_PER_ARCSEC))
    across = Sensor("accelerometer", "x", "V", (1.0 / G, 0.0, 0.0))
    assert ShaftTilt().columns(ON_HEAD, across)[0, 0] == pytest.approx(RAD_PER_ARCSEC)


def test_bolting_on_again_may_be_another_mounting_than_before():
    found = RemountBias().instances(ON_HEAD, Z)
    counts = [tuple(one.columns(ON_HEAD, Z).any(axis=0)) for one in found]
    assert len(found) == 2 + 3 + 1
    assert counts[-1] == (True, True)
    again = found[4].columns(ON_HEAD, Z)[:, 0]
    assert again == pytest.approx(1e-3 * (np.arange(N) >= 8))


def test_fast_errors_of_the_worm_that_fold_onto_slow_ones_are_left_out():
    fine = Stimulus(A, A, DA, A, {"head_deg": np.arange(N) * 30.0})
    orders = [one.shape[0][1] for one in HeadPeriodicError().instances(fine, Z)]
    assert orders == [3.0, 4.0, 5.0, 6.0]


def test_hysteresis_turns_with_the_way_and_is_unknown_at_first():
    found = Hysteresis("mounting").columns(ON_HEAD, Z)[:4, 0]
    assert found == pytest.approx(1e-3 * np.array([0.0, -1.0, -1.0, 1.0]))
    whole = Hysteresis("all").columns(ON_HEAD, Z)[4, 0]
    assert whole == pytest.approx(1e-3)


def test_hysteresis_keeps_its_side_where_the_input_stays_and_may_begin_at_either():
    head = np.radians([0.0, 90.0, 90.0, 180.0])
    a = 9.81 * np.column_stack([np.zeros(4), -np.sin(head), np.cos(head)])
    still = Stimulus(a, a, 0.0 * a, a, {"mount": np.zeros(4), "run": np.ones(4)})
    found = Hysteresis("all", first=1.0).columns(still, Z)[:, 0]
    assert found == pytest.approx(1e-3 * np.array([1.0, -1.0, -1.0, -1.0]))
    assert Hysteresis("all").columns(still, Z)[0, 0] == 0.0


def test_a_line_is_looked_for_up_to_the_fold_of_the_usual_pause():
    t = np.concatenate([30.0 * np.arange(40), 2000.0 + 30.0 * np.arange(40)])
    rows = Stimulus(np.zeros((80, 3)), np.zeros((80, 3)), np.zeros((80, 3)), np.zeros((80, 3)),
                    {"t_s": t})  # fmt: skip
    cycles = [one.shape[0][1] for one in Pickup().instances(rows, Z)]
    assert max(cycles) == pytest.approx(0.5 * np.ptp(t) / 30.0, abs=0.5)


def test_all_mountings_may_stand_turned_each_by_its_own_angle():
    together = MountingAngle().instances(ON_HEAD, Z)[2]
    assert [value for _, value in together.shape] == [1.0, 2.0]
    assert together.columns(ON_HEAD, Z).shape == (N, 2)


def test_lag_is_the_missing_part_of_the_step():
    u = A @ Z.sensitivity
    found = SettlingLag("mounting").columns(ON_HEAD, Z)[:, 0]
    assert found[1] == pytest.approx(0.01 * (u[0] - u[1]))
    assert found[4] == 0.0


def test_a_large_lag_counts_from_what_the_row_before_has_reached():
    u = A @ Z.sensitivity
    reached = u.copy()
    for row in range(1, N):
        reached[row] = u[row] + 0.1 * (reached[row - 1] - u[row])
    found = SettlingLag("all").at(np.array([10.0])).columns(ON_HEAD, Z)[:, 0]
    assert 10.0 * found == pytest.approx(reached - u)


def test_time_and_temperature():
    assert CATALOGUE["bias_drift"].columns(ON_HEAD, Z)[:, 0] == pytest.approx(1e-3 * T / 3600.0)
    warm = ON_HEAD.column("temperature_c") - ON_HEAD.column("temperature_c").mean()
    assert CATALOGUE["bias_temperature"].columns(ON_HEAD, Z)[:, 0] == pytest.approx(1e-3 * warm)
    scale = CATALOGUE["scale_factor_temperature"].columns(ON_HEAD, Z)[:, 0]
    assert scale == pytest.approx(1e-6 * warm * (C - 0.02 * S))
    assert WarmUp(2.0).columns(ON_HEAD, Z)[2, 0] == pytest.approx(1e-3 * np.exp(-1.0))
    assert BiasJump(5).columns(ON_HEAD, Z)[:, 0] == pytest.approx(1e-3 * (np.arange(N) >= 5))
    assert len(BiasJump().instances(ON_HEAD, Z)) == N - 1
    assert [one.shape[0][1] for one in RunBias().instances(ON_HEAD, Z)] == [1.0, 2.0]
    assert RunBias(1.0).instances(ON_TABLE, GYRO) == ()
    line = Pickup(2.0).columns(ON_HEAD, Z)
    assert np.hypot(line[:, 0], line[:, 1]) == pytest.approx(np.full(N, 1e-3))


def test_refining_moves_a_shape_both_ways_by_a_fraction():
    for effect in (WarmUp(5.0), Pickup(7.0), TableSlip(50.0)):
        value = effect.shape[0][1]
        for fraction in (1.0, 0.25):
            low, high = (near.shape[0][1] for near in effect.near(fraction))
            assert low < value < high
        assert high - low < effect.near(1.0)[1].shape[0][1] - effect.near(1.0)[0].shape[0][1]


def test_the_table():
    slip = TableSlip(12.0).columns(ON_TABLE, GYRO)[:, 0]
    assert slip == pytest.approx([0.0, 0.0, 0.0, -0.01 * 2.0 * 8.0, 0.0, 0.0])
    wrong = WrongRate(10.0).columns(ON_TABLE, GYRO)[:, 0]
    assert wrong == pytest.approx(2.0 * (W == 10.0))
    assert [one.shape[0][1] for one in WrongRate().instances(ON_TABLE, GYRO)] == [0.0, 10.0]
    sine, cosine = Wobble().columns(ON_TABLE, GYRO)[1]
    assert (sine, cosine) == (0.0, 2.0)
    turn = np.radians(90.0)
    assert Wobble().columns(ON_TABLE, GYRO)[2] == pytest.approx([2.0 / turn, 2.0 / turn])
    amplitude = CATALOGUE["amplitude_scale_factor"].columns(ON_TABLE, GYRO)[:, 0]
    assert amplitude == pytest.approx([0.0, 0.0, 2.0 * -0.1 * 10.0, 0.0, 0.0, 0.0])
