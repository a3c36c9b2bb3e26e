"""Text lines in a stream of bytes, and the checksums that lines carry."""

import re

from drivers.events import Event, Garbage

_LONGEST = 4096
_SAMPLE = 16
_MARKED = re.compile(r"\$?([^*]*)\*([0-9A-Fa-f]{4}|[0-9A-Fa-f]{2})\s*")


def xor_sum(text: str) -> int:
    """Return the exclusive-or of the characters, as NMEA has it."""
    value = 0
    for byte in text.encode("latin-1", errors="replace"):
        value ^= byte
    return value


def crc16_sum(text: str) -> int:
    """Return the CRC-16/XMODEM of the characters, which VectorNav writes with four digits."""
    value = 0
    for byte in text.encode("latin-1", errors="replace"):
        value ^= byte << 8
        for _ in range(8):
            value = (value << 1) ^ 0x1021 if value & 0x8000 else value << 1
        value &= 0xFFFF
    return value


def checked(line: str) -> str | None:
    """Return a line without its ``*HH`` or ``*HHHH``; None if that is missing or wrong."""
    found = _MARKED.fullmatch(line)
    if found is None:
        return None
    body, digits = found[1], found[2]
    value = xor_sum(body) if len(digits) == 2 else crc16_sum(body)
    return line[: found.end(1)] if value == int(digits, 16) else None


class LineSplitter:
    """Cuts a stream into lines.

    Parameters
    ----------
    end : text that ends a line; its last character decides
    keep_first : whether the first line counts although it may be cut off
    """

    def __init__(self, end: str, *, keep_first: bool) -> None:
        self._end = end.encode("ascii")[-1:]
        self._carry = b""
        self._skipping = not keep_first
        self._garbage = 0
        self._sample = b""

    @property
    def carried(self) -> int:
        """Bytes that wait for the end of their line."""
        return len(self._carry)

    def split(self, data: bytes) -> list[bytes]:
        """Return the lines that are complete now, without their ends."""
        pieces = (self._carry + data).split(self._end)
        self._carry = pieces.pop()
        lines: list[bytes] = []
        for piece in pieces:
            if self._skipping or len(piece) > _LONGEST:
                self._waste(piece + self._end)
            else:
                lines.append(piece)
            self._skipping = False
        if self._skipping or len(self._carry) > _LONGEST:
            self._waste(self._carry)
            self._skipping, self._carry = True, b""
        return lines

    def rest(self) -> list[bytes]:
        """Return what stands behind the last end when nothing more will come."""
        last, self._carry = self._carry, b""
        return [last] if last else []

    def wasted(self) -> list[Event]:
        """Return, once, the bytes that belong to no line."""
        if not self._garbage:
            return []
        count, self._garbage = self._garbage, 0
        return [Garbage(count, self._sample)]

    def _waste(self, piece: bytes) -> None:
        if not self._garbage:
            self._sample = piece[:_SAMPLE]
        self._garbage += len(piece)
