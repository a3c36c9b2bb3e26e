"""Text as lab computers write it: UTF-8 with or without BOM, CP1251, any line end."""

import re
from pathlib import Path

from core.errors import FormatError

MAX_BYTES = 256 * 2**20
"""Larger files are raw records, never tables of means."""

_LINE_END = re.compile(r"\r\n|\n|\r")


def read_bytes(path: Path, *, max_bytes: int = MAX_BYTES) -> bytes:
    """Read a file whole.

    Raises
    ------
    FormatError
        It cannot be opened, or is too large to be what was asked for.
    """
    try:
        with path.open("rb") as file:
            content = file.read(max_bytes + 1)
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        why = getattr(error, "strerror", None) or str(error)
        raise FormatError(path, f"cannot be read: {why}") from error
    if len(content) > max_bytes:
        raise FormatError(path, f"is larger than {max_bytes // 2**20} MB: no table of means")
    return content


def decode(content: bytes, name: Path | str) -> str:
    """Decode UTF-8 (with or without BOM) or, failing that, CP1251.

    Raises
    ------
    FormatError
        It is neither; the message tells a binary or UTF-16 file.
    """
    if b"\0" in content:
        raise FormatError(
            name, "holds zero bytes: a binary or UTF-16 file; save it as UTF-8 text and load again"
        )
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        pass
    try:
        return content.decode("cp1251")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise FormatError(name, "is neither UTF-8 nor CP1251 text", line=line) from error


def lines_of(text: str) -> list[str]:
    """The lines without their ends; only CR and LF end a line."""
    lines = _LINE_END.split(text)
    if lines and not lines[-1]:
        lines.pop()
    return lines
