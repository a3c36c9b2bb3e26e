"""What was added to the model, as the calibrating tabs take it."""

import numpy as np

from core.arrays import FloatArray, frozen
from core.discrepancy.ladder import Ladder
from core.procedures.added import NOTHING, Added
from gui.discrepancy.working import Story
from gui.services import Addition


def addition_of(story: Story) -> Addition:
    """The run of a story with the effects that were added to its model."""
    added = NOTHING if story.ladder is None else added_of(story.ladder)
    return Addition(story.run, story.paths, added)


def added_of(ladder: Ladder) -> Added:
    """The effects of a ladder by the outputs that they act on."""
    problem = ladder.engine.problem
    names = problem.run.channels
    changes: dict[str, FloatArray] = {}
    total = np.sum([slot.change for slot in ladder.slots], axis=0) if ladder.slots else np.zeros(0)
    if np.any(total):
        by_channel = total.reshape(problem.channels, problem.rows)
        changes = {name: frozen(own) for name, own in zip(names, by_channel, strict=True)}
    return Added(
        effects=tuple(
            (
                names[slot.instance.channel] if slot.instance.channel >= 0 else "",
                slot.instance.effect,
            )
            for slot in ladder.slots
            if slot.raw.shape[1]
        ),
        changes=changes,
        columns=problem.stimulus.columns if ladder.slots else {},
    )
