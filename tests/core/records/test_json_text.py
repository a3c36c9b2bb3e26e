"""What becomes JSON, and what is refused."""

import json
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from core.arrays import FloatArray, frozen
from core.errors import Note, Severity
from core.records.json_text import to_json


@dataclass(frozen=True, slots=True)
class Result:
    values: FloatArray
    notes: tuple[Note, ...]


def test_a_dataclass_with_arrays_and_notes_becomes_an_object():
    result = Result(frozen([[1.5, 2.0]]), (Note(Severity.WARNING, "short", "only 2 s"),))
    assert json.loads(to_json(result)) == {
        "values": [[1.5, 2.0]],
        "notes": [{"severity": "warning", "subject": "short", "text": "only 2 s"}],
    }


def test_doubles_survive_to_the_last_bit():
    value = 0.1 + 0.2
    assert json.loads(to_json({"value": np.float64(value)}))["value"] == value


def test_json_has_no_nan():
    assert json.loads(to_json([np.nan, np.inf, np.array([1.0, -np.inf])])) == [
        None,
        None,
        [1.0, None],
    ]


def test_paths_moments_bytes_and_numpy_scalars():
    moment = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)
    data = {"path": Path("a/b"), "at": moment, "raw": b"\xaa\x55", "n": np.int64(3), 4: True}
    assert json.loads(to_json(data)) == {
        "path": str(Path("a/b")),
        "at": "2026-01-02T03:04:05+00:00",
        "raw": "aa55",
        "n": 3,
        "4": True,
    }


def test_ascii_only_keeps_the_meaning():
    text = to_json({"unit": "°/s"}, ascii_only=True)
    assert text.isascii()
    assert json.loads(text) == {"unit": "°/s"}
    assert "°/s" in to_json({"unit": "°/s"})


@pytest.mark.parametrize("stranger", [object(), 1j, {1, 2}, Result])
def test_a_type_without_a_form_is_refused(stranger: object):
    with pytest.raises(TypeError, match="no form in JSON"):
        to_json({"value": stranger})
