"""A proposed description of text lines."""

import json
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import cast

import numpy as np

from core.samples.block import Channel, SampleBlock
from drivers.line import LineDecoder
from drivers.lines import checked
from drivers.profile_types import CounterSpec, LineSpec
from drivers.teach.guesses import counted

_PRINTABLE = frozenset(range(32, 127)) | {9, 10, 13}
_TEXT_SHARE = 0.97
_FEWEST = 5
_MOST = 400
_AGREE = 0.6
_FORMS = (
    (";", ","), (";", "."), ("tab", ","), ("tab", "."), (",", "."), ("ws", "."), ("ws", ","),
)  # fmt: skip
_SPLIT = {",": r",", ";": r";", "tab": r"\t", "ws": r"\s+"}
_NUMBER = r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?"
_LABEL = re.compile(rf"([A-Za-z_][\w .\[\]/-]*?)\s*:\s*({_NUMBER})")
_PREFIX = re.compile(r"[^\d+\-.,;]*(?:[,;](?=.))?")
_COUNTER_BITS = 32


@dataclass(frozen=True, slots=True)
class LineProposal:
    """Lines as they were found.

    Parameters
    ----------
    spec : the description
    share : of the whole lines that it reads, 0 to 1
    lines : how many it reads
    """

    spec: LineSpec
    share: float
    lines: int


def looks_like_text(data: bytes) -> bool:
    """Return whether bytes are printable and come in lines."""
    if len(data) < 2 or not any(end in data for end in (b"\n", b"\r")):
        return False
    return sum(byte in _PRINTABLE for byte in data) >= _TEXT_SHARE * len(data)


def propose_lines(data: bytes) -> LineProposal | None:
    """Return the likeliest reading of text lines, or None if fewer than five agree."""
    end = "\n" if b"\n" in data else "\r"
    whole = data.split(end.encode())[1:-1][-_MOST:]
    lines = [line.decode("latin-1").strip() for line in whole]
    lines = [line for line in lines if line]
    if len(lines) < _FEWEST:
        return None
    whole_ones = [checked(line) for line in lines]
    marked = sum(body is not None for body in whole_ones) >= _AGREE * len(lines)
    texts = [body for body in whole_ones if body is not None] if marked else lines
    suffix = _suffix(texts)
    bodies = [text.removesuffix(suffix).rstrip() for text in texts]
    # A heading may be the very first line.
    first = data.split(end.encode(), 1)[0].decode("latin-1").strip()
    forms = [*_json(texts, end), *_labels(bodies, end), *_values(bodies, end, (first, *lines))]
    specs = [form if form.style == "json" else replace(form, suffix=suffix) for form in forms]
    best: LineProposal | None = None
    for spec in specs:
        tried = replace(spec, checksum=marked)
        count = _read(whole, tried)[0]
        if count >= _FEWEST and (best is None or count > best.lines):
            best = LineProposal(tried, count / len(lines), count)
    return None if best is None else replace(best, spec=_finished(best.spec, whole, texts))


def _spec(end: str, names: Sequence[str], **values: object) -> LineSpec:
    plain = LineSpec(
        "", "", "auto", ".", end, "values", tuple(Channel(name, "code") for name in names),
        (1.0,) * len(names), (0.0,) * len(names), 6, False, None,
    )  # fmt: skip
    return replace(plain, **values)  # pyright: ignore[reportArgumentType]


def _read(whole: Sequence[bytes], spec: LineSpec) -> tuple[int, np.ndarray]:
    """Return how many lines a description reads, and their numbers."""
    decoder = LineDecoder(spec, 0.0)
    # The first line of a stream is dropped as cut off: one more goes before.
    end = spec.end.encode()
    events = decoder.feed(end + end.join(whole) + end)
    blocks = [event.data for event in events if isinstance(event, SampleBlock)]
    if not blocks:
        return 0, np.empty((0, len(spec.channels)))
    data = np.concatenate(blocks)
    return len(data), data


