"""Numbering of samples by a device's counter, and without one."""

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.counter import SampleCounter
from drivers.events import Event, Lost, Message


def run(
    counter: SampleCounter, counts: list[int] | None, losses: list[int], cuts: list[int]
) -> tuple[list[int], list[Event]]:
    """Number frames that arrive in pieces."""
    index: list[int] = []
    events: list[Event] = []
    edges = [0, *sorted(cut for cut in cuts if 0 < cut < len(losses)), len(losses)]
    for begin, end in itertools.pairwise(edges):
        if begin < end:
            piece = None if counts is None else np.array(counts[begin:end])
            numbers, said = counter.number(piece, np.array(losses[begin:end]))
            index.extend(numbers.tolist())
            events.extend(event for _, event in said)
    return index, events


def test_frames_follow_each_other_without_a_counter():
    index, events = run(SampleCounter(), None, [0] * 6, [2])
    assert index == [0, 1, 2, 3, 4, 5]
    assert events == []


def test_garbage_counts_as_losses_without_a_counter_but_not_before_the_first_frame():
    index, events = run(SampleCounter(), None, [9, 0, 2, 0], [])
    assert index == [0, 1, 4, 5]
    assert events == [Lost(2, 4)]


@pytest.mark.parametrize("step", [1, 3277, 16])
def test_the_step_is_learned_and_the_counter_wraps(step: int):
    counts = [(65000 + step * n) % 65536 for n in range(300)]
    index, events = run(SampleCounter(16), counts, [0] * 300, [100])
    assert index == list(range(300))
    assert events == []


def test_losses_after_the_step_is_known_are_counted_whatever_the_garbage_says():
    counts = [0, 4, 8, 12, 16, 20, 32, 36]
    counter = SampleCounter(8)
    index, events = run(counter, counts, [0, 0, 0, 0, 0, 0, 1, 5], [])
    assert counter.step == 4
    assert index == [0, 1, 2, 3, 4, 5, 8, 9]
    assert events == [Lost(2, 8)]


def test_a_step_that_is_no_whole_number_is_rounded_without_drift():
    counts = [int(3276.8 * n) % 65536 for n in range(2000)]
    index, events = run(SampleCounter(16), counts, [0] * 2000, [])
    assert index == list(range(2000))
    assert events == []


def test_a_given_step_needs_no_learning():
    index, events = run(SampleCounter(8, 2), [250, 252, 0], [0, 0, 0], [])
    assert index == [0, 1, 3]
    assert events == [Lost(1, 3)]


def test_one_loss_while_learning_does_not_mislead():
    counts = [0, 30, 40, 50, 60, 70, 80, 100]
    counter = SampleCounter(16)
    index, events = run(counter, counts, [0] * 8, [])
    assert counter.step == 10
    assert index == [0, 1, 2, 3, 4, 5, 6, 8]
    assert events == [Lost(1, 8)]


def test_differences_that_never_repeat_are_settled_by_the_commonest():
    counts = np.cumsum([0, 100, 99, 101, 98, 102, 97, 103, 96, 104, 95, 105, 94, 106, 93, 107, 100])
    counter = SampleCounter(16)
    run(counter, counts.tolist(), [0] * len(counts), [])
    assert counter.step == 100


def test_a_step_changed_by_a_command_is_learned_again():
    counts = list(range(0, 80, 4)) + list(range(80, 200))
    counter = SampleCounter(8)
    index, _ = run(counter, counts, [0] * len(counts), [7, 31])
    assert counter.step == 1
    assert np.all(np.diff(index[-100:]) == 1)


def test_a_wide_counter_that_jumps_back_was_restarted():
    index, events = run(SampleCounter(32, 100), [5000, 5100, 300, 400], [0] * 4, [])
    assert index == [0, 1, 2, 3]
    assert [event.kind for event in events if isinstance(event, Message)] == ["counter restarted"]


def test_a_wide_counter_wraps_without_a_restart():
    index, events = run(SampleCounter(32, 100), [2**32 - 50, 50, 150], [0] * 3, [])
    assert index == [0, 1, 2]
    assert events == []


def test_a_counter_that_stands_still_is_no_loss():
    index, events = run(SampleCounter(16, 1), [7, 7, 7, 8], [0] * 4, [])
    assert index == [0, 1, 2, 3]
    assert events == []


def test_frames_without_a_counter_among_others_count_one():
    index, events = run(SampleCounter(16, 1), [5, -1, 7, 9], [0] * 4, [])
    assert index == [0, 1, 2, 4]
    assert events == [Lost(1, 4)]


def test_a_told_step_replaces_the_learned_one():
    counter = SampleCounter(8)
    run(counter, [0, 8, 16, 24, 32, 40], [0] * 6, [])
    assert counter.step == 8
    counter.settle(1)
    assert run(counter, [41, 42], [0, 0], []) == ([6, 7], [])


@given(
    changes=st.lists(st.integers(-5, 300), min_size=1, max_size=80),
    bits=st.sampled_from([0, 7, 8, 16, 32]),
    step=st.sampled_from([None, 1, 5]),
    losses=st.lists(st.integers(0, 4), min_size=80, max_size=80),
    cuts=st.lists(st.integers(0, 80), max_size=10),
)
def test_the_pieces_do_not_matter_and_numbers_always_grow(
    changes: list[int], bits: int, step: int | None, losses: list[int], cuts: list[int]
):
    counts = [int(value) % (1 << bits) for value in np.cumsum(changes)]
    counts = [-1 if change == -5 else count for change, count in zip(changes, counts, strict=True)]
    losses = losses[: len(counts)]
    whole = run(SampleCounter(bits, step), counts, losses, [])
    pieces = run(SampleCounter(bits, step), counts, losses, cuts)
    single = run(SampleCounter(bits, step), counts, losses, list(range(80)))
    assert whole[0] == pieces[0] == single[0]
    for kind in (Lost, Message):
        for other in (pieces, single):
            assert [e for e in whole[1] if isinstance(e, kind)] == [
                e for e in other[1] if isinstance(e, kind)
            ]
    assert np.all(np.diff(whole[0]) > 0)
    lost = sum(event.count for event in whole[1] if isinstance(event, Lost))
    assert whole[0][-1] == len(counts) - 1 + lost
