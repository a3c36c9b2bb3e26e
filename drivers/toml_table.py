"""A TOML table that is read strictly: every key asked for once, every other key refused.

`tomllib` does not say where a key stands, so the line is found again in the text; inside inline
tables it is the line of the outermost key.
"""

import math
import re
from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import Any, NoReturn, cast

from core.errors import FormatError

_HEADER = re.compile(r"\s*(\[\[?)\s*([A-Za-z0-9_.\-\" ]+?)\s*\]\]?\s*(#.*)?$")


def _section_lines(text: str, header: str, occurrence: int) -> range:
    """Return the 1-based lines below a header; `header` is empty for the top of the file."""
    lines = text.splitlines()
    begin, seen = (1, 0) if not header else (0, -1)
    for number, line in enumerate(lines, start=1):
        found = _HEADER.match(line)
        if not found:
            continue
        if begin:
            return range(begin, number)
        if found[2] == header:
            seen += 1
            if seen == occurrence:
                begin = number + 1
    return range(begin, len(lines) + 1) if begin else range(0)


class Table:
    """One table of a TOML file.

    Parameters
    ----------
    path : the file, for messages
    text : its whole text, to find lines in
    data : the parsed table
    header : name of the section, ``"frame"``; empty at the top of the file
    occurrence : which of several [[sections]] of that name, from 0
    outer : for an inline table, the key of the section that holds it
    """

    def __init__(
        self,
        path: str,
        text: str,
        data: Mapping[str, Any],
        header: str,
        occurrence: int = 0,
        outer: str = "",
    ) -> None:
        self._path = path
        self._text = text
        self._data = data
        self._header = header
        self._occurrence = occurrence
        self._outer = outer
        self._asked: set[str] = set()

    def fail(self, key: str, why: str) -> NoReturn:
        """Raise FormatError at the line of `key`, or of the section where `key` is empty."""
        section = _section_lines(self._text, self._header, self._occurrence)
        lines = self._text.splitlines()
        outermost = self._outer or key
        wanted = re.compile(rf"\s*\"?{re.escape(outermost)}\"?\s*=")
        line = next((n for n in section if outermost and wanted.match(lines[n - 1])), 0)
        if not line:
            place = section if self._header else _section_lines(self._text, key or "-", 0)
            line = max(0, place.start - 1)
        name = f"[{self._header}] " if self._header else ""
        inner = f"{self._outer}.{key}" if self._outer and key else outermost
        raise FormatError(self._path, f"{name}{inner}: {why}" if inner else name + why, line=line)

    def has(self, key: str) -> bool:
        """Return whether the file gives this key, which counts as asking for it."""
        self._asked.add(key)
        return key in self._data

    def _get(self, key: str, default: object) -> Any:
        if self.has(key):
            return self._data[key]
        if default is None:
            self.fail(key, "is missing")
        return default

    def text(self, key: str, default: str | None = None) -> str:
        """Return a string; None as default means that it must be given."""
        value = self._get(key, default)
        if not isinstance(value, str):
            self.fail(key, f"must be a text in quotes, not {value!r}")
        return value

    def choice(self, key: str, allowed: Iterable[str], default: str | None = None) -> str:
        """Return a string that is one of `allowed`."""
        value, names = self.text(key, default), tuple(allowed)
        if value not in names:
            close = get_close_matches(value, names, n=1)
            hint = f'; did you mean "{close[0]}"?' if close else ""
            self.fail(key, f'"{value}" is not one of {", ".join(names)}{hint}')
        return value

    def integer(
        self, key: str, default: int | None = None, *, low: int = 0, high: int = 2**32
    ) -> int:
        """Return a whole number between `low` and `high`."""
        value = self._get(key, default)
        if not isinstance(value, int) or isinstance(value, bool):
            self.fail(key, f"must be a whole number, not {value!r}")
        if not low <= value <= high:
            self.fail(key, f"must be between {low} and {high}, not {value}")
        return value

    def number(self, key: str, default: float | None = None) -> float:
        """Return a finite number."""
        value = self._get(key, default)
        if (
            not isinstance(value, int | float)
            or isinstance(value, bool)
            or not math.isfinite(value)
        ):
            self.fail(key, f"must be a finite number, not {value!r}")
        return float(value)

    def flag(self, key: str, default: bool) -> bool:
        """Return true or false."""
        value = self._get(key, default)
        if not isinstance(value, bool):
            self.fail(key, f"must be true or false, not {value!r}")
        return value

    def raw(self, key: str) -> object:
        """Return whatever stands there, which must be given."""
        return self._get(key, None)

    def listed(self, key: str, default: tuple[object, ...] | None = None) -> list[object]:
        """Return a list of whatever."""
        value = self._get(key, default)
        if not isinstance(value, list | tuple):
            self.fail(key, f"must be a list, [...], not {value!r}")
        return list(cast("list[object]", value))

    def texts(self, key: str, default: tuple[str, ...] | None = None) -> tuple[str, ...]:
        """Return a list of strings."""
        items = self.listed(key, default)
        if not all(isinstance(item, str) for item in items):
            self.fail(key, "every entry must be a text in quotes")
        return tuple(str(item) for item in items)

    def integers(self, key: str, default: tuple[int, ...] | None = None) -> tuple[int, ...]:
        """Return a list of whole numbers."""
        items = self.listed(key, default)
        numbers = tuple(
            item for item in items if isinstance(item, int) and not isinstance(item, bool)
        )
        if len(numbers) != len(items):
            self.fail(key, "every entry must be a whole number")
        return numbers

    def table(self, key: str) -> "Table":
        """Return a table inside this one: a section at the top of the file, else an inline one."""
        value = self._get(key, {})
        if not isinstance(value, dict):
            self.fail(key, f"must be a table, not {value!r}")
        data = cast("dict[str, Any]", value)
        if not self._header:
            return Table(self._path, self._text, data, key)
        outer = self._outer or key
        return Table(self._path, self._text, data, self._header, self._occurrence, outer)

    def tables(self, key: str) -> "list[Table]":
        """Return the [[key]] sections."""
        value = self._get(key, [])
        if not isinstance(value, list):
            self.fail(key, f"must be [[{key}]] sections")
        items = cast("list[object]", value)
        if not all(isinstance(item, dict) for item in items):
            self.fail(key, f"must be [[{key}]] sections")
        sections = cast("list[dict[str, Any]]", items)
        return [Table(self._path, self._text, item, key, n) for n, item in enumerate(sections)]

    def keys(self) -> tuple[str, ...]:
        """Return all keys, which counts as asking for them."""
        self._asked.update(self._data)
        return tuple(self._data)

    def done(self) -> None:
        """Refuse keys that nobody asked for."""
        for key in self._data:
            if key not in self._asked:
                close = get_close_matches(key, self._asked, n=1)
                hint = f'; did you mean "{close[0]}"?' if close else ""
                self.fail(key, f"is no key of this table{hint}")
