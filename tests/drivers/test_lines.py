"""Cutting into lines, and the checksums of lines."""

import pytest

from drivers.events import Garbage
from drivers.lines import LineSplitter, checked, crc16_sum, xor_sum


def cut(
    pieces: list[bytes], end: str = "\n", *, keep_first: bool = True
) -> tuple[list[bytes], int]:
    splitter = LineSplitter(end, keep_first=keep_first)
    lines: list[bytes] = []
    garbage = 0
    for piece in pieces:
        lines += splitter.split(piece)
        for event in splitter.wasted():
            assert isinstance(event, Garbage)
            assert 0 < len(event.sample) <= 16
            garbage += event.count
        assert splitter.carried <= 4096
    lines += splitter.rest()
    return lines, garbage


def bytewise(data: bytes) -> list[bytes]:
    return [data[n : n + 1] for n in range(len(data))]


def test_lines_without_their_ends():
    data = b"one\ntwo\r\n\nthree"
    assert cut([data]) == ([b"one", b"two\r", b"", b"three"], 0)
    assert cut(bytewise(data)) == cut([data])


def test_the_first_line_may_be_cut_off():
    data = b"6\t312\r\n1\t2\r\n"
    assert cut([data], keep_first=False) == ([b"1\t2\r"], 7)
    assert cut(bytewise(data), keep_first=False) == cut([data], keep_first=False)


def test_lines_that_end_with_a_carriage_return():
    assert cut([b"#a,1\r#b,2\r"], "\r") == ([b"#a,1", b"#b,2"], 0)


@pytest.mark.parametrize("length", [4096, 4097, 20000])
def test_endless_lines_are_garbage_and_never_kept(length: int):
    data = b"x" * length + b"\nnext\n"
    lines, garbage = cut([data])
    assert lines[-1] == b"next"
    assert garbage == (0 if length <= 4096 else length + 1)
    assert cut(bytewise(data)) == (lines, garbage)
    assert cut([data[n : n + 1000] for n in range(0, len(data), 1000)]) == (lines, garbage)


def test_checksums_of_lines():
    assert checked("$VNRRG,01*72") == "$VNRRG,01"
    assert checked("$VNRRG,01*73") is None
    assert checked("$VNRRG,01") is None
    assert checked("$VNRRG,01*7") is None
    assert checked("$GPGGA,x*") is None
    body = "VNRRG,01"
    assert checked(f"${body}*{crc16_sum(body):04x}") == f"${body}"
    assert xor_sum("123456789") == 0x31
    assert crc16_sum("123456789") == 0x31C3
