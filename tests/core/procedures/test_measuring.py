"""The walk through a plan: by hand, hands-free, with wrong positions, motion and a broken link."""

from collections.abc import Iterator

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.plans.plan import Step, load_plans
from core.procedures.measuring import Measuring, Outcome, Phase
from core.procedures.recognise import Expectation, Verdict
from core.samples.block import Channel, SampleBlock

G = 9.8106
RATE = 100.0
STEPS = load_plans()["accelerometer_8"].steps
CHANNELS = (
    Channel("wx", "code", "rate.x"),
    *(Channel(f"a{axis}", "code", f"acc.{axis}") for axis in "xyz"),
)
K = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7], [1.4, 14.4, 1335.0]])


class Head:
    """An operator's hand on the dial, sample by sample; the unit's codes come out."""

    def __init__(self) -> None:
        self.index = 0
        self.rng = np.random.default_rng(12)
        self.force = STEPS[0].specific_force(G)

    def rest(self, seconds: float, force: np.ndarray | None = None) -> Iterator[SampleBlock]:
        if force is not None:
            self.force = force
        for _ in range(round(seconds * RATE / 10)):
            yield self._block(np.tile(self.force, (10, 1)))

    def turn(self, step: Step, seconds: float = 2.0) -> Iterator[SampleBlock]:
        start, end = self.force, step.specific_force(G)
        n = round(seconds * RATE)
        path = start + (end - start) * np.linspace(0, 1, n)[:, None]
        self.force = end
        for a in range(0, n, 10):
            yield self._block(path[a : a + 10])

    def _block(self, force: np.ndarray) -> SampleBlock:
        data = np.column_stack([np.zeros(len(force)), force @ K.T - 378.0])
        data += self.rng.normal(0.0, 5.0, data.shape)
        index = self.index + np.arange(len(force))
        self.index += len(force)
        return SampleBlock(CHANNELS, frozen_int(index), frozen(data), RATE)


def a_walk(**settings: float) -> Measuring:
    return Measuring(
        STEPS,
        lambda step: step.specific_force(G),
        lambda step: f"position {step.number} ({step.head_deg:g} deg)",
        Expectation(G, ("x", "y", "z")),
        "acc.",
        accumulation_s=settings.get("accumulation_s", 3.0),
        settle_s=settings.get("settle_s", 1.0),
        rate=RATE,
    )


def run(walk: Measuring, blocks: Iterator[SampleBlock]) -> list[Outcome]:
    """Feed blocks; accept what is acceptable, reject the rest, as the presenter does."""
    outcomes = []
    for block in blocks:
        outcome = walk.feed(block)
        if outcome is not None:
            outcomes.append(outcome)
            (walk.accept if outcome.acceptable else walk.reject)(outcome)
    return outcomes


def test_by_hand_through_all_eight() -> None:
    walk, head = a_walk(), Head()
    for step in STEPS:
        run(walk, head.turn(step))
        assert walk.status.phase is Phase.READY
        assert walk.status.step == step
        walk.start()
        assert walk.status.remaining_s == pytest.approx(3.0)
        (outcome,) = run(walk, head.rest(3.5))
        assert outcome.step == step
        assert outcome.accumulation.n == 300
    assert walk.status.phase is Phase.FINISHED
    assert walk.status.step is None
    assert walk.done == {step.number for step in STEPS}


def test_by_hand_the_settling_after_a_motion_is_counted_down_and_binds_nobody() -> None:
    walk, head = a_walk(settle_s=2.0), Head()
    run(walk, head.rest(3.0))
    assert walk.status.remaining_s == 0.0
    run(walk, head.turn(STEPS[1]))
    assert walk.status.phase is Phase.READY
    left = [walk.status.remaining_s]
    for block in head.rest(4.0):
        run(walk, iter([block]))
        left.append(walk.status.remaining_s)
    assert max(left) == pytest.approx(2.0)
    # It falls to the end once the head rests.
    falling = left[left.index(max(left)) :]
    rest = falling[len(falling) - falling[::-1].index(max(left)) - 1 :]
    assert rest == sorted(rest, reverse=True)
    assert rest[-1] == 0.0
    run(walk, head.turn(STEPS[2]))
    walk.start()
    assert walk.status.phase is Phase.MEASURING


