"""Columns that appear one after another."""

from core.samples.block import Channel
from drivers.columns import Columns

A, B, C = Channel("a", "V"), Channel("b", "V"), Channel("c", "V")


def test_what_was_expected_holds_until_the_first_frame():
    columns = Columns((A, B))
    assert columns.channels == (A, B)
    columns.take(())
    assert columns.channels == (A, B)
    columns.take((C, A))
    assert columns.channels == (C, A)


def test_what_was_expected_may_come():
    expected = (A, B)
    columns = Columns(expected)
    columns.take(expected)
    assert columns.places((B,)).tolist() == [1]
    assert not columns.lack(expected)


def test_new_channels_come_behind_the_known_ones():
    columns = Columns()
    columns.take((A, B))
    assert not columns.lack((B,))
    assert columns.lack((B, C))
    columns.take((C, A))
    assert columns.channels == (A, B, C)
    assert columns.places((C, A)).tolist() == [2, 0]


def test_a_channel_of_another_unit_replaces_the_one_of_its_name():
    columns = Columns()
    columns.take((A, B))
    columns.take((Channel("a", "deg"),))
    assert columns.channels == (Channel("a", "deg"), B)
    assert not columns.lack((A,))
