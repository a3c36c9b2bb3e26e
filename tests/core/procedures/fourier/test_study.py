"""A run of one mount gives a split, of two a flip; the output is chosen by what the turn shows."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.study import TumbleRequest, study_tumble
from core.samples.run import Conditions, Run

UNIT_G = Conditions(g_mps2=1.0)
HEAD = np.arange(15.0, 376.0, 15.0)


def run_of(paper, *, flipped: bool = False, noise: float = 1e-5) -> Run:
    rng = np.random.default_rng(5)
    y = paper(HEAD)[:, None] + noise * rng.standard_normal((len(HEAD), 3))
    return run_of_angles(HEAD, y, "V", flipped=flipped)


def both(paper) -> Run:
    one, other = run_of(paper), run_of(paper, flipped=True)
    joined = one.rows([*range(len(one)), *range(len(other))])
    mount = (*one.mount, *other.mount)
    return replace(joined, mount=mount, y=np.vstack([one.y, other.y]))


def test_one_mount_is_split_and_has_test_turns(paper):
    found = study_tumble(run_of(paper), UNIT_G, TumbleRequest())
    assert len(found.tumbles) == len(found.mounts) == len(found.rows) == 1
    assert found.flip is None
    assert found.split is not None
    assert found.split.separable
    assert found.split.k_xy.value == pytest.approx(0.001, rel=0.05)
    assert [pair.axis for pair in found.pairs] == ["x", "y"]


def test_two_mounts_tell_the_fixture_from_the_sensor(paper):
    found = study_tumble(both(paper), UNIT_G, TumbleRequest())
    assert found.split is None
    assert found.flip is not None
    assert [len(rows) for rows in found.rows] == [75, 75]
    assert sorted(i for rows in found.rows for i in rows) == list(range(150))


def test_the_output_along_the_shaft_is_passed_over_unless_it_is_asked_for(paper):
    one = run_of(paper)
    shaft = np.full_like(one.y, 0.25) + 1e-6 * np.arange(len(one))[:, None]
    run = replace(
        one,
        channels=("Z", "X"),
        axes=("z", "x"),
        y=np.hstack([shaft, one.y]),
        y_se=np.hstack([one.y_se, one.y_se]),
    )
    assert study_tumble(run, UNIT_G, TumbleRequest(channel=None)).channel == 1
    with pytest.raises(FitError, match="lies along the shaft"):
        study_tumble(run, UNIT_G, TumbleRequest(channel=0))
    with pytest.raises(FitError, match="lies along the shaft"):
        study_tumble(replace(run, axes=("z", "z")), UNIT_G, TumbleRequest(channel=None))


def test_a_tumble_that_never_stands_upright_has_no_test_turns(paper):
    head = HEAD + 5.0
    run = run_of_angles(head, paper(head), "V")
    assert study_tumble(run, UNIT_G, TumbleRequest()).pairs == ()