def test_hands_free_needs_no_touch_and_measures_each_position_once() -> None:
    walk, head = a_walk(), Head()
    walk.set_hands_free(True)
    outcomes = run(walk, head.rest(6.0))
    for step in STEPS[1:]:
        outcomes += run(walk, head.turn(step))
        outcomes += run(walk, head.rest(12.0))
    assert [outcome.step for outcome in outcomes] == list(STEPS)
    assert all(outcome.acceptable for outcome in outcomes)
    assert walk.status.phase is Phase.FINISHED


def test_hands_free_passes_through_its_phases() -> None:
    walk, head = a_walk(), Head()
    walk.set_hands_free(True)
    seen: list[Phase] = []

    def watch(blocks: Iterator[SampleBlock]) -> None:
        for block in blocks:
            run(walk, iter([block]))
            if not seen or seen[-1] is not walk.status.phase:
                seen.append(walk.status.phase)

    watch(head.rest(6.0))
    watch(head.turn(STEPS[1]))
    watch(head.rest(6.0))
    cycle = [Phase.SETTLING, Phase.MEASURING, Phase.TURN]
    assert seen == [Phase.TURN, *cycle, Phase.MOVING, *cycle]


def test_a_rest_on_the_way_is_not_measured() -> None:
    """The operator stops at 40 degrees for six seconds, then goes on."""
    walk, head = a_walk(), Head()
    walk.set_hands_free(True)
    run(walk, head.rest(6.0))
    halfway = Step(99, "", "X_from", 40.0)
    assert not run(walk, head.turn(halfway))
    assert not run(walk, head.rest(6.0))
    assert walk.status.phase is Phase.WRONG
    assert "position 2 (90 deg)" in walk.status.text
    run(walk, head.turn(STEPS[1]))
    (outcome,) = run(walk, head.rest(6.0))
    assert outcome.step == STEPS[1]


def test_a_wrong_position_is_not_taken_under_its_label() -> None:
    walk, head = a_walk(), Head()
    for step in STEPS[:3]:
        run(walk, head.turn(step))
        walk.start()
        run(walk, head.rest(3.5))
    walk.start()
    (outcome,) = run(walk, head.rest(3.5))
    assert not outcome.acceptable
    assert outcome.recognition.verdict is Verdict.OTHER_POSITION
    assert "looks like position 3 (180 deg)" in walk.status.text
    assert walk.status.phase is Phase.WRONG
    assert walk.status.step == STEPS[3]
    run(walk, head.turn(STEPS[3]))
    walk.start()
    (outcome,) = run(walk, head.rest(3.5))
    assert outcome.acceptable


def test_motion_during_the_accumulation_is_refused() -> None:
    walk, head = a_walk(), Head()
    walk.start()
    run(walk, head.rest(1.5))
    nudged = Step(99, "", "X_from", 0.3).specific_force(G)
    (outcome,) = run(walk, head.rest(2.0, nudged))
    assert not outcome.acceptable
    assert "the head moved during accumulation" in walk.status.text


def test_a_broken_link_gives_up_the_accumulation_and_keeps_the_rest() -> None:
    walk, head = a_walk(), Head()
    walk.start()
    run(walk, head.rest(3.5))
    walk.start()
    run(walk, head.rest(1.0))
    walk.interrupted()
    assert walk.status.phase is Phase.READY
    assert walk.done == {1}
    assert not run(walk, head.rest(5.0))


def test_choose_cancel_and_reopen() -> None:
    walk, head = a_walk(), Head()
    walk.choose(3)
    assert walk.status.step == STEPS[2]
    run(walk, head.turn(STEPS[2]))
    walk.start()
    run(walk, head.rest(1.0))
    walk.cancel()
    assert walk.status.phase is Phase.READY
    walk.start()
    run(walk, head.rest(3.5))
    assert walk.done == {3}
    walk.reopen(3)
    assert not walk.done
    assert walk.status.step == STEPS[2]


