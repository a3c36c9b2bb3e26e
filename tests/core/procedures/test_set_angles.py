"""Which angles were set: every way of telling it, and the order of trust."""

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.angle_errors import PITCH, ROLL, set_direction
from core.procedures.set_angles import set_angles
from core.samples.run import Run

NAN = float("nan")
LIST = [0, 30, 60, 80, 100, 120, 150, 180, 210, 240, 260, 280, 300, 330, 360]


def run_of(mounts: list[str], head: list[float], step: list[float] | None = None) -> Run:
    n = len(mounts)
    unknown = np.full(n, np.nan)
    return Run(
        test="accuracy",
        sensor="accelerometer",
        device="PW09",
        channels=(),
        axes=(),
        unit="code",
        y=np.empty((n, 0)),
        y_se=np.empty((n, 0)),
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n),
        mount=tuple(mounts),
        head_deg=np.array(head, dtype=float),
        set_rate_dps=unknown,
        temperature_c=unknown,
        t_s=unknown,
        extra={} if step is None else {"step": np.array(step)},
    )


FORCE = set_direction(ROLL, np.array([10.0, 20.0, 30.0]))


@pytest.mark.parametrize(
    ("mount", "kind", "sign"),
    [("X_from", PITCH, -1), ("X_to", PITCH, 1), ("Y_from", ROLL, -1), ("Y_to", ROLL, 1)],
)
def test_mount_and_head_angle_tell_everything(mount: str, kind: str, sign: int):
    found, angles, notes = set_angles(run_of([mount] * 3, [0, 30, 170]), None, None, FORCE)
    assert found == kind
    assert np.array_equal(angles, sign * np.array([0.0, 30.0, 170.0]))
    assert notes == ()


def test_re_indexing_moves_the_angle():
    _, angles, _ = set_angles(run_of(["X_to@90"] * 2, [0, 10]), None, None, FORCE)
    assert np.array_equal(angles, [90.0, 100.0])


def test_the_operators_list_stands_before_the_heads():
    run = run_of(["X_from"] * 3, [0, 30, 60])
    found, angles, notes = set_angles(run, None, [1.0, 2.0, 359.0], FORCE)
    assert found == PITCH
    assert np.array_equal(angles, [1.0, 2.0, -1.0])
    assert notes == ()


def test_without_a_mount_the_data_tell_pitch_from_roll():
    run = run_of([""] * 3, [NAN] * 3)
    assert set_angles(run, None, [10.0, 20.0, 30.0], FORCE)[0] == ROLL
    force = set_direction(PITCH, np.array([10.0, 20.0, 30.0]))
    assert set_angles(run, None, [10.0, 20.0, 30.0], force)[0] == PITCH
    assert set_angles(run, PITCH, [10.0, 20.0, 30.0], FORCE)[0] == PITCH


def test_row_numbers_are_places_in_the_practicums_list():
    n = len(LIST)
    run = run_of([""] * n, [NAN] * n, list(range(1, n + 1)))
    force = set_direction(ROLL, np.array(LIST, float))
    found, angles, (note,) = set_angles(run, None, None, force)
    assert found == ROLL
    assert np.array_equal(angles % 360.0, np.array(LIST) % 360.0)
    assert note.subject == "angles_inferred"
    assert "roll 0, 30, 60, 80, ..." in note.text


@pytest.mark.parametrize(
    ("run", "angles", "says"),
    [
        (run_of([""] * 3, [NAN] * 3), None, "give them"),
        (run_of([""] * 3, [NAN] * 3, [1, 2, 16]), None, "give them"),
        (run_of([""] * 3, [NAN] * 3), [1.0], "1 set angles were given for 3 rows"),
        (run_of(["Z_from"] * 3, [0, 1, 2]), None, "neither"),
        (run_of(["X_from", "Y_from", "X_from"], [0, 1, 2]), None, "neither"),
    ],
)
def test_unknown_angles_are_refused(run: Run, angles: list[float] | None, says: str):
    with pytest.raises(FitError, match=says):
        set_angles(run, None, angles, FORCE)
