"""The bench against the tables of the practicum and trigonometry written out by hand."""

import math

import numpy as np
import pytest

from core.plans.orientation import BaseOrientation
from core.units import EARTH_RATE_DPS
from drivers.virtual.bench import Bench, Manner, Place, Ramp

G = 9.8106
QUICK = Manner(head_dps=180.0, remount_s=0.5)


def bench(**place: float) -> Bench:
    return Bench(Place(**place), QUICK, 100.0, np.random.default_rng(1))


def still(one: Bench):
    """Let everything come to rest and return the one row that then stands for all."""
    for _ in range(200):
        stimulus = one.stimulus(50)
        if len(stimulus) == 1:
            return stimulus
    raise AssertionError("it never came to rest")


# Tables 1.1 and 2.1: specific force in units of g by mount and head angle.
TABLE = {
    ("X_from", 0): (0, 0, 1),
    ("X_from", 90): (0, -1, 0),
    ("X_from", 180): (0, 0, -1),
    ("X_from", 270): (0, 1, 0),
    ("Y_from", 0): (0, 0, 1),
    ("Y_from", 90): (1, 0, 0),
    ("Y_from", 180): (0, 0, -1),
    ("Y_from", 270): (-1, 0, 0),
}


@pytest.mark.parametrize(("position", "up"), TABLE.items())
def test_positions_of_the_practicum(position, up):
    one = bench()
    one.remount(position[0])
    one.turn(position[1])
    stimulus = still(one)
    assert np.allclose(stimulus.a, [np.multiply(up, G)], atol=1e-12)
    assert stimulus.column("head_deg") == [position[1]]


def test_the_head_turns_at_its_speed_the_short_way():
    one = bench()
    one.turn(270.0)
    path = one.stimulus(20).column("head_deg") % 360.0
    assert np.allclose(path, 360.0 - 1.8 * np.arange(1, 21))
    still(one)
    assert one.head.value == 270.0
    one.turn(0.0)
    path = one.stimulus(100).column("head_deg")
    assert np.all(np.diff(path % 360.0)[path[1:] < 0] > 0)
    assert one.head.value == 0.0


def test_motion_follows_the_angle_and_is_felt_by_gyros():
    one = Bench(Place(), Manner(vibration=0.0, shake_dps=0.0), 100.0, np.random.default_rng(1))
    earth = still(one).w[0]
    assert np.linalg.norm(earth) == pytest.approx(4.178e-3, rel=1e-3)
    one.turn(60.0)
    moving = one.stimulus(100)
    alpha = np.radians(moving.column("head_deg"))
    assert np.allclose(moving.a, G * np.column_stack([0 * alpha, -np.sin(alpha), np.cos(alpha)]))
    # Between 0 and 90 deg the up direction goes from +Z to -Y: the case turns about -X.
    assert np.allclose(moving.w, [-45.0, 0.0, 0.0], atol=5e-3)
    numeric = np.gradient(moving.a[:, 1], alpha)
    assert np.allclose(moving.da_dhead[1:-1, 1], numeric[1:-1], atol=1e-3)


def test_vibration_lasts_as_long_as_the_motion_and_a_moment_more():
    one = bench()
    one.turn(90.0)
    rows = one.stimulus(300)
    clean = np.radians(rows.column("head_deg"))
    shaken = rows.a[:, 1] + G * np.sin(clean)
    assert shaken[:50].std() == pytest.approx(0.3, rel=0.4)
    assert shaken[:50].std() > 20 * shaken[140:].std()
    assert not shaken[160:].any()
    assert len(one.stimulus(10)) == 1


def test_remounting_takes_its_time():
    one = bench()
    one.remount("Y_to@90")
    one.remount("Y_to@90")
    assert one.moving
    one.stimulus(49)
    assert one.moving
    one.stimulus(1)
    assert not one.moving
    with pytest.raises(ValueError, match="unknown mount"):
        one.remount("Q_from")


