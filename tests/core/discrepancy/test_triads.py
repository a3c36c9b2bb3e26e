"""Outputs of a triad together: what the rig does to all of them is one fault, not three."""

from dataclasses import replace

import numpy as np

from core.discrepancy.ladder import explain
from core.discrepancy.settings import Settings
from core.samples.run import Run
from tests.core.discrepancy.hidden import K, felt, head_run

ROWS = [
    (run, mount, angle)
    for run in (1, 2)
    for mount in ("X_from", "Y_from", "Z_from")
    for angle in np.arange(0.0, 360.0, 45.0)
]
QUICK = Settings(advise=False)


def triad(extra: np.ndarray | float = 0.0, off: dict[int, float] | None = None) -> Run:
    """Three sensors with errors of the settings in common; some rows stood off by so many deg."""
    base = head_run(rows=ROWS)
    rng = np.random.default_rng(5)
    dial = {angle: rng.normal(0.0, 5.0) for angle in np.arange(0.0, 360.0, 45.0)}
    n = len(ROWS)
    a = np.array(
        [
            felt(
                mount, angle + (dial[angle] + rng.normal(0.0, 3.0)) / 3600.0 + (off or {}).get(i, 0)
            )
            for i, (_, mount, angle) in enumerate(ROWS)
        ]
    )
    matrix = np.eye(3) + 0.01 * rng.standard_normal((3, 3))
    y = K * (a @ matrix.T + 0.002 + extra + 25e-6 * rng.standard_normal((n, 3)))
    se = np.full((n, 3), K * 25e-6)
    return replace(base, y=y, y_se=se, channels=("x", "y", "z"), axes=("x", "y", "z"))


def test_a_clean_triad_is_left_alone():
    assert explain(triad(), QUICK).verdict == "adequate"


def test_a_wrong_angle_is_one_fault_of_all_outputs():
    story = explain(triad(off={13: 1.0}), QUICK)
    (step,) = story.steps
    assert step.effect == "wrong_angle"
    assert "outlier" not in step.indistinguishable_from
    value = step.parameters[0]
    assert abs(value.value - 1.0) < 0.02
    assert step.parameters[1].value == 14.0


def test_an_outlier_of_one_output_is_no_wrong_angle():
    extra = np.zeros((len(ROWS), 3))
    extra[17, 1] = 2e-3
    (step,) = explain(triad(extra), QUICK).steps
    assert step.effect == "outlier"
    assert step.parameters[0].name == "error (y)"


def test_what_comes_to_each_output_by_itself_is_one_step():
    late = np.arange(len(ROWS))[:, None] >= 24
    (step,) = explain(triad(late * np.array([1e-3, -6e-4, 8e-4])), QUICK).steps
    assert {"run_bias", "bias_jump"} & {step.effect, *step.indistinguishable_from}
    assert [p.name.rpartition(" ")[2] for p in step.parameters[:3]] == ["(x)", "(y)", "(z)"]


def test_two_rows_in_each_others_place_are_found_in_all_outputs_at_once():
    run = triad()
    y = run.y.copy()
    y[[5, 30]] = y[[30, 5]]
    story = explain(replace(run, y=y), QUICK)
    assert [step.effect for step in story.steps] == ["positions_swapped"]
    assert story.verdict == "data_fault"


def test_outputs_in_each_others_columns_are_recognised():
    run = triad()
    y = run.y.copy()
    y[16:24] = y[16:24][:, [1, 0, 2]]
    assert explain(replace(run, y=y), QUICK).steps[0].effect == "channels_permuted"


def test_sensors_exchanged_before_their_amplifiers_are_recognised_at_any_scale():
    run = triad()
    scales = np.array([1.0, -1.3, 0.8])
    y = run.y.copy()
    y[16:24] = y[16:24][:, [2, 1, 0]]
    run = replace(run, y=y * scales, y_se=run.y_se * np.abs(scales))
    story = explain(run, QUICK)
    assert [step.effect for step in story.steps] == ["channels_permuted"]
    assert story.verdict == "data_fault"
    assert story.after.gap < 1.5


def test_a_reading_stored_again_is_one_fault_of_all_outputs():
    run = triad()
    y = run.y.copy()
    y[20] = y[19]
    assert [step.effect for step in explain(replace(run, y=y), QUICK).steps] == ["stuck_reading"]
