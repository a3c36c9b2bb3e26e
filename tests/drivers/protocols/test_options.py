"""Options of protocols: one set for each decoder."""

import pytest

from drivers.decoders import DECODERS
from drivers.protocols.options import PROTOCOL_OPTIONS, PROTOCOL_PARAMS, Option


def test_every_protocol_has_a_decoder_and_the_other_way_round():
    assert set(PROTOCOL_OPTIONS) == set(DECODERS)
    assert set(PROTOCOL_PARAMS) <= set(DECODERS)


@pytest.mark.parametrize("name", PROTOCOL_OPTIONS)
def test_the_usual_value_is_an_allowed_one(name: str):
    for option in PROTOCOL_OPTIONS[name].values():
        assert option.usual in option.allowed
        assert len(set(option.allowed)) == len(option.allowed)


def test_the_first_allowed_value_is_the_usual_one():
    assert Option((4, 2)).usual == 4
