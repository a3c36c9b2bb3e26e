"""Samples that come late and all at once are walked as if they had come in time."""

from dataclasses import replace

import numpy as np

from core.arrays import frozen, frozen_int
from core.plans.plan import Step
from core.samples.block import SampleBlock
from gui.measuring.walk import _parts
from tests.gui.desk import Desk
from tests.gui.fake_bench import RATE


def gathered(desk: Desk, *stays: tuple[Step, float, float]) -> SampleBlock:
    """One block of everything that the unit sends in some stays: step, seconds, deg/s."""
    blocks: list[SampleBlock] = []
    desk.connection.blocks.disconnect()
    desk.connection.blocks.connect(blocks.append)
    for step, seconds, turn in stays:
        desk.connection.stand(step, seconds, turn_dps=turn)
    desk.connection.blocks.disconnect()
    return replace(
        blocks[0],
        index=frozen_int(np.concatenate([block.index for block in blocks])),
        data=frozen(np.concatenate([block.data for block in blocks])),
    )


def test_pieces_are_short_and_lose_nothing(desk: Desk):
    block = gathered(desk, (desk.step, 3.3, 0.0))
    pieces = list(_parts(block))
    assert max(len(piece.index) for piece in pieces) <= 0.25 * RATE
    assert np.array_equal(np.concatenate([piece.data for piece in pieces]), block.data)
    assert np.array_equal(np.concatenate([piece.index for piece in pieces]), block.index)
    short = replace(block, index=block.index[:5], data=block.data[:5])
    assert list(_parts(short)) == [short]


def test_a_turn_inside_one_late_block_is_seen(desk: Desk):
    desk.presenter.set_hands_free(True)
    first, second = desk.sitting.plan.steps[:2]
    late = gathered(desk, (first, 4.0, 0.0), (first, 0.4, -90.0), (second, 4.0, 0.0))
    desk.sitting.walk.on_block(late)
    assert desk.numbers == [first.number, second.number]
