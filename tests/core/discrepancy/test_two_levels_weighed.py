"""What stands in no catalogue against the names that imitate it: two levels, one curve for many."""

from dataclasses import replace
from itertools import product
from math import comb, log

import numpy as np
import pytest

from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import UNKNOWN, Gap, NoiseFloor, Where
from core.discrepancy.settings import Settings
from core.discrepancy.two_levels import SURE, _climbed, two_levels
from core.discrepancy.verdict import ROWS, USUAL, Limits, doubted, is_excess
from core.discrepancy.weighed import weighed
from tests.core.discrepancy.hidden import APART, FORTY_EIGHT, WHITE, Truth, head_run

QUICK = Settings(advise=False)


def to_and_fro(truth: Truth) -> np.ndarray:
    """A bias of 5 accumulations' noise that changes level every 13 rows."""
    return 5.0 * WHITE * ((np.arange(len(truth.t)) // 13) % 2)


def notched(truth: Truth) -> np.ndarray:
    return 4e-4 * np.exp(-0.5 * ((truth.a[:, 2] - 0.35) / 0.12) ** 2)


def test_no_path_is_better_than_the_one_that_is_climbed_to():
    rng = np.random.default_rng(3)
    n = 9
    for _ in range(20):
        root = rng.standard_normal((n, n))
        inner, pull = root @ root.T, 3.0 * rng.standard_normal(n)

        def worth(path: np.ndarray, inner: np.ndarray = inner, pull: np.ndarray = pull) -> float:
            count = int(np.sum(path[1:] != path[:-1]))
            price = log(comb(n - 1, count)) + log(n)
            return 0.5 * float(path @ pull) ** 2 / float(path @ inner @ path) - price

        path, gain, price = _climbed(inner, pull, np.where(pull > 0.0, 1.0, -1.0))
        value = gain - price
        assert value == pytest.approx(worth(path))
        near = [
            worth(np.concatenate([path[:i], -path[i:j], path[j:]]))
            for i in range(n)
            for j in range(i + 1, n + 1)
            if np.sum(np.diff(np.concatenate([path[:i], -path[i:j], path[j:]])) != 0) > 1
        ]
        assert value >= max(near) - 1e-9
    every = [np.array(p) for p in product((-1.0, 1.0), repeat=n) if np.sum(np.diff(p) != 0) > 1]
    assert value >= np.quantile([worth(path) for path in every], 0.95)


def test_a_bias_between_two_levels_is_neither_drift_nor_a_name():
    story = explain(head_run(to_and_fro, FORTY_EIGHT, seed=4), QUICK)
    assert [step.effect for step in story.steps] == [UNKNOWN]
    assert "to and fro between two levels" in story.steps[0].plain
    assert story.verdict == "unexplained_structure"
    true = to_and_fro(Truth(*[np.zeros(96)] * 7))
    assert abs(np.corrcoef(story.steps[0].curve, true)[0, 1]) > 0.9
    assert story.steps[0].after.gap < 1.3


def test_drift_alone_is_not_taken_for_two_levels():
    for seed in range(4):
        ladder = Ladder.of(head_run(rows=FORTY_EIGHT, seed=seed), QUICK)
        levels = two_levels(ladder.engine, ladder.state)
        assert levels is not None
        assert levels.evidence < 0.5 * SURE


def test_a_jump_stays_a_jump():
    story = explain(head_run(lambda q: 12.0 * WHITE * (q.t > 1500.0), FORTY_EIGHT, seed=2), QUICK)
    assert [step.effect for step in story.steps] == ["bias_jump"]


def test_hysteresis_has_two_levels_as_well_and_keeps_its_name():
    def hysteretic(truth: Truth) -> np.ndarray:
        up = np.diff(truth.a[:, 2], prepend=truth.a[0, 2]) > 0.0
        return 3.0 * WHITE * np.where(up, 1.0, -1.0)

    for seed in (1, 3):
        story = explain(head_run(hysteretic, FORTY_EIGHT, seed=seed), QUICK)
        (step,) = story.steps
        assert step.effect == "hysteresis"
        assert UNKNOWN not in step.indistinguishable_from


def test_names_that_one_curve_replaces_are_all_in_doubt():
    ladder = Ladder.of(head_run(notched, FORTY_EIGHT, seed=1), QUICK)
    search = ladder.engine.search
    slots = tuple(
        search.slot(int(np.flatnonzero(ladder.engine.bank.name == place)[0]))
        for place, name in enumerate(ladder.engine.bank.names)
        if name in ("second_order_nonlinearity", "third_order_nonlinearity")
    )
    curve = search.unknown(ladder.state).evidence
    assert curve > 0.65 * search.together(slots, ladder.state)
    story = ladder.found().explanation
    assert story.verdict in ("ambiguous", "unexplained_structure")
    assert all(UNKNOWN in (step.effect, *step.indistinguishable_from) for step in story.steps)


def test_two_true_effects_are_not_called_an_imitation():
    run = head_run(lambda q: 4e-4 * q.a[:, 2] ** 2 + 8.0 * WHITE * (q.t > 1500.0), APART, seed=3)
    state, unknown, imitated = weighed(Ladder.of(run, QUICK).engine, ())
    assert {slot.name for slot in state.slots} == {"second_order_nonlinearity", "bias_jump"}
    assert unknown is None
    assert not imitated


def test_a_body_that_creeps_after_each_setting_is_unknown_structure():
    def creeping(truth: Truth) -> np.ndarray:
        late, out = 0.0, np.zeros(len(truth.t))
        for row in range(1, len(out)):
            part = np.exp(-(truth.t[row] - truth.t[row - 1]) / 300.0)
            late = part * late + (1.0 - part) * truth.a[row - 1, 2]
            out[row] = 4e-4 * late
        return out

    rows = [APART[int(i)] for i in np.random.default_rng(8).permutation(len(APART))]
    ladder = Ladder.of(head_run(creeping, rows, seed=6), QUICK)
    unknown = ladder.engine.search.unknown(ladder.state)
    assert ladder.engine.regressors[unknown.regressor].name == "previous"
    story = ladder.found().explanation
    assert story.steps
    assert UNKNOWN in (story.steps[-1].effect, *story.steps[-1].indistinguishable_from)


def test_left_over_structure_puts_every_name_in_doubt_that_does_not_stand_out_by_far():
    run = head_run(lambda q: 4e-4 * q.a[:, 2] ** 2 + 8.0 * WHITE * (q.t > 1500.0), APART, seed=3)
    story = Ladder.of(run, QUICK).found().explanation
    weak = [replace(step, evidence=30.0, indistinguishable_from=()) for step in story.steps]
    steps = (replace(weak[0], evidence=90.0), *weak)
    left = tuple(replace(where, p_value=0.03) for where in story.where)

    def doubtful(limits: Limits, where: tuple[Where, ...] = left) -> list[bool]:
        found = doubted(steps, story.noise, where, 0.01, limits)
        return [UNKNOWN in step.indistinguishable_from for step in found]

    assert doubtful(ROWS) == [False, True, True]
    assert doubtful(USUAL) == [False, False, False]
    only_named = tuple(w for w in left if w.regressor in ("mount", "run", "direction"))
    assert only_named
    assert doubtful(ROWS, only_named) == [False, False, False]


def test_rows_that_leave_more_than_the_noise_are_told_earlier_than_records():
    gap = Gap(rms=1.0, gap=1.4, chi2_red=1.96, dof=60, p_value=0.005, lack_p=0.5)
    noise = NoiseFloor(1.0, "V", {}, {}, "y_se", 0)
    assert is_excess(gap, noise, ROWS)
    assert not is_excess(gap, noise, USUAL)
    assert not is_excess(replace(gap, p_value=0.05), noise, ROWS)
    assert not is_excess(replace(gap, gap=1.2), noise, ROWS)
