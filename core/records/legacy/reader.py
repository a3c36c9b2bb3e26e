"""A file on disk -> `LegacyFile`."""

import hashlib
from pathlib import Path

import numpy as np

from core.arrays import frozen, frozen_int
from core.errors import FormatError
from core.records.legacy.file import LegacyFile
from core.records.legacy.recognise import recognise
from core.records.legacy.rows import check_decimal_marks, text_rows
from core.records.text import decode, lines_of, read_bytes

_MAX_BYTES = 16 * 2**20


def read_legacy(path: Path) -> LegacyFile:
    """Read a file of any layout in `LEGACY_FORMATS`.

    Raises
    ------
    FormatError
        It is none of them, is damaged, or could be more than one; with line and column.
    """
    content = read_bytes(path, max_bytes=_MAX_BYTES)
    return parse_legacy(decode(content, path), str(path), hashlib.sha256(content).hexdigest())


def parse_legacy(text: str, path: str, sha256: str = "") -> LegacyFile:
    """Read the text of a legacy file; `path` stands in messages and helps to recognise it.

    Raises
    ------
    FormatError
        As `read_legacy`.
    """
    rows = text_rows(lines_of(text))
    if not rows:
        raise FormatError(path, "is empty: no rows of measurements")
    layout = recognise(path, rows)
    numbers = len(layout.columns)
    check_decimal_marks(path, rows, numbers)
    return LegacyFile(
        path=path,
        layout=layout,
        devices=tuple(row.name(numbers) for row in rows),
        values=frozen(np.array([row.tail[-numbers:] for row in rows])),
        lines=frozen_int([row.line for row in rows]),
        sha256=sha256,
    )