def test_base_plate_and_earth_rate_by_hand():
    one = bench(latitude_deg=50.45)
    psi, alpha = 30.0, 12.0
    one.tilt_base(BaseOrientation(alpha_arcmin=alpha, psi_deg=psi))
    row = still(one)
    tilt = math.radians(alpha / 60.0)
    assert np.allclose(row.a[0], [G * math.sin(tilt), 0.0, G * math.cos(tilt)], atol=1e-9)
    rate = 360.0 / 86164.0905
    north = rate * math.cos(math.radians(50.45))
    up = rate * math.sin(math.radians(50.45))
    # X along a shaft that points 30 deg east of north: north lies 30 deg to its left, on +Y.
    level = np.array([north * math.cos(math.radians(psi)), north * math.sin(math.radians(psi)), up])
    tilted = [
        level[0] * math.cos(tilt) + level[2] * math.sin(tilt),
        level[1],
        level[2] * math.cos(tilt) - level[0] * math.sin(tilt),
    ]
    assert np.allclose(row.w[0], tilted, atol=1e-9)


def test_table_ramps_and_swings_the_level_part_of_the_earth_rate():
    one = bench(latitude_deg=0.0)
    one.spin(100.0, "z")
    rows = one.stimulus(400)
    rate = rows.column("set_rate_dps")
    assert np.allclose(rate[:5], 0.5 * np.arange(1, 6))
    assert np.allclose(rate[200:], 100.0)
    assert np.allclose(rows.dw_drate, [0.0, 0.0, 1.0])
    assert not rows.da_dhead.any()
    turning = one.stimulus(360)
    assert turning.w[:, 2].mean() == pytest.approx(100.0, abs=0.01)
    # A whole number of turns, on the equator: the level part averages out.
    assert np.hypot(*turning.w[:, :2].mean(axis=0)) < 1e-4
    azimuth = np.unwrap(np.arctan2(turning.w[:, 1], turning.w[:, 0]))
    # The table turns to the left, so north runs to the right.
    assert np.allclose(np.diff(azimuth), -math.radians(1.0), atol=1e-6)
    one.turn(0.0)
    assert still(one).w[0, 2] == pytest.approx(0.0, abs=1e-9)


def test_unit_follows_the_chamber():
    one = Bench(
        Place(), Manner(chamber_c_per_s=1.0, case_tau_s=10.0), 10.0, np.random.default_rng(1)
    )
    one.heat(70.0)
    one.stimulus(430)
    assert one.chamber.value == 70.0
    # A first-order lag behind a ramp trails by tau times its slope.
    assert one.case_c == pytest.approx(70.0 - 10.0 * (1 - math.exp(-4.3)), abs=0.2)
    assert np.allclose(still(one).column("temperature_c"), 70.0, atol=0.01)
    one.be_at(-40.0)
    assert still(one).column("temperature_c") == [-40.0]


def test_ramp_stands_at_its_target():
    ramp = Ramp(5.0, 2.0)
    ramp.target = 3.0
    assert np.allclose(ramp.path(6, 0.25), [4.5, 4.0, 3.5, 3.0, 3.0, 3.0])
    assert np.array_equal(ramp.path(2, 0.25), [3.0, 3.0])


@pytest.mark.parametrize(("mount", "axis", "sign"), [("Z_from", "z", 1), ("X_to", "x", -1)])
def test_on_the_table_the_spun_axis_is_upright_by_its_mount(mount: str, axis: str, sign: int):
    one = bench()
    one.remount(mount)
    one.spin(40.0, axis)
    one.stimulus(2000)
    now = one.stimulus(100)
    own = "xyz".index(axis)
    others = [i for i in range(3) if i != own]
    assert now.a[:, own] == pytest.approx(np.full(100, sign * G))
    assert now.a[:, others] == pytest.approx(np.zeros((100, 2)), abs=1e-9)
    earth = EARTH_RATE_DPS * math.sin(math.radians(50.45))
    assert now.w[:, own] == pytest.approx(np.full(100, sign * (40.0 + earth)), abs=1e-6)
    assert now.dw_drate[0].tolist() == [sign * (i == own) for i in range(3)]


def test_a_mount_of_another_axis_stands_with_the_spun_axis_up():
    one = bench()
    one.spin(10.0, "y")
    one.stimulus(1000)
    assert one.stimulus(10).a[0] == pytest.approx([0.0, G, 0.0], abs=1e-9)
