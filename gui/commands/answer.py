"""What a subcommand gives back, and how it becomes JSON."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from datetime import datetime
from enum import Enum
from pathlib import PurePath
from typing import Any

import numpy as np


@dataclass(frozen=True, slots=True)
class Answer:
    """The result of a subcommand.

    Parameters
    ----------
    data : dataclass or mapping, what ``--json`` writes
    text : what a person reads, without a final newline
    code : exit code; 0, or 1 where the work was done and its result is "no"
    """

    data: object
    text: str
    code: int = 0


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


def _plain(value: Any) -> Any:
    match value:
        case np.ndarray() | np.generic():
            return _plain(value.tolist())
        case Mapping():
            return {str(key): _plain(item) for key, item in value.items()}
        case Sequence() if not isinstance(value, str | bytes):
            return [_plain(item) for item in value]
        case _ if is_dataclass(value) and not isinstance(value, type):
            return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    return _scalar(value)


def _scalar(value: Any) -> Any:
    match value:
        case Enum():
            return _scalar(value.value)
        case None | bool() | int() | str():
            return value
        case float():
            return value if math.isfinite(value) else None
        case PurePath():
            return str(value)
        case datetime():
            return value.isoformat()
        case bytes():
            return value.hex()
    raise TypeError(f"{type(value).__name__} has no form in JSON")