def test_a_resumed_session_knows_what_was_accepted() -> None:
    walk, head = a_walk(), Head()
    for step in STEPS[:2]:
        walk.restore(step.number, K @ step.specific_force(G) - 378.0)
    assert walk.done == {1, 2}
    assert walk.status.step == STEPS[2]
    walk.start()
    (outcome,) = run(walk, head.rest(3.5))  # still in position 1
    assert "looks like position 1" in outcome.recognition.text


@pytest.mark.parametrize("act", ["interrupted", "cancel", "hands_free"])
def test_what_is_finished_stays_finished(act: str) -> None:
    walk, head = a_walk(), Head()
    for step in STEPS:
        walk.restore(step.number, step.specific_force(G) @ K.T - 378.0)
    if act == "hands_free":
        walk.set_hands_free(True)
    else:
        getattr(walk, act)()
    assert walk.status.phase is Phase.FINISHED
    walk.set_hands_free(True)
    assert run(walk, head.turn(STEPS[-1])) == []
    assert run(walk, head.rest(6.0)) == []


def test_hands_free_after_a_turn_by_hand_measures_where_the_unit_stands() -> None:
    walk, head = a_walk(), Head()
    walk.start()
    run(walk, head.rest(3.5))
    run(walk, head.turn(STEPS[1]))
    run(walk, head.rest(2.0))
    walk.set_hands_free(True)
    (outcome,) = run(walk, head.rest(6.0))
    assert outcome.step == STEPS[1]


def test_a_turn_while_the_link_was_broken_is_seen() -> None:
    walk, head = a_walk(), Head()
    walk.set_hands_free(True)
    run(walk, head.rest(6.0))
    walk.interrupted()
    list(head.turn(STEPS[1]))
    (outcome,) = run(walk, head.rest(7.0))
    assert outcome.step == STEPS[1]


def test_a_broken_link_does_not_measure_the_same_place_again() -> None:
    walk, head = a_walk(), Head()
    walk.set_hands_free(True)
    run(walk, head.rest(6.0))
    walk.interrupted()
    assert run(walk, head.rest(7.0)) == []
    assert walk.status.phase is Phase.TURN


def test_reopening_gives_up_what_is_being_accumulated_for_another_step() -> None:
    walk, head = a_walk(), Head()
    walk.start()
    run(walk, head.rest(3.5))
    run(walk, head.turn(STEPS[1]))
    walk.start()
    run(walk, head.rest(1.0))
    walk.reopen(STEPS[0].number)
    assert walk.status.progress == 0.0
    assert run(walk, head.rest(4.0)) == []


def test_hands_free_on_a_rig_that_is_not_set_yet_waits_for_its_motion() -> None:
    walk, head = a_walk(), Head()
    walk.wait_for_motion()
    walk.set_hands_free(True)
    assert run(walk, head.rest(8.0)) == []
    assert walk.status.phase is Phase.TURN
    outcomes = run(walk, head.turn(STEPS[2]))
    outcomes += run(walk, head.turn(STEPS[0]))
    outcomes += run(walk, head.rest(8.0))
    assert [outcome.step for outcome in outcomes] == [STEPS[0]]


def test_each_step_may_have_its_own_time() -> None:
    walk = Measuring(
        STEPS,
        lambda step: step.specific_force(G),
        lambda step: f"position {step.number}",
        Expectation(G, ("x", "y", "z")),
        "acc.",
        accumulation_s=lambda step: 1.0 + step.number,
        settle_s=1.0,
        rate=RATE,
    )
    head = Head()
    for step in STEPS[:2]:
        run(walk, head.turn(step))
        walk.start()
        (outcome,) = run(walk, head.rest(6.0))
        assert outcome.accumulation.n == 100 * (1 + step.number)
