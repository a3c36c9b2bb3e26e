"""Decoder of text lines.

A line is a sample if the profile's pattern fits all of it: prefix, every number, suffix, checksum.
Anything else is a `Message` of kind ``"text"``, never an error and never a zero. The first line
after opening is usually cut off and is dropped, unless a checksum proves it whole.

Where the profile names no columns, five lines in a row that hold the same number of values settle
the columns and, for ``delimiter = "auto"``, the delimiter and the decimal mark.
"""

import json
import math
import re
from collections.abc import Callable, Sequence
from typing import cast

import numpy as np

from core.arrays import FloatArray, IntArray
from core.samples.block import Channel, SampleBlock
from drivers.counter import SampleCounter
from drivers.events import BadChecksum, Event, Message
from drivers.lines import LineSplitter, checked
from drivers.profile_types import LineSpec

_SETTLING = 5
_BETWEEN = {
    ",": r"\s*,\s*",
    ";": r"\s*;\s*",
    "tab": r" *\t *",
    "ws": r"\s+",
    "auto": r"(?:\s*[,;]\s*|\s+)",
}
_GUESSES = (
    (";", ","),
    (";", "."),
    ("tab", ","),
    ("tab", "."),
    (",", "."),
    ("ws", "."),
    ("ws", ","),
)
"""Delimiter and decimal mark of unnamed columns, the safer guess first."""

Reading = list[float] | None
Read = Callable[[str], Reading]
Form = tuple[str, str, int]


def text_message(line: bytes) -> Message:
    """Return a line that is no sample."""
    return Message("text", line, {"text": line.decode("latin-1").strip()})


def _number(decimal: str) -> str:
    mark = re.escape(decimal)
    return rf"([+-]?(?:\d+(?:{mark}\d*)?|{mark}\d+)(?:[eE][+-]?\d+)?)"


def _pattern_reader(spec: LineSpec, numbers: str, decimal: str) -> Read:
    prefix, suffix = re.escape(spec.prefix), re.escape(spec.suffix)
    pattern = re.compile(rf"\s*{prefix}\s*{numbers}\s*{suffix}\s*", re.ASCII)

    def read(line: str) -> Reading:
        found = pattern.fullmatch(line)
        if found is None:
            return None
        values = [float(word.replace(decimal, ".")) for word in found.groups()]
        return values if all(map(math.isfinite, values)) else None

    return read


def _values_reader(spec: LineSpec, form: Form) -> Read:
    delimiter, decimal, count = form
    return _pattern_reader(spec, _BETWEEN[delimiter].join([_number(decimal)] * count), decimal)


def _labels_reader(spec: LineSpec) -> Read:
    number = _number(spec.decimal)
    words = [rf"{re.escape(channel.name)}\s*:\s*{number}" for channel in spec.channels]
    return _pattern_reader(spec, _BETWEEN[spec.delimiter].join(words), spec.decimal)


def _json_reader(spec: LineSpec) -> Read:
    names = [channel.name for channel in spec.channels]

    def read(line: str) -> Reading:
        try:
            entry: object = json.loads(line)
        except (ValueError, RecursionError):
            return None
        if not isinstance(entry, dict):
            return None
        found = [cast("dict[str, object]", entry).get(name) for name in names]
        numbers = [v for v in found if isinstance(v, int | float) and not isinstance(v, bool)]
        if len(numbers) < len(names) or not all(abs(v) < 1e300 for v in numbers):
            return None
        return [float(v) for v in numbers]

    return read


def _form(spec: LineSpec, line: str) -> Form | None:
    """Return the form by which a line of unnamed columns can be read."""
    body = line.strip().removeprefix(spec.prefix).removesuffix(spec.suffix).strip()
    given = ((spec.delimiter, spec.decimal),)
    for delimiter, decimal in _GUESSES if spec.delimiter == "auto" else given:
        form = delimiter, decimal, len(re.split(_BETWEEN[delimiter], body))
        if _values_reader(spec, form)(line) is not None:
            return form
    return None


