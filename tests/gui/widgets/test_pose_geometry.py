"""Axis directions of the picture against the practicum's figures (Tables 1.1 and 2.1)."""

import numpy as np
import pytest

from core.plans.orientation import specific_force
from gui.widgets.pose_geometry import axis_marks, case_axes
from gui.widgets.states import Pose

# Directions read off the figures: U up, D down, R right, L left, dot towards the viewer, cross
# away. The mounts "to" follow from "from" by half a turn about the vertical at angle zero.
FIGURES = {
    ("X_from", 0): "dot R U",
    ("X_from", 90): "dot D R",
    ("X_from", 180): "dot L D",
    ("X_from", 270): "dot U L",
    ("Y_from", 0): "L dot U",
    ("Y_from", 90): "U dot R",
    ("Y_from", 180): "R dot D",
    ("Y_from", 270): "D dot L",
    ("X_to", 0): "cross L U",
    ("X_to", 90): "cross U R",
    ("X_to", 180): "cross R D",
    ("X_to", 270): "cross D L",
    ("Y_to", 0): "R cross U",
    ("Y_to", 90): "D cross R",
    ("Y_to", 180): "L cross D",
    ("Y_to", 270): "U cross L",
}
PLANE = {"U": (0, 1), "D": (0, -1), "R": (1, 0), "L": (-1, 0)}


@pytest.mark.parametrize(("mount", "head_deg"), FIGURES)
def test_sixteen_positions_look_as_in_the_practicum(mount, head_deg):
    marks = axis_marks(case_axes(Pose(mount, head_deg)))
    for mark, name, figure in zip(marks, "XYZ", FIGURES[mount, head_deg].split(), strict=True):
        assert mark.name == name
        assert mark.in_plane == (figure in PLANE)
        if figure in PLANE:
            assert (mark.right, mark.up) == PLANE[figure]
            assert mark.toward == 0
        else:
            assert mark.toward == (1 if figure == "dot" else -1)


@pytest.mark.parametrize("mount", ["X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to"])
def test_everything_turns_clockwise_with_the_head(mount):
    before = case_axes(Pose(mount, 20.0))
    after = case_axes(Pose(mount, 50.0))
    c, s = np.cos(np.radians(30.0)), np.sin(np.radians(30.0))
    # Clockwise in the plane of right (column 1) and up (column 2).
    clockwise = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    assert np.allclose(after, before @ clockwise, atol=1e-12)


def test_upward_part_is_the_specific_force():
    pose = Pose("Y_to@90", 37.0)
    ups = [mark.up for mark in axis_marks(case_axes(pose))]
    assert np.allclose(9.81 * np.array(ups), specific_force(pose.mount, pose.head_deg, 9.81))


def test_tilter_lifts_y_by_its_pitch():
    marks = axis_marks(case_axes(Pose("X_from", 0.0, (0.0, 30.0, 0.0))))
    assert marks[1].up == pytest.approx(0.5)
    assert marks[0].toward == pytest.approx(1.0)


def test_tilter_turns_about_the_axes_of_the_case():
    marks = axis_marks(case_axes(Pose("Y_from", 0.0, (0.0, 30.0, 0.0))))
    # Y looked at the viewer and X to the left; pitch lifts Y and leaves X.
    assert marks[1].up == pytest.approx(0.5)
    assert marks[0].right == pytest.approx(-1.0)
    assert marks[2].toward == pytest.approx(-0.5)


def test_axes_stay_orthonormal_with_a_tilter():
    axes = case_axes(Pose("Z_to@15", 33.0, (10.0, 20.0, 30.0)))
    assert np.allclose(axes @ axes.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(axes) == pytest.approx(1.0)


def test_unknown_mount_is_refused():
    with pytest.raises(ValueError, match="unknown mount 'W_from'"):
        case_axes(Pose("W_from", 0.0))
