"""Pitch and roll: Table 2.4, the branches of (2.10), the poles, and the uncertainty."""

import numpy as np
import pytest

from core.procedures.attitude import attitude

G = 9.8106
SIGMA2 = (1e-3 * G) ** 2 * np.eye(3)


def force(pitch_deg: np.ndarray, roll_deg: np.ndarray) -> np.ndarray:
    """(2.8), written out."""
    t, r = np.radians(pitch_deg), np.radians(roll_deg)
    return G * np.column_stack([-np.cos(t) * np.sin(r), np.sin(t), np.cos(r) * np.cos(t)])


def test_grid_of_angles_comes_back() -> None:
    pitch, roll = np.meshgrid(np.arange(-89.0, 90.0, 7.0), np.arange(-179.0, 181.0, 9.0))
    a = force(pitch.ravel(), roll.ravel())
    found = attitude(a, np.broadcast_to(1e-9 * np.eye(3), (len(a), 3, 3)))
    np.testing.assert_allclose(found.pitch, pitch.ravel(), atol=1e-10)
    np.testing.assert_allclose(found.roll, roll.ravel(), atol=1e-9)


def test_branches_follow_2_10() -> None:
    a = np.array([[-1.0, 0, -5.0], [1.0, 0, -5.0], [0.0, 0, -5.0], [-0.0, 0, -5.0]])
    roll = attitude(a, np.broadcast_to(1e-9 * np.eye(3), (4, 3, 3))).roll
    np.testing.assert_allclose(roll[:2], [168.690068, -168.690068], rtol=1e-8)
    assert roll[2] == 180.0
    assert roll[3] == 180.0


def test_the_in_plane_angle_goes_through_full_turns() -> None:
    angle = np.arange(-170.0, 181.0, 10.0)
    a = G * np.column_stack([np.zeros(36), np.sin(np.radians(angle)), np.cos(np.radians(angle))])
    found = attitude(a, np.broadcast_to(SIGMA2, (36, 3, 3)))
    np.testing.assert_allclose(found.plane, angle, atol=1e-10)
    np.testing.assert_allclose(found.u_plane, np.degrees(1e-3), rtol=1e-9)


def test_roll_is_undefined_on_end_and_pitch_keeps_its_precision() -> None:
    a = force(np.array([90.0, 89.0]), np.array([0.0, 30.0]))
    found = attitude(a, np.broadcast_to(SIGMA2, (2, 3, 3)))
    assert np.isnan(found.roll[0])
    assert np.isnan(found.u_roll[0])
    assert found.roll[1] == pytest.approx(30.0)
    assert found.pitch[1] == pytest.approx(89.0, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("pitch", [0.0, 45.0, 89.0])
def test_uncertainties_agree_with_simulation(pitch: float) -> None:
    rng = np.random.default_rng(11)
    covariance = np.array([[4.0, 1.0, 0.5], [1.0, 3.0, -0.5], [0.5, -0.5, 2.0]]) * 1e-6
    a = force(np.array([pitch]), np.array([20.0]))
    draws = a + rng.multivariate_normal(np.zeros(3), covariance, 20000)
    many = attitude(draws, np.broadcast_to(covariance, (20000, 3, 3)))
    one = attitude(a, covariance[None])
    assert np.std(many.pitch) == pytest.approx(one.u_pitch[0], rel=0.03)
    assert np.std(many.roll) == pytest.approx(one.u_roll[0], rel=0.03)
    assert np.std(many.plane) == pytest.approx(one.u_plane[0], rel=0.03)
