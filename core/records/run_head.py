"""The head lines of a run file: ``# key = value`` with TOML values."""

import json
import math
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from typing import cast

from core.errors import FormatError, Note, Severity
from core.records.text import lines_of
from core.samples.run import Conditions

VERSION = 1
VERSION_KEY = "calrig-run"
CONDITIONS = tuple(item.name for item in fields(Conditions))
KNOWN = (
    VERSION_KEY,
    *("test", "sensor", "axis", "axes", "device", "output_unit", "channels", "notes"),
    *CONDITIONS,
)
"""Keys that become parts of a run; all others are kept in its `meta`."""

Scalar = str | float | bool


class TomlText(str):
    """TOML that is no text, number or flag (a list, a date): kept and written back as it came."""


@dataclass(frozen=True, slots=True)
class Head:
    """Keys and values of the head lines.

    Parameters
    ----------
    path : the file, for messages
    values : by key
    """

    path: str
    values: Mapping[str, Scalar]

    def text(self, key: str, default: str) -> str:
        """A text."""
        value = self.values.get(key, default)
        if not isinstance(value, str) or isinstance(value, TomlText):
            raise FormatError(self.path, f"{key} = {value!r}; expected a text")
        return value

    def choice(self, key: str, choices: tuple[str, ...]) -> str:
        """One of several texts."""
        value = self.values.get(key)
        if value not in choices:
            raise FormatError(self.path, f"{key} = {value!r}; expected one of {', '.join(choices)}")
        return str(value)

    def number(self, key: str) -> float:
        """A number, NaN where there is none."""
        value = self.values.get(key, math.nan)
        if isinstance(value, bool | str):
            raise FormatError(self.path, f"{key} = {value!r}; expected a number")
        try:
            return float(value)
        except OverflowError as error:
            raise FormatError(self.path, f"{key} is too large") from error

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts, empty where there is none."""
        items = self._list(key)
        if not all(isinstance(item, str) for item in items):
            raise FormatError(self.path, f"{key} = {self.values[key]!r}; expected a list of texts")
        return tuple(cast(list[str], items))

    def notes(self) -> tuple[Note, ...]:
        """The notes of the run."""
        found: list[Note] = []
        for item in self._list("notes"):
            members = cast(dict[str, object], item) if isinstance(item, dict) else {}
            words = [members.get(key) for key in ("severity", "subject", "text")]
            severity, subject, text = words
            known = severity in [each.value for each in Severity]
            if not known or not isinstance(subject, str) or not isinstance(text, str):
                raise FormatError(self.path, "notes: expected {severity, subject, text}")
            found.append(Note(Severity(severity), subject, text))
        return tuple(found)

    def unknown(self) -> dict[str, Scalar]:
        """The keys that are only kept."""
        return {key: value for key, value in self.values.items() if key not in KNOWN}

    def _list(self, key: str) -> list[object]:
        value = self.values.get(key)
        if value is None:
            return []
        items = tomllib.loads(f"v = {value}")["v"] if isinstance(value, TomlText) else None
        if not isinstance(items, list):
            raise FormatError(self.path, f"{key} = {value!r}; expected a list")
        return cast(list[object], items)


def split_head(text: str, path: str) -> tuple[Head, list[str], int]:
    """Return the head, the lines from the column names on, and the number of the first of these.

    Raises
    ------
    FormatError
        The text is no run file, or from a newer program.
    """
    values: dict[str, Scalar] = {}
    comments: list[str] = []
    lines = lines_of(text)
    for number, raw in enumerate(lines, start=1):
        line = _unquoted(raw)
        if line.startswith("#"):
            _read_line(line.removeprefix("#").strip(), values, comments, path, number)
        elif line:
            break
    else:
        raise FormatError(path, "holds no line of column names")
    _check_version(values, path)
    if comments:
        earlier = [str(values["comment"])] if "comment" in values else []
        values["comment"] = "\n".join([*earlier, *comments])
    return Head(path, values), lines[number - 1 :], number


def is_run_file(text: str) -> bool:
    """Whether a text begins like a run file."""
    first = next((line for line in map(_unquoted, lines_of(text[:4096])) if line), "")
    return first.startswith("#") and VERSION_KEY in text[:4096]


def head_text(values: Iterable[tuple[str, Scalar]]) -> str:
    """Keys and values as head lines."""
    return "".join(f"# {_key(key)} = {_value(value)}\n" for key, value in values)


def toml_list(texts: Iterable[str]) -> TomlText:
    """Texts as a TOML list."""
    return TomlText(f"[{', '.join(map(_string, texts))}]")


def toml_notes(notes: Iterable[Note]) -> TomlText:
    """Notes as a TOML list of tables."""
    tables = (
        f"{{severity = {_string(note.severity.value)}, subject = {_string(note.subject)},"
        f" text = {_string(note.text)}}}"
        for note in notes
    )
    return TomlText(f"[{', '.join(tables)}]")


def _check_version(values: Mapping[str, Scalar], path: str) -> None:
    version = values.get(VERSION_KEY)
    if version is None:
        raise FormatError(path, f"is no run file: the line '# {VERSION_KEY} = 1' is missing")
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise FormatError(path, f"{VERSION_KEY} = {version!r}; expected {VERSION}")
    if version > VERSION:
        raise FormatError(
            path,
            f"was written by a newer CalRig (run file version {version}; this program reads up to"
            f" version {VERSION}): update CalRig",
        )


def _unquoted(line: str) -> str:
    """A line as it was before a spreadsheet put it into a cell of its own."""
    line = line.strip()
    if line.startswith(('"#', "#")):
        line = line.rstrip(";,").strip()
    if line.startswith('"#') and line.endswith('"'):
        line = line[1:-1].replace('""', '"')
    return line


def _read_line(
    line: str, values: dict[str, Scalar], comments: list[str], path: str, number: int
) -> None:
    if "=" not in line:
        comments.append(line)
        return
    try:
        found = tomllib.loads(line)
    except (ValueError, RecursionError) as error:
        raise FormatError(path, f"no TOML value: {error}", line=number) from error
    left, right = (part.strip() for part in line.split("=", 1))
    for key, value in found.items():
        name = key
        while isinstance(value, dict) and not right.startswith("{"):  # a dotted key
            name, (value,) = left, cast(dict[str, object], value).values()
        if name in values:
            raise FormatError(path, f"{name} is given twice", line=number)
        values[name] = value if isinstance(value, str | bool | int | float) else TomlText(right)


def _key(key: str) -> str:
    bare = bool(key) and all(c.isascii() and (c.isalnum() or c in "-_") for c in key)
    return key if bare else _string(key)


def _value(value: Scalar) -> str:
    if isinstance(value, TomlText):
        return str(value)
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    return str(value) if isinstance(value, int) else repr(float(value))


def _string(text: str) -> str:
    # JSON's escapes are TOML's; only DEL needs one more.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
