"""Any result as JSON text."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import datetime
from enum import Enum
from pathlib import PurePath
from typing import cast

import numpy as np

from core.records.json_fields import Json


def to_json(data: object, *, ascii_only: bool = False) -> str:
    """Return `data` as JSON text with a final newline.

    Dataclasses become objects by their fields, arrays become nested lists, an enum its value, a
    moment its ISO text. JSON has no NaN and no infinity: both become null.

    Raises
    ------
    TypeError
        For a type that has no obvious form in JSON.
    """
    text = json.dumps(_plain(data), ensure_ascii=ascii_only, indent=2, allow_nan=False)
    return text + "\n"


def _plain(value: object) -> Json:
    if isinstance(value, np.ndarray | np.generic):
        return _plain(cast("object", value.tolist()))
    if isinstance(value, Mapping):
        items = cast("Mapping[object, object]", value).items()
        return {str(key): _plain(item) for key, item in items}
    if isinstance(value, Sequence) and not isinstance(value, str | bytes):
        return [_plain(item) for item in cast("Sequence[object]", value)]
    if is_dataclass(value) and not isinstance(value, type):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    return _scalar(value)


def _scalar(value: object) -> Json:
    if isinstance(value, Enum):
        return _scalar(value.value)
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, PurePath):
        return str(value)
    if isinstance(value, datetime):
        return value.isoformat()
    if isinstance(value, bytes):
        return value.hex()
    raise TypeError(f"{type(value).__name__} has no form in JSON")
