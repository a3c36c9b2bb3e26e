import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError, Note, Severity
from core.records.json_fields import (
    dump,
    load_document,
    load_object,
    matrix_to_json,
    notes_to_json,
    number_to_json,
    numbers_to_json,
)


@given(st.lists(st.floats(width=64), max_size=20))
def test_numbers_come_back_to_the_last_bit(values):
    text = dump({"v": numbers_to_json(values)})
    np.testing.assert_array_equal(load_object(text, "f").numbers("v"), values)


def test_what_json_has_no_number_for():
    assert [number_to_json(value) for value in (math.nan, math.inf, -math.inf)] == [
        None,
        "inf",
        "-inf",
    ]


def test_matrices_and_notes():
    matrix = np.array([[1.0, np.nan, 3.0], [4.0, 5.0, np.inf]])
    notes = (Note(Severity.WARNING, "a", "їєґ"),)
    text = dump({"m": matrix_to_json(matrix), "notes": notes_to_json(notes)}, indent=None)
    fields = load_object(text, "f")
    np.testing.assert_array_equal(fields.matrix("m", 2, 3), matrix)
    assert fields.notes("notes") == notes
    with pytest.raises(FormatError, match="m must be 3 rows"):
        fields.matrix("m", 3, 3)
    with pytest.raises(FormatError, match=r"m\[0\] must be 2 numbers"):
        fields.matrix("m", 2, 2)


LOOKUPS = {
    "text": lambda f: f.text("v"),
    "moment": lambda f: f.moment("v"),
    "flag": lambda f: f.flag("v"),
    "number": lambda f: f.number("v"),
    "integer": lambda f: f.integer("v"),
    "numbers": lambda f: f.numbers("v"),
    "texts": lambda f: f.texts("v"),
    "object": lambda f: f.object("v"),
    "objects": lambda f: f.objects("v"),
    "scalars": lambda f: f.scalars("v"),
    "notes": lambda f: f.notes("v"),
}
WRONG = {
    "text": ["1", "null", "[]"],
    "moment": ['"today"', '"2024-05-13"', '"2024-05-13T10:00"', "1"],
    "flag": ["1", '"true"', "null"],
    "number": ['"1"', "true", "[]", "1" + "0" * 400],
    "integer": ["1.5", "true", "null", "1.0"],
    "numbers": ["1", '["a"]', "[true]", "[[1]]"],
    "texts": ["[1]", '"a"'],
    "object": ["[]", "1"],
    "objects": ["{}", "[1]"],
    "scalars": ["[]", '{"a": null}', '{"a": {}}'],
    "notes": ['[{"severity": "bad", "subject": "a", "text": "b"}]', "[1]", "[{}]"],
}


@pytest.mark.parametrize(("kind", "value"), [(k, v) for k, vs in WRONG.items() for v in vs])
def test_a_wrong_member_is_named(kind, value):
    fields = load_object(f'{{"outer": {{"v": {value}}}}}', "file.json").object("outer")
    with pytest.raises(FormatError, match=r"file\.json: outer\.v") as caught:
        LOOKUPS[kind](fields)
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize("kind", LOOKUPS)
def test_a_missing_member_is_named(kind):
    with pytest.raises(FormatError, match="v is missing"):
        LOOKUPS[kind](load_object("{}", "f"))


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "1", '{"a": 1,}', "[" * 100_000, '{"a": ' + "9" * 5000 + "}"]
)
def test_damaged_documents(text):
    with pytest.raises(FormatError):
        load_object(text, "f")


def test_the_place_of_damage():
    with pytest.raises(FormatError, match="damaged JSON") as caught:
        load_object('{\n "a": 1\n "b": 2}', "f")
    assert (caught.value.line, caught.value.column) == (3, 2)


def test_schemas():
    text = '{"schema": "calrig-x", "schema_version": 3}'
    assert load_document(text, "f", "calrig-x", 3).integer("schema_version") == 3
    with pytest.raises(FormatError, match=r"newer CalRig .*version 3.* up to version 2"):
        load_document(text, "f", "calrig-x", 2)
    with pytest.raises(FormatError, match="is no calrig-y document"):
        load_document(text, "f", "calrig-y", 3)