class LineDecoder:
    """Bytes to samples by a `LineSpec`.

    Parameters
    ----------
    spec : the lines
    nominal_hz : declared samples per second, 0 if unknown
    """

    def __init__(self, spec: LineSpec, nominal_hz: float) -> None:
        self._spec = spec
        self._rate = nominal_hz
        self._channels = spec.channels
        self._splitter = LineSplitter(spec.end, keep_first=spec.checksum)
        self._scales, self._offsets = np.array(spec.scales), np.array(spec.offsets)
        counter = spec.counter
        self._counter = SampleCounter(counter.bits, counter.step) if counter else SampleCounter()
        self._read: Read | None = None
        self._form: Form | None = None
        self._pending: list[bytes] = []
        self._lost = 0
        if spec.style == "json":
            self._read = _json_reader(spec)
        elif spec.style == "labels":
            self._read = _labels_reader(spec)
        elif spec.channels:
            self._read = _values_reader(spec, (spec.delimiter, spec.decimal, len(spec.channels)))

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The columns; empty until unnamed ones have settled."""
        return self._channels

    @property
    def rate(self) -> float:
        """Declared samples per second."""
        return self._rate

    @property
    def carried(self) -> int:
        """Bytes that wait for more."""
        return self._splitter.carried

    def feed(self, data: bytes) -> list[Event]:
        """Return what these bytes complete; any bytes are allowed."""
        return self._convert(self._splitter.split(data))

    def flush(self) -> list[Event]:
        """Return what is left when nothing more will come."""
        events = self._convert(self._splitter.rest())
        events.extend(map(text_message, self._pending))
        self._pending = []
        return events

    def _convert(self, lines: Sequence[bytes]) -> list[Event]:
        events = self._splitter.wasted()
        rows: list[list[float]] = []
        losses: list[int] = []
        for raw in lines:
            for values in self._line(raw, events):
                rows.append(values)
                losses.append(self._lost)
                self._lost = 0
        if rows:
            self._emit(np.array(rows), np.array(losses), events)
        return events

    def _line(self, raw: bytes, events: list[Event]) -> list[list[float]]:
        """Return the samples that a line completes: one, none, or those that settled all."""
        line = raw.decode("latin-1")
        if not line.strip():
            return []
        if self._spec.checksum:
            body = checked(line)
            if body is None:
                self._refuse(raw, events)
                return []
            line = body
        if self._read is None:
            return self._settle(raw, line, events)
        values = self._read(line)
        if values is not None:
            return [values]
        if not self._spec.checksum and self._resembles(line):
            self._lost += 1
        events.append(text_message(raw))
        return []

    def _refuse(self, raw: bytes, events: list[Event]) -> None:
        """Count a line whose checksum is wrong, or pass on one that should have none."""
        if self._spec.prefix.encode("latin-1") in raw:
            self._lost += 1
            events.append(BadChecksum(1))
        else:
            events.append(text_message(raw))

    def _resembles(self, line: str) -> bool:
        """Return whether a line that cannot be read was probably a sample."""
        if self._spec.prefix:
            return line.lstrip().startswith(self._spec.prefix)
        delimiter = self._form[0] if self._form else self._spec.delimiter
        words = re.split(_BETWEEN[delimiter], line.strip())
        return len(words) > 1 and len(words) == len(self._channels)

    def _settle(self, raw: bytes, line: str, events: list[Event]) -> list[list[float]]:
        form = _form(self._spec, line)
        if form is None or form != self._form:
            events.extend(map(text_message, self._pending))
            self._pending, self._form = [], form
        if form is None:
            events.append(text_message(raw))
            return []
        self._pending.append(raw)
        if len(self._pending) < _SETTLING:
            return []
        read = self._read = _values_reader(self._spec, form)
        count = form[2]
        self._channels = tuple(Channel(f"ch{n}", "") for n in range(1, count + 1))
        self._scales, self._offsets = np.ones(count), np.zeros(count)
        bodies = (pending.decode("latin-1") for pending in self._pending)
        texts = [checked(body) if self._spec.checksum else body for body in bodies]
        self._pending = []
        readings = [read(text) for text in texts if text is not None]
        return [values for values in readings if values is not None]

    def _emit(self, numbers: FloatArray, losses: IntArray, events: list[Event]) -> None:
        counts = None
        if self._spec.counter is not None:
            names = [channel.name for channel in self._channels]
            column = numbers[:, names.index(self._spec.counter.field)]
            counts = (np.rint(column) % 2.0**self._spec.counter.bits).astype(np.int64)
        data = numbers * self._scales + self._offsets
        index, said = self._counter.number(counts, losses)
        events.extend(event for _, event in said)
        data.flags.writeable = index.flags.writeable = False
        events.append(SampleBlock(self._channels, index, data, self._rate))