def _suffix(texts: Sequence[str]) -> str:
    """Return the words that most lines end with behind their last number; empty for none."""
    ends = Counter(_common_end(one, other) for one, other in pairwise(texts))
    # Neighbours may share the last digits of a number too.
    words = Counter(end.lstrip("0123456789.,+- \t") for end in ends.elements())
    word, count = words.most_common(1)[0] if words else ("", 0)
    return word if any(map(str.isalpha, word)) and count >= _AGREE * len(texts) / 2 else ""


def _common_end(one: str, other: str) -> str:
    count = 0
    for left, right in zip(reversed(one), reversed(other), strict=False):
        if left != right:
            break
        count += 1
    return one[len(one) - count :]


def _json(lines: Sequence[str], end: str) -> list[LineSpec]:
    names: Counter[str] = Counter()
    for line in lines:
        if not line.startswith("{"):
            continue
        try:
            entry: object = json.loads(line)
        except (ValueError, RecursionError):
            continue
        if isinstance(entry, dict):
            pairs = cast("dict[str, object]", entry).items()
            names.update(
                key
                for key, value in pairs
                if isinstance(value, int | float) and not isinstance(value, bool)
            )
    common = [name for name, count in names.items() if count >= _AGREE * len(lines)]
    return [_spec(end, common, style="json")] if common else []


def _labels(lines: Sequence[str], end: str) -> list[LineSpec]:
    rows = Counter(tuple(name.strip() for name, _ in _LABEL.findall(line)) for line in lines)
    names, count = rows.most_common(1)[0]
    if not names or count < _AGREE * len(lines) or len(set(names)) < len(names):
        return []
    return [
        _spec(end, names, style="labels", delimiter=delimiter, decimal=decimal)
        for delimiter, decimal in (("auto", "."), (";", ","), ("ws", ","))
    ]


def _values(lines: Sequence[str], end: str, heads: Sequence[str]) -> list[LineSpec]:
    found = Counter(match[0] for line in lines if (match := _PREFIX.match(line)))
    prefix, count = found.most_common(1)[0]
    prefix = prefix.rstrip(" \t") if count >= _AGREE * len(lines) else ""
    specs: list[LineSpec] = []
    for delimiter, decimal in _FORMS:
        bodies = [line.removeprefix(prefix).strip() for line in lines]
        cells = Counter(len(re.split(_SPLIT[delimiter], body)) for body in bodies)
        columns = cells.most_common(1)[0][0]
        names = _header(heads, delimiter, columns) or [f"ch{n}" for n in range(1, columns + 1)]
        specs.append(_spec(end, names, prefix=prefix, delimiter=delimiter, decimal=decimal))
    return specs


def _header(lines: Sequence[str], delimiter: str, columns: int) -> list[str]:
    """Return the names of a line of as many words, none of them a number; empty if none is."""
    for line in lines:
        words = [word.strip() for word in re.split(_SPLIT[delimiter], line)]
        plain = all(word and not re.fullmatch(_NUMBER, word) for word in words)
        if len(words) == columns and plain and len(set(words)) == columns:
            return words
    return []


def _finished(spec: LineSpec, whole: Sequence[bytes], texts: Sequence[str]) -> LineSpec:
    """Return the description with the decimal places that are printed, and a counting column."""
    places = [len(part) for text in texts for part in re.findall(rf"\d\{spec.decimal}(\d+)", text)]
    digits = min(max(places, default=0), 12)
    _, numbers = _read(whole, spec)
    channels = list(spec.channels)
    counter: CounterSpec | None = None
    for place, column in enumerate(numbers.T):
        if np.any(column != np.rint(column)) or np.any(np.abs(column) > 2**31):
            continue
        step, share = counted(column.astype(np.int64), _COUNTER_BITS)
        if step and share > 0.9:
            counter = CounterSpec(channels[place].name, _COUNTER_BITS, step)
            channels[place] = replace(channels[place], role="counter")
            break
    return replace(spec, channels=tuple(channels), digits=digits, counter=counter)
