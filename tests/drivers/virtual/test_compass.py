"""Own angles of the attitude unit against attitudes built by hand."""

import numpy as np
import pytest

from core.model.stimulus import Stimulus
from drivers.virtual.compass import magnetic_field, own_angles


def rotation(axis: str, degrees: float) -> np.ndarray:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {
        "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis]


def seen(heading: float, pitch: float, roll: float) -> Stimulus:
    """A unit (Y ahead, X right, Z up) turned by heading, then pitch, then roll."""
    # Columns of `world` are the case axes in east, north, up; heading runs clockwise.
    world = rotation("z", -heading) @ rotation("x", pitch) @ rotation("y", roll)
    up, north = world.T @ [0.0, 0.0, 1.0], world.T @ [0.0, 1.0, 0.0]
    return Stimulus(
        a=9.81 * up[None, :],
        w=np.zeros((1, 3)),
        da_dhead=np.zeros((1, 3)),
        dw_drate=np.zeros((1, 3)),
        columns={f"north_{axis}": north[k : k + 1] for k, axis in enumerate("xyz")},
    )


@pytest.mark.parametrize("pitch", [-60.0, 0.0, 30.0])
@pytest.mark.parametrize("roll", [-120.0, 0.0, 45.0])
def test_pitch_and_roll(pitch, roll):
    heading, own_pitch, own_roll = own_angles(seen(70.0, pitch, roll))[0]
    assert own_pitch == pytest.approx(pitch + 0.02)
    assert own_roll == pytest.approx(roll - 0.05)
    if roll == 0.0:
        assert heading == pytest.approx(70.4)


@pytest.mark.parametrize("heading", [0.0, 90.0, 248.45, 359.8])
def test_heading_runs_clockwise_from_north(heading):
    assert own_angles(seen(heading, 10.0, 0.0))[0, 0] == pytest.approx((heading + 0.4) % 360.0)


def test_field_points_north_and_down():
    field = magnetic_field(seen(0.0, 0.0, 0.0))[0] - [310.0, -140.0, 220.0]
    assert np.allclose(field, [0.0, 20_000.0, -45_500.0])
