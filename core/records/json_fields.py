"""JSON documents with a schema, read by look-ups that name the file and the key when they fail.

JSON has neither NaN nor infinity: a missing number is ``null``, an infinite one the text ``"inf"``
or ``"-inf"``.
"""

import json
import math
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import cast

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FormatError, Note, Severity

Json = None | bool | int | float | str | list["Json"] | dict[str, "Json"]

_INFINITE = {"inf": math.inf, "-inf": -math.inf}


def number_to_json(value: float) -> Json:
    """A number as JSON: NaN becomes null, an infinite number text."""
    if math.isfinite(value):
        return float(value)
    return None if math.isnan(value) else ("inf" if value > 0 else "-inf")


def numbers_to_json(values: Iterable[float]) -> list[Json]:
    """Numbers as a JSON list."""
    return [number_to_json(float(value)) for value in values]


def matrix_to_json(rows: FloatArray) -> list[Json]:
    """A matrix as a JSON list of its rows."""
    return [numbers_to_json(row) for row in rows]


def notes_to_json(notes: Iterable[Note]) -> list[Json]:
    """Notes as a JSON list."""
    return [
        {"severity": note.severity.value, "subject": note.subject, "text": note.text}
        for note in notes
    ]


def dump(document: Json, *, indent: int | None = 2) -> str:
    """JSON text of a document; one line if `indent` is None."""
    separators = (",", ":") if indent is None else None
    return json.dumps(
        document, ensure_ascii=False, indent=indent, allow_nan=False, separators=separators
    )


def load_document(text: str, path: Path | str, schema: str, version: int) -> "Fields":
    """Read a document whose ``schema`` and ``schema_version`` must fit.

    Raises
    ------
    FormatError
        It is no JSON, another document, or from a newer program.
    """
    fields = load_object(text, path)
    found = fields.data.get("schema")
    if found != schema:
        raise FormatError(path, f"is no {schema} document (schema = {found!r})")
    number = fields.integer("schema_version")
    if number > version:
        raise FormatError(
            path,
            f"was written by a newer CalRig ({schema} version {number}; this program reads up to"
            f" version {version}): update CalRig",
        )
    return fields


def load_object(text: str, path: Path | str) -> "Fields":
    """Read a JSON object.

    Raises
    ------
    FormatError
        The text is damaged, or no object.
    """
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise FormatError(
            path, f"damaged JSON: {error.msg}", line=error.lineno, column=error.colno
        ) from error
    except (RecursionError, ValueError) as error:  # nested too deeply; numbers of too many digits
        raise FormatError(path, f"damaged JSON: {error}") from error
    if not isinstance(document, dict):
        raise FormatError(path, "is no JSON object")
    return Fields(str(path), "", cast(dict[str, Json], document))


@dataclass(frozen=True, slots=True)
class Fields:
    """The members of one JSON object.

    Parameters
    ----------
    path : the file, for messages
    where : path of the object in the document, empty at the top
    data : its members
    """

    path: str
    where: str
    data: dict[str, Json]

    def text(self, key: str) -> str:
        """A text."""
        value = self._get(key)
        if not isinstance(value, str):
            raise self.wrong(key, "a text", value)
        return value

    def moment(self, key: str) -> str:
        """A moment as ISO 8601 text with its offset from UTC."""
        value = self.text(key)
        try:
            known = datetime.fromisoformat(value).tzinfo is not None
        except ValueError:
            known = False
        if not known:
            raise self.wrong(key, "a moment such as 2024-05-13T14:05:00+03:00", value)
        return value

    def flag(self, key: str) -> bool:
        """True or false."""
        value = self._get(key)
        if not isinstance(value, bool):
            raise self.wrong(key, "true or false", value)
        return value

    def number(self, key: str) -> float:
        """A number; null is NaN."""
        return self._float(key, self._get(key))

    def integer(self, key: str) -> int:
        """A whole number."""
        value = self._get(key)
        if isinstance(value, bool) or not isinstance(value, int):
            raise self.wrong(key, "a whole number", value)
        return value

    def numbers(self, key: str, size: int | None = None) -> FloatArray:
        """A list of numbers, of this length if one is given."""
        items = self.items(key)
        if size is not None and len(items) != size:
            raise self.wrong(key, f"{size} numbers", f"{len(items)} items")
        return frozen([self._float(key, item) for item in items])

    def matrix(self, key: str, rows: int, columns: int) -> FloatArray:
        """A matrix as a list of its rows."""
        items = self.items(key)
        if len(items) != rows:
            raise self.wrong(key, f"{rows} rows", f"{len(items)} rows")
        values = np.zeros((rows, columns))
        for i, item in enumerate(items):
            if not isinstance(item, list) or len(item) != columns:
                raise self.wrong(f"{key}[{i}]", f"{columns} numbers", item)
            values[i] = [self._float(f"{key}[{i}]", number) for number in item]
        return frozen(values)

    def texts(self, key: str) -> tuple[str, ...]:
        """A list of texts."""
        items = self.items(key)
        for item in items:
            if not isinstance(item, str):
                raise self.wrong(key, "texts", item)
        return tuple(cast(list[str], items))

    def scalars(self, key: str) -> dict[str, str | float | bool]:
        """An object whose members are texts, numbers or flags."""
        fields = self.object(key)
        for name, value in fields.data.items():
            if not isinstance(value, str | int | float):
                raise fields.wrong(name, "a text, a number or true or false", value)
        return cast(dict[str, str | float | bool], dict(fields.data))

    def object(self, key: str) -> "Fields":
        """An object."""
        value = self._get(key)
        if not isinstance(value, dict):
            raise self.wrong(key, "an object", value)
        return Fields(self.path, self._place(key), value)

    def objects(self, key: str) -> list["Fields"]:
        """A list of objects."""
        found: list[Fields] = []
        for i, item in enumerate(self.items(key)):
            if not isinstance(item, dict):
                raise self.wrong(f"{key}[{i}]", "an object", item)
            found.append(Fields(self.path, self._place(f"{key}[{i}]"), item))
        return found

    def notes(self, key: str) -> tuple[Note, ...]:
        """Notes as `notes_to_json` writes them."""
        found: list[Note] = []
        for item in self.objects(key):
            word = item.text("severity")
            if word not in {severity.value for severity in Severity}:
                raise item.wrong("severity", "info, warning or error", word)
            found.append(Note(Severity(word), item.text("subject"), item.text("text")))
        return tuple(found)

    def items(self, key: str) -> list[Json]:
        """A list."""
        value = self._get(key)
        if not isinstance(value, list):
            raise self.wrong(key, "a list", value)
        return value

    def wrong(self, key: str, wanted: str, found: Json) -> FormatError:
        """The error that a member is not what it should be."""
        shown = repr(found)
        shown = shown if len(shown) <= 60 else shown[:60] + "..."
        return FormatError(self.path, f"{self._place(key)} must be {wanted}, found {shown}")

    def _get(self, key: str) -> Json:
        if key not in self.data:
            raise FormatError(self.path, f"{self._place(key)} is missing")
        return self.data[key]

    def _place(self, key: str) -> str:
        return f"{self.where}.{key}" if self.where else key

    def _float(self, key: str, value: Json) -> float:
        if value is None:
            return math.nan
        if isinstance(value, str) and value in _INFINITE:
            return _INFINITE[value]
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.wrong(key, "a number", value)
        try:
            return float(value)
        except OverflowError as error:
            raise self.wrong(key, "a number", value) from error
