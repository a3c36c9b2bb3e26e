"""Check sums put right again after damage, so that it reaches what stands behind them."""

import re
import struct
import zlib

from drivers.framing import MAGIC

_JOURNAL_LINE = re.compile(rb'\{"crc32":"[0-9a-f]{8}","event":(.*)\}')
_TAG = re.compile(rb"[A-Z]{3}[0-9]")
_HEAD, _BLOCK, _PAGE = struct.Struct("<8sII"), struct.Struct("<4sII"), 512


def unchanged(content: bytes) -> bytes:
    """The content as it is."""
    return content


def journal(content: bytes) -> bytes:
    """The lines of a session's journal with the check sums of what they now hold."""
    lines: list[bytes] = []
    for line in content.split(b"\n"):
        match = _JOURNAL_LINE.fullmatch(line)
        if match is not None:
            line = b'{"crc32":"%08x","event":%b}' % (zlib.crc32(match[1]), match[1])
        lines.append(line)
    return b"\n".join(lines)


def blocks(content: bytes) -> bytes:
    """A block file with the check sums of what its header and blocks now hold.

    The header's length is taken from its closing brace, a block's from the tag after it.
    """
    if not content.startswith(MAGIC) or len(content) < _HEAD.size:
        return content
    first = _TAG.search(content, _PAGE)
    begin = first.start() if first else len(content)
    text = content[_HEAD.size : begin].rstrip(b"\0")
    head = _HEAD.pack(MAGIC, len(text), zlib.crc32(text)) + text
    out = [head, bytes(-len(head) % _PAGE)]
    at = begin
    while at + _BLOCK.size <= len(content):
        tag, length, _ = _BLOCK.unpack_from(content, at)
        end = at + _BLOCK.size + length
        following = _TAG.search(content, at + _BLOCK.size)
        if end > len(content) or (end < len(content) and not _TAG.match(content, end)):
            end = following.start() if following else len(content)
        payload = content[at + _BLOCK.size : end]
        size = struct.pack("<I", len(payload))
        out += [tag, size, struct.pack("<I", zlib.crc32(payload, zlib.crc32(tag + size))), payload]
        at = end
    return b"".join(out) + content[at:]
