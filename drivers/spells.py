"""Bytes of a log that was interrupted, decoded again: samples numbered on over what is missing."""

import math
from dataclasses import replace

from core.arrays import frozen_int
from core.samples.block import SampleBlock
from drivers.events import Event


class Spell:
    """What came between two interruptions, with the clock at its ends."""

    def __init__(self) -> None:
        self.blocks: list[SampleBlock] = []
        self.first_t = self.last_t = 0.0
        self.first_end = 0
        """Number of the newest sample that the first read with samples gave."""

    def take(self, events: list[Event], t: float) -> None:
        """Take what the bytes of a read gave."""
        found = [event for event in events if isinstance(event, SampleBlock)]
        if not found:
            return
        if not self.blocks:
            self.first_t, self.first_end = t, int(found[-1].index[-1])
        self.blocks += found
        self.last_t = t

    @property
    def last(self) -> int:
        """Number of the last sample."""
        return int(self.blocks[-1].index[-1])


def rate_of(spells: list[Spell]) -> float:
    """Samples per second by the clock, the interruptions left out; NaN where it cannot be told."""
    steps = sum(spell.last - spell.first_end for spell in spells)
    span = sum(spell.last_t - spell.first_t for spell in spells)
    return steps / span if span > 0.0 else math.nan


def numbered(spells: list[Spell], rate: float) -> list[SampleBlock]:
    """Number samples on over interruptions, which leave gaps as long as they were by the clock."""
    blocks: list[SampleBlock] = []
    shift = 0
    for before, spell in zip([None, *spells], spells, strict=False):
        if before is not None:
            steps = round((spell.first_t - before.last_t) * rate)
            shift += max(0, before.last + steps - spell.first_end)
        blocks += [replace(block, index=frozen_int(block.index + shift)) for block in spell.blocks]
    return blocks
