"""Where the axes point: the practicum's tables, and a second way that turns the rig's vectors."""

import json
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.plans.orientation import (
    LEVEL,
    BaseOrientation,
    Mount,
    case_from_base,
    earth_rate,
    specific_force,
    specific_force_in_base,
    tilter_rotation,
    turn,
)
from core.units import EARTH_RATE_DPS

G = 9.8106
GOLDEN = json.loads((Path(__file__).parents[2] / "data" / "golden.json").read_text("utf-8"))
MOUNTS = [f"{axis}_{sense}" for axis, sense in product("XYZ", ("from", "to"))]
ANGLES = st.floats(-720.0, 720.0)


def rodrigues(vector: np.ndarray, about: np.ndarray, degrees: float) -> np.ndarray:
    """Turn a vector right-handed about a unit vector."""
    c, s = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return vector * c + np.cross(about, vector) * s + about * (about @ vector) * (1.0 - c)


def axes_in_the_world(
    mount: str, head: float, base: BaseOrientation, reindex: float = 0.0
) -> np.ndarray:
    """Rows X, Y, Z of the case in east, north, up: every part of the rig turned in its turn."""
    azimuth = np.deg2rad(base.psi_deg)
    shaft = np.array([np.sin(azimuth), np.cos(azimuth), 0.0])
    up = np.array([0.0, 0.0, 1.0])
    left = np.cross(up, shaft)
    # The free end of the shaft rises.
    shaft, up = (rodrigues(v, left, -base.alpha_arcmin / 60.0) for v in (shaft, up))
    # The plate, then the head, turn about the shaft; Table 1.1: at 90 degrees Y hangs down.
    for angle in (base.beta_arcmin / 60.0 + base.gamma_deg, head, reindex):
        up, left = (rodrigues(v, shaft, -angle) for v in (up, left))
    along = shaft if mount.endswith("from") else -shaft
    if mount[0] == "X":
        x, z = along, up
        return np.array([x, np.cross(z, x), z])
    if mount[0] == "Y":
        y, z = along, up
        return np.array([np.cross(y, z), y, z])
    z, x = along, up
    return np.array([x, np.cross(z, x), z])


@pytest.mark.parametrize("mount", MOUNTS)
@given(
    head=ANGLES,
    alpha=st.floats(-600.0, 600.0),
    beta=st.floats(-600.0, 600.0),
    gamma=st.floats(-180.0, 180.0),
    psi=st.floats(0.0, 360.0),
    latitude=st.floats(-90.0, 90.0),
)
def test_force_and_earth_rate_agree_with_turned_vectors(
    mount: str, head: float, alpha: float, beta: float, gamma: float, psi: float, latitude: float
):
    base = BaseOrientation(alpha, beta, gamma, psi)
    axes = axes_in_the_world(mount, head, base)
    assert np.allclose(specific_force(mount, head, G, base), axes @ [0.0, 0.0, G], atol=1e-9)
    phi = np.deg2rad(latitude)
    sky = EARTH_RATE_DPS * np.array([0.0, np.cos(phi), np.sin(phi)])
    assert np.allclose(earth_rate(mount, head, latitude, base), axes @ sky, atol=1e-12)


@pytest.mark.parametrize("mount", MOUNTS)
def test_re_indexing_is_a_turn_with_the_head(mount: str):
    for reindex in (-90, 30, 90, 180):
        axes = axes_in_the_world(mount, 20.0, LEVEL, reindex)
        found = specific_force(f"{mount}@{reindex}", 20.0, G)
        assert np.allclose(found, axes @ [0.0, 0.0, G], atol=1e-12)


def test_tables_1_1_2_1_and_3_1():
    expected = GOLDEN["source001"]["table_2_2"]["input"]["a_over_g"]
    found = [
        specific_force(mount, head, 1.0)
        for mount in ("X_from", "Y_from")
        for head in (0.0, 90.0, 180.0, 270.0)
    ]
    assert np.array_equal(found, expected)  # true zeros, not 1e-17


