"""Samples numbered on over interruptions."""

import math

import numpy as np

from core.arrays import frozen, frozen_int
from core.samples.block import Channel, SampleBlock
from drivers.events import Garbage
from drivers.spells import Spell, numbered, rate_of


def block(first: int, count: int) -> SampleBlock:
    index = np.arange(first, first + count)
    return SampleBlock((Channel("a"),), frozen_int(index), frozen(index[:, None]), 0.0)


def spell(first: int, t: float, reads: int = 11) -> Spell:
    """Ten samples a read, ten reads a second."""
    made = Spell()
    made.take([Garbage(3, b"xyz")], t - 0.1)
    for read in range(reads):
        made.take([block(first + 10 * read, 10)], t + 0.1 * read)
    return made


def test_the_rate_leaves_the_interruptions_out():
    assert math.isclose(rate_of([spell(0, 0.0), spell(110, 500.0)]), 100.0)
    assert math.isnan(rate_of([spell(0, 0.0, reads=1)]))


def test_a_gap_is_as_long_as_the_interruption_by_the_clock():
    first, second = spell(0, 0.0), spell(110, 3.0)
    assert (first.last, first.last_t) == (109, 1.0)
    index = np.concatenate([part.index for part in numbered([first, second], 100.0)])
    # 2 s after sample 109 had come, ten samples had come again, the last of them number 309.
    assert index[:110].tolist() == list(range(110))
    assert index[110:].tolist() == list(range(300, 410))


def test_a_second_spell_that_came_at_once_leaves_no_gap():
    parts = numbered([spell(0, 0.0), spell(110, 1.1)], 100.0)
    index = np.concatenate([part.index for part in parts])
    assert index.tolist() == list(range(220))
