"""Damage to a file as data: the same edits are drawn by hypothesis, by chance and from coverage.

An edit knows no format. What makes it reach deep into a reader is that it replaces whole words,
numbers and signs by odd ones, and that check sums are put right again afterwards (`repairs`).
"""

import random
import re
from collections.abc import Sequence
from dataclasses import dataclass

KINDS = ("word", "flip", "cut", "insert", "copy", "line", "end")

ODD = (
    b"", b"0", b"-1", b"1", b"2", b"3.5", b"-0.0", b"nan", b"inf", b"-inf", b"null", b"true",
    b"1e999", b"1e-999", b"1e308", b"65536", b"2147483648", b"4294967295", b"9223372036854775807",
    b"-9223372036854775809", b"1" * 400, b"0x1F", b"1_000", b"1,5", b'""', b'"x"', b'"inf"', b"[]",
    b"{}", b"[[]]", b"[1, 2]", b'{"x": 1}', b"[null]", b"'", b'"', b",", b";", b"\t", b"\n", b"\r",
    b"=", b"[", b"]", b"{", b"}", b"#", b"\\", b"\\u0000", b"\x00", b"\xff", b"\xef\xbb\xbf",
    b"\xd0\x9e\xd0\xbb", b"\xce", b"../../x", b"1970-01-01T00:00:00+00:00", b"9999-99-99",
    b"0001-01-01T00:00:00+23:59", b"9999-12-31T23:59:59-23:59", b"x" * 3000, b"[" * 3000,
)  # fmt: skip
_WORD = re.compile(rb"[A-Za-z_]+|[-+]?[\d.]+(?:[eE][-+]?\d+)?|[^\sA-Za-z\d]")


@dataclass(frozen=True, slots=True)
class Edit:
    """One change of a file.

    Parameters
    ----------
    kind : one of `KINDS`
    place : where, 0 to 65535 over the length of the file
    size : how much, 0 to 255
    odd : what instead, place in `ODD`
    """

    kind: str
    place: int
    size: int
    odd: int


def chance(rng: random.Random, most: int = 4) -> list[Edit]:
    """A few edits drawn by chance."""
    return [
        Edit(rng.choice(KINDS), rng.randrange(65536), rng.randrange(256), rng.randrange(len(ODD)))
        for _ in range(rng.randint(1, most))
    ]


def of_bytes(data: bytes) -> list[Edit]:
    """Edits from the bytes that a coverage-guided fuzzer makes up, five an edit."""
    return [
        Edit(
            KINDS[data[at] % len(KINDS)],
            data[at + 1] << 8 | data[at + 2],
            data[at + 3],
            data[at + 4] % len(ODD),
        )
        for at in range(0, len(data) - 4, 5)
    ]


def edited(content: bytes, edits: Sequence[Edit]) -> bytes:
    """The content after the edits, one after the other."""
    for edit in edits:
        content = _one(content, edit)
    return content


def _one(content: bytes, edit: Edit) -> bytes:
    at = edit.place * len(content) >> 16
    odd = ODD[edit.odd]
    match edit.kind:
        case "word":
            found = _WORD.search(content, at)
            start, stop = found.span() if found else (at, at)
            return content[:start] + odd + content[stop:]
        case "flip":
            return content[:at] + bytes([_byte(content, at) ^ (edit.size or 1)]) + content[at + 1 :]
        case "cut":
            return content[:at] + content[at + edit.size :]
        case "insert":
            return content[:at] + odd + content[at:]
        case "copy":
            piece = content[at : at + edit.size]
            return content[:at] + piece + content[at:]
        case "line":
            lines = content.split(b"\n")
            line = lines.pop(edit.place * len(lines) >> 16)
            lines.insert(edit.size * (len(lines) + 1) >> 8, line)
            return b"\n".join(lines if edit.odd % 2 else [*lines, line])
        case _:
            return content[:at]


def _byte(content: bytes, at: int) -> int:
    return content[at] if at < len(content) else 0
