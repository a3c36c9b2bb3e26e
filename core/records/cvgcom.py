"""CVGCom's own text file: a head, then one row a sample without a time column.

``FileVersion``, ``SamplingTime[seconds]``, ``ScaleFactor``, ``CanalCount`` with an equals sign,
then ``CanalNames`` and a blank line; values as ``%1.9f``, separated by tabs; row i is at i sampling
times. The layout is that of CVGCom's published sources; the practicum shows its values in
fig. 5.5. A row of ``nan`` stands for samples that never came.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError, Note, Severity
from core.records.cvgcom_name import CvgcomName
from core.records.decimals import read_decimals
from core.records.text import decode, read_bytes
from core.samples.block import Channel

MAX_BYTES = 4 << 30
VERSION_KEY, TIME_KEY = "FileVersion", "SamplingTime[seconds]"
SCALE_KEY, COUNT_KEY, NAMES_KEY = "ScaleFactor", "CanalCount", "CanalNames"
DECIMALS = 9

KNOWN = {
    "GyroOut": ("V", "rate.z"),
    "Temperature": ("degC", "temp"),
    "AntiNodePeriod": ("us", ""),
    "ExcitationDelay": ("us", ""),
    "AntiNodeAmplitude": ("V", ""),
    "ExcitationAmpl": ("V", ""),
    "QuadratureAmpl": ("V", ""),
    "QuadratureError": ("V", ""),
    "CoriolisError": ("V", ""),
    "NodeAmplitude": ("V", ""),
    "GyroOut_RAW": ("V", ""),
}
"""Unit and role of CVGCom's channels, which its files do not tell."""

_HEAD_BYTES = 1 << 16
_NAMES = re.compile(rb"(?m)^[ \t]*" + NAMES_KEY.encode() + rb"\b[ \t]*=?[ \t]*([^\r\n]*)(\r?\n|\Z)")


@dataclass(frozen=True, slots=True)
class CvgcomHead:
    """What stands above the rows.

    Parameters
    ----------
    sampling_s : time from row to row, s
    scale_factor : V per deg/s, as the operator gave it
    channels : (c,) names, with the units that CVGCom's channels are known to have
    version : of the layout
    """

    sampling_s: float
    scale_factor: float
    channels: tuple[Channel, ...]
    version: int = 1

    @property
    def rate(self) -> float:
        """Rows per second."""
        return 1.0 / self.sampling_s


@dataclass(frozen=True, slots=True, eq=False)
class CvgcomFile:
    """One file of CVGCom.

    Parameters
    ----------
    path : where it was read
    head : what stands above the rows
    data : (n, c) read-only; NaN in rows whose samples never came
    name : what the file name tells; None where it is no name of CVGCom's
    notes : doubts, e.g. a last row that was cut
    """

    path: Path
    head: CvgcomHead
    data: FloatArray
    name: CvgcomName | None
    notes: tuple[Note, ...]

    def numbers(self) -> IntArray:
        """Numbers of the rows, (n,)."""
        return frozen_int(np.arange(len(self.data)))


def is_cvgcom(path: Path) -> bool:
    """Whether a file begins as CVGCom's do; what cannot be read is none."""
    try:
        with path.open("rb") as file:
            return file.read(64).lstrip(b"\xef\xbb\xbf \t\r\n").startswith(VERSION_KEY.encode())
    except (OSError, ValueError):
        return False


def read_cvgcom(path: Path) -> CvgcomFile:
    """Read a file of CVGCom.

    Raises
    ------
    FormatError
        It is none or is damaged; with the line.
    """
    content = read_bytes(path, max_bytes=MAX_BYTES)
    head, begin = _read_head(content, path)
    line = content.count(b"\n", 0, begin) + 1
    body = content[begin:]
    if b"," in body:
        body = body.replace(b",", b".")  # written under a locale with decimal commas
    body, notes = _whole_rows(body, len(head.channels))
    values, per_line = read_decimals(body, path, line)
    wrong = np.flatnonzero((per_line != len(head.channels)) & (per_line != 0))
    if wrong.size:
        at = int(wrong[0])
        raise FormatError(
            path,
            f"{per_line[at]} values; the head names {len(head.channels)} channels",
            line=line + at,
        )
    data = frozen(values.reshape(-1, len(head.channels)))
    if not len(data):
        raise FormatError(path, "holds no rows")
    return CvgcomFile(path, head, data, CvgcomName.parse(path.name), tuple(notes))


def _read_head(content: bytes, path: Path) -> tuple[CvgcomHead, int]:
    """The head, and the byte at which the rows begin."""
    names = _NAMES.search(content, 0, _HEAD_BYTES)
    if names is None:
        raise FormatError(path, f"no file of CVGCom: its head has no line {NAMES_KEY}")
    lines = decode(content[: names.start()], path).splitlines()
    fields: dict[str, tuple[str, int]] = {}
    for number, text in enumerate(lines, 1):
        key, _, value = text.partition("=")
        if key.strip():
            fields[key.strip()] = (value.strip().replace(",", "."), number)
    where = len(lines) + 1
    channels = tuple(channel_of(name) for name in decode(names[1], path).split())
    count = _number(fields, COUNT_KEY, path)
    if not channels or count != len(channels):
        raise FormatError(
            path, f"{NAMES_KEY} has {len(channels)} names, {COUNT_KEY} is {count:g}", line=where
        )
    sampling = _number(fields, TIME_KEY, path)
    if not 0.0 < sampling < np.inf:
        raise FormatError(
            path, f"{TIME_KEY} is {sampling:g}; must be above zero", line=fields[TIME_KEY][1]
        )
    scale = _number(fields, SCALE_KEY, path)
    version = int(_number(fields, VERSION_KEY, path))
    return CvgcomHead(sampling, scale, channels, version), names.end()


def _number(fields: dict[str, tuple[str, int]], key: str, path: Path) -> float:
    if key not in fields:
        raise FormatError(path, f"the head has no line {key}")
    text, line = fields[key]
    try:
        return float(text)
    except ValueError:
        raise FormatError(path, f"{key} = {text!r} is no number", line=line) from None


def _whole_rows(body: bytes, columns: int) -> tuple[bytes, list[Note]]:
    """The body without a last row that was cut when the program ended."""
    last = body[body.rfind(b"\n") + 1 :]
    cells = last.split()
    # CVGCom sets the line end before a row, so that a whole last row has none behind it.
    if not cells or (len(cells) >= columns and _is_whole(cells[-1])):
        return body, []
    text = "The last row is incomplete, as after a power cut, and is left out."
    return body[: -len(last)], [Note(Severity.WARNING, "cut_row", text)]


def _is_whole(cell: bytes) -> bool:
    return cell == b"nan" or len(cell.partition(b".")[2]) >= DECIMALS


def channel_of(name: str) -> Channel:
    """A channel by the name that CVGCom gives it."""
    unit, role = KNOWN.get(name, ("", ""))
    return Channel(name, unit, role)
