"""Full turns, cross angles, mounting and statistics, against turned vectors."""

import numpy as np
import pytest

from core.plans.plan import load_plans
from core.procedures.angle_errors import (
    PITCH,
    ROLL,
    Statistics,
    aligned,
    cross_error,
    direction,
    heading_error,
    is_full_turn,
    main_angle,
    set_direction,
    wrapped,
)

ANGLES = np.array([0, 30, 60, 80, 100, 120, 150, 180, 210, 240, 260, 280, 300, 330, 360], float)


def test_angles_are_wrapped_above_minus_180_to_180():
    assert np.array_equal(
        wrapped(np.array([-180.0, 180, 181, -181, 540, 0])), [180, 180, -179, 179, 180, 0]
    )


@pytest.mark.parametrize(
    ("kind", "angles", "expected"),
    [
        (PITCH, [0, 30, 60], False),
        (PITCH, [0, 30, 300], False),
        (PITCH, [0, 90], True),
        (PITCH, [120], True),
        (ROLL, [0, 120], False),
    ],
)
def test_only_pitch_needs_the_in_plane_angle(kind: str, angles: list[float], expected: bool):
    assert is_full_turn(kind, np.array(angles, float)) is expected


@pytest.mark.parametrize("kind", [PITCH, ROLL])
def test_a_right_unit_has_no_errors_over_the_full_turn(kind: str):
    force = set_direction(kind, ANGLES)
    angle = main_angle(kind, force, full_turn=is_full_turn(kind, ANGLES))
    assert np.allclose(wrapped(angle - ANGLES), 0.0, atol=1e-12)
    cross = cross_error(kind, ANGLES, force)
    assert np.allclose(cross[np.isfinite(cross)], 0.0, atol=1e-12)
    assert np.count_nonzero(np.isnan(cross)) == 0


@pytest.mark.parametrize(("plan", "kind"), [("pitch_accuracy", PITCH), ("roll_accuracy", ROLL)])
def test_set_directions_are_those_of_the_plans(plan: str, kind: str):
    steps = load_plans()[plan].steps
    force = np.array([step.specific_force(1.0) for step in steps])
    assert np.allclose(force, set_direction(kind, ANGLES), atol=1e-12)


def test_reported_angles_become_directions_and_back():
    rng = np.random.default_rng(1)
    pitch, roll = rng.uniform(-89, 89, 50), rng.uniform(-179, 179, 50)
    force = direction(pitch, roll)
    assert np.allclose(np.linalg.norm(force, axis=1), 1.0)
    assert np.allclose(main_angle(PITCH, force, full_turn=False), pitch)
    assert np.allclose(main_angle(ROLL, force, full_turn=False), roll)


def test_a_unit_past_the_vertical_reports_the_other_side():
    # At 120 degrees of pitch a right unit says pitch 60, roll 180 and the opposite heading.
    force = direction(np.array([0.0, 60.0]), np.array([0.0, 180.0]))
    set_deg = np.array([0.0, 120.0])
    assert np.allclose(main_angle(PITCH, force, full_turn=True), set_deg)
    assert np.allclose(cross_error(PITCH, set_deg, force), 0.0, atol=1e-12)
    assert np.allclose(heading_error(PITCH, set_deg, np.array([40.0, 220.0])), 0.0)


def test_roll_and_heading_are_not_judged_near_the_vertical():
    set_deg = np.array([0.0, 88.0, 92.0, -87.0, 84.0])
    force = set_direction(PITCH, set_deg)
    assert list(np.isnan(cross_error(PITCH, set_deg, force))) == [False, True, True, True, False]
    headings = heading_error(PITCH, set_deg, np.full(5, 10.0))
    assert list(np.isnan(headings)) == [False, True, True, True, False]


def test_heading_is_compared_with_the_first_row():
    found = heading_error(ROLL, np.array([0.0, 30.0]), np.array([359.0, 2.0]))
    assert np.allclose(found, [0.0, 3.0])


@pytest.mark.parametrize("kind", [PITCH, ROLL])
def test_alignment_takes_a_mounting_error_out_and_nothing_else(kind: str):
    small = np.deg2rad([0.3, -0.5, 0.2])
    skew = np.array([[0, -small[2], small[1]], [small[2], 0, -small[0]], [-small[1], small[0], 0]])
    mounted = set_direction(kind, ANGLES) @ (np.eye(3) + skew).T
    angle = main_angle(kind, mounted, full_turn=kind == PITCH)
    assert np.abs(wrapped(angle - ANGLES)).max() > 0.2
    straight = aligned(kind, ANGLES, mounted)
    again = main_angle(kind, straight, full_turn=kind == PITCH)
    assert np.abs(wrapped(again - ANGLES)).max() < 0.01
    assert np.allclose(
        np.linalg.norm(straight, axis=1), np.linalg.norm(mounted, axis=1), rtol=1e-12
    )
    # A scale error of one axis is no rotation, and stays.
    scaled = set_direction(kind, ANGLES) * [1.01, 1.01, 1.0]
    left = main_angle(kind, aligned(kind, ANGLES, scaled), full_turn=kind == PITCH)
    assert np.abs(wrapped(left - ANGLES)).max() > 0.2


def test_statistics_of_pointer():
    errors = np.array([-0.2, 0.1, np.nan, 0.4])
    found = Statistics.of(errors, np.array([0.1, np.nan, 0.3, np.nan]))
    assert (found.minimum, found.maximum) == (-0.2, 0.4)
    assert found.half_span == pytest.approx(0.3)
    assert found.rms == pytest.approx(np.sqrt((0.04 + 0.01 + 0.16) / 3))
    assert found.noise_std == pytest.approx(np.sqrt(0.05))
    assert np.isnan(Statistics.of(errors, np.full(4, np.nan)).noise_std)
