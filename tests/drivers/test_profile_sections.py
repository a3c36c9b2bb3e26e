"""Mistakes in device files, each told with its place."""

import re

import pytest

from core.errors import FormatError
from drivers.profile import parse_profile
from tests.drivers.device_texts import GOOD, LINES


def changed(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


MISTAKES = [
    ("schema = 1", "schema = 2", 1, "schema 1, not 2"),
    ("schema = 1", "", 0, "schema: is missing"),
    ('kind = "adc"', 'kind = "gyros"', 5, 'did you mean "gyro"'),
    ('layout = "clbacc"', 'layout = "clbac"', 6, 'did you mean "clbacc"'),
    ('name = "Board"', 'name = " "', 4, "must not be empty"),
    ("baud = [115200, 9600]", "baud = []", 9, "at least one"),
    ("baud = [115200, 9600]", "baud = [true]", 9, "whole number"),
    ('format = "7E2"', 'format = "8N"', 10, "8N1"),
    ("settle_ms = 20", "settel_ms = 20", 11, 'did you mean "settle_ms"'),
    ("K = 4", 'K = "4"', 15, "finite number"),
    ('sync = "AA .. 55"', 'sync = "AA 5"', 18, "1 to 8 bytes"),
    ('sync = "AA .. 55"', 'sync = ".. 55"', 18, "must not begin"),
    ("length = 12", "length = 2", 19, "between 4 and"),
    ("length = 12", 'length = { at = 2, type = "u8", min = 9, max = 5 }', 19, "max"),
    ("length = 12", 'length = { at = 2, typ = "u8", min = 9, max = 9 }', 19, "length.type"),
    ('endian = "big"', 'endian = "Big"', 20, 'did you mean "big"'),
    ("nominal_hz = 50", "nominal_hz = -1", 21, "negative"),
    ('alg = "sum8"', 'alg = "crc9"', 22, "is not one of"),
    ('alg = "sum8"', 'alg = "crc16"', 22, "poly: is missing"),
    ('alg = "sum8"', 'alg = "sum16"', 22, "no room for 2 bytes"),
    ("at = -1, from = 3, to = -1", "at = -2, from = 3, to = -1", 22, "cover the checksum itself"),
    ('"sum8", at = -1, from = 3, to = -1', '"sum16w", at = -2, from = 3, to = -2', 22, "even"),
    ("at = -1, from = 3, to = -1", "at = 3, from = 4, to = 12", 49, "not at the end"),
    ('hex = "AA 00 55 01"', 'hex = "AA 00"', 49, "cover no byte"),
    ("to = -1 }", "to = 3 }", 22, "cover no byte"),
    ("to = -1 }", "to = -1, seed = 1 }", 22, "is no key"),
    ('field = "n"', 'field = "m"', 23, "is not one of"),
    ("step = 2", 'step = "fast"', 23, "whole number"),
    ("reject_abs = 5", "reject_abs = nan", 24, "finite"),
    ("hide = true", "hidden = true", 29, "is no key"),
    ('type = "i16"', 'type = "i17"', 33, 'did you mean "i16"'),
    ('scale = "1/K"', 'scale = "1/Q"', 34, "not in [params]"),
    ('scale = "1/K"', "scale = 0", 34, "must not be zero"),
    ('scale = "1/K"', "scale = [1]", 34, "number or an expression"),
    ('roles = ["rate.x", "rate.y"]', 'roles = ["rate.x"]', 37, "1 entries for 2"),
    ('roles = ["rate.x", "rate.y"]', 'roles = ["rate.x", "speed"]', 37, "is no role"),
    ('roles = ["rate.x", "rate.y"]', 'roles = ["rate.x", "acc.x"]', 37, "needs the unit m/s^2"),
    ('names = ["x", "y"]', 'names = ["x", "n"]', 17, 'name "n" twice'),
    ('names = ["x", "y"]', "names = []", 32, "at least one"),
    ('names = ["x", "y"]', 'names = ["x", ""]', 32, "must not be empty"),
    ("at = 9", "at = 12", 40, "end at byte 13"),
    ("bits = [1, 2]", "bits = [2, 9]", 43, "within u8"),
    ("bits = [1, 2]", "bits = [2]", 43, "lowest, highest"),
    ('hex = "AA 00 55 01"', 'hex = "AA 0"', 48, "hexadecimal"),
    ('hex = "AA 00 55 01"', "", 47, "hex or ascii"),
    ('hex = "AA 00 55 01"', 'hex = ""', 47, "at least one byte"),
    ("repeat = 2", "repeat = 0", 50, "between 1 and"),
    ('expect_hex = "AA 01"', 'expect = "("', 53, "regular expression"),
    ("[params]", "[param]", 14, 'did you mean "params"'),
    ("[[field]]", "[field]", 0, ""),
    ("schema = 1", "schema = 1\nfoo = 1", 2, "foo: is no key"),
]


@pytest.mark.parametrize(("old", "new", "line", "words"), MISTAKES)
def test_a_mistake_is_told_with_its_line(old: str, new: str, line: int, words: str):
    with pytest.raises(FormatError) as caught:
        parse_profile(changed(old, new), "board.toml")
    assert caught.value.path == "board.toml"
    assert words in caught.value.why
    if line:
        assert caught.value.line == line, str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('columns = ["a", "b"]', 'columns = ["a", "a"]', "twice"),
        ('columns = ["a", "b"]', 'columns = ["a", "b"]\nscale = [1]', "2 numbers"),
        ('columns = ["a", "b"]', 'columns = ["a", "b"]\nscale = [1, 0]', "zero"),
        ('columns = ["a", "b"]', 'columns = ["a", "b"]\nscale = 3', "must be a list"),
        ('columns = ["a", "b"]', 'style = "json"', "must be given"),
        ('columns = ["a", "b"]', 'delimiter = ","\ndecimal = ","', "differ"),
        ("[line]", "[lines]", 'did you mean "line"'),
        ('[line]\ncolumns = ["a", "b"]', "", "exactly one of"),
        ("[line]", "[protocol]\nname = 'stim30'\n[line]", "exactly one of"),
        ('[line]\ncolumns = ["a", "b"]', "[protocol]\nname = 'stim30'", 'did you mean "stim300"'),
        ('[line]\ncolumns = ["a", "b"]', "[protocol]\nname = 'stim300'\nrange = 1", "is no key"),
        (
            '[line]\ncolumns = ["a", "b"]',
            "[protocol]\nname = 'stim300'\nacc_range_g = 7",
            "not one of 5 (0x05), 10",
        ),
        ('[line]\ncolumns = ["a", "b"]', "[protocol]\nname = 'inertial_labs'", "KG"),
        ("schema = 1", "schema = 1\n[[field]]", "field"),
    ],
)  # fmt: skip
def test_mistakes_in_lines_and_protocols(old: str, new: str, words: str):
    with pytest.raises(FormatError, match=re.escape(words)):
        parse_profile(LINES.replace(old, new, 1), "x.toml")


def test_a_tail_needs_a_checksum_and_must_not_look_like_a_sync():
    for checksum, tail, words in (
        ('{ alg = "none" }', "0D 0A", "needs a checksum"),
        ('{ alg = "sum8", at = -1, from = 3, to = -1 }', "AA", "first of sync"),
    ):
        text = re.sub(r"checksum = .*", f'checksum = {checksum}\ntail = "{tail}"', GOOD)
        with pytest.raises(FormatError, match=words):
            parse_profile(text, "x")
