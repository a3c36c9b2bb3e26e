"""Blocks and their channels."""

import numpy as np

from core.arrays import frozen, frozen_int
from core.samples.block import Channel, SampleBlock, chosen_columns

CHANNELS = (Channel("X", "code", "acc.x"), Channel("Y", "code", "acc.y"), Channel("T"))


def test_a_column_is_found_by_its_role() -> None:
    block = SampleBlock(CHANNELS, frozen_int([4, 5]), frozen([[1, 2, 3], [4, 5, 6]]), 100.0)
    column = block.column("acc.y")
    assert column is not None
    np.testing.assert_array_equal(column, [2.0, 5.0])
    assert block.column("rate.x") is None


def test_columns_are_chosen_by_the_start_of_the_role() -> None:
    assert chosen_columns(CHANNELS, "acc.") == [0, 1]
    assert chosen_columns(CHANNELS, "rate.") == []


def test_a_channel_is_in_codes_until_something_else_is_said() -> None:
    assert (CHANNELS[2].unit, CHANNELS[2].role) == ("code", "")