@pytest.mark.parametrize(
    ("mount", "up_at"),
    [
        ("X_from", ["+z", "-y", "-z", "+y"]),
        ("X_to", ["+z", "+y", "-z", "-y"]),
        ("Y_from", ["+z", "+x", "-z", "-x"]),
        ("Y_to", ["+z", "-x", "-z", "+x"]),
        ("Z_from", ["+x", "+y", "-x", "-y"]),
        ("Z_to", ["+x", "-y", "-x", "+y"]),
    ],
)
def test_which_axis_is_up_at_the_quarter_turns(mount: str, up_at: list[str]):
    for quarter, up in enumerate(up_at):
        expected = np.zeros(3)
        expected["xyz".index(up[1])] = G if up[0] == "+" else -G
        assert np.array_equal(specific_force(mount, 90.0 * quarter, G), expected)


@pytest.mark.parametrize("mount", MOUNTS)
@given(head=ANGLES)
def test_case_axes_are_a_right_handed_triad(mount: str, head: float):
    rotation = case_from_base(mount, head)
    assert np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(rotation) == pytest.approx(1.0)
    assert not rotation.flags.writeable


def test_turning_about_an_axis_is_right_handed():
    assert np.array_equal(turn("Z", 90.0) @ [1, 0, 0], [0, 1, 0])
    assert np.array_equal(turn("X", 90.0) @ [0, 1, 0], [0, 0, 1])
    assert np.array_equal(turn("Y", 90.0) @ [0, 0, 1], [1, 0, 0])


def test_an_upright_shaft_feels_gravity_along_itself():
    upright = BaseOrientation(alpha_arcmin=5400.0)
    assert np.allclose(specific_force_in_base(G, upright), [G, 0.0, 0.0])


@pytest.mark.parametrize(
    ("latitude", "psi", "mount", "head", "expected"),
    [
        (90.0, 0.0, "X_from", 0.0, [0, 0, 1]),
        (0.0, 0.0, "X_from", 0.0, [1, 0, 0]),  # shaft to the north
        (0.0, 180.0, "X_from", 0.0, [-1, 0, 0]),
        (0.0, 90.0, "X_from", 0.0, [0, 1, 0]),  # shaft to the east: north is to the left
        (0.0, 270.0, "X_from", 0.0, [0, -1, 0]),
        (-90.0, 0.0, "X_from", 180.0, [0, 0, 1]),
    ],
)
def test_the_earth_turns_about_the_pole(latitude, psi, mount, head, expected):
    base = BaseOrientation(psi_deg=psi)
    found = earth_rate(mount, head, latitude, base)
    assert np.allclose(found, EARTH_RATE_DPS * np.array(expected, dtype=float), atol=1e-18)


def test_the_earth_in_kyiv():
    up = earth_rate("X_from", 0.0, 50.45)[2] * 3600.0
    north = np.hypot(*earth_rate("X_from", 0.0, 50.45)[:2]) * 3600.0
    assert up == pytest.approx(11.60, abs=0.005)
    assert north == pytest.approx(9.58, abs=0.005)


def test_a_tilter_pitches_and_rolls_as_2_8_defines():
    up = np.array([0.0, 0.0, 1.0])
    pitched = tilter_rotation(0.0, 30.0, 0.0) @ up
    assert np.allclose(pitched, [0.0, 0.5, np.sqrt(0.75)])
    rolled = tilter_rotation(0.0, 0.0, 30.0) @ up
    assert np.allclose(rolled, [-0.5, 0.0, np.sqrt(0.75)])
    north = np.array([0.0, 1.0, 0.0])
    assert np.allclose(tilter_rotation(90.0, 0.0, 0.0) @ north, [1.0, 0.0, 0.0])


def test_mounts_are_read():
    assert Mount.parse(" Y_to@-30.5 ") == Mount("Y", "to", -30.5)
    assert Mount.parse("Z_from").key == "Z_from"


@pytest.mark.parametrize("text", ["", "x_from", "X", "X_away", "X_from@", "X_from@a", "W_to"])
def test_what_is_no_mount_is_refused_with_the_known_ones(text: str):
    with pytest.raises(ValueError, match="X_from"):
        Mount.parse(text)
