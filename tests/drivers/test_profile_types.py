"""What sections of a device file hold."""

import pytest

from core.samples.block import Channel
from drivers.profile import parse_profile
from drivers.profile_types import TYPES, FieldSpec, FrameSpec
from tests.drivers.device_texts import GOOD


@pytest.mark.parametrize("kind", TYPES)
def test_a_field_ends_behind_its_last_value(kind: str):
    spec = FieldSpec((Channel("a"), Channel("b"), Channel("c")), kind, 5)
    assert spec.end == 5 + 3 * int(kind[1:]) // 8


def test_the_shortest_frame():
    fixed = parse_profile(GOOD, "x").stream
    told = parse_profile(
        GOOD.replace("length = 12", 'length = { at = 3, type = "u8", min = 11, max = 40 }'), "x"
    ).stream
    assert isinstance(fixed, FrameSpec)
    assert isinstance(told, FrameSpec)
    assert (fixed.shortest, told.shortest) == (12, 11)
