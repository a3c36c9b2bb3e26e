import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError, Note, Severity
from core.records.run_head import (
    TomlText,
    head_text,
    is_run_file,
    split_head,
    toml_list,
    toml_notes,
)

FIRST = ("calrig-run", 1)


def read(values):
    head, body, line = split_head(head_text([FIRST, *values]) + "run,y\n1,2\n", "f")
    assert body == ["run,y", "1,2"]
    assert line == len(values) + 2
    return head


@given(
    st.text(st.characters(exclude_categories=("Cs",)), min_size=1, max_size=10),
    st.text(st.characters(exclude_categories=("Cs",)), max_size=30)
    | st.booleans()
    | st.integers(-(2**60), 2**60)
    | st.floats(allow_nan=False),
)
def test_any_key_and_value_come_back(key, value):
    values = read([(f"k{key}", value)]).values
    assert values[f"k{key}"] == value
    assert type(values[f"k{key}"]) is type(value)


def test_lists_and_dates_are_kept_as_they_came():
    head = read([("a", TomlText("[1, 'two']")), ("day", TomlText("2024-05-13"))])
    assert isinstance(head.values["a"], TomlText)
    assert head.values["day"] == "2024-05-13"
    assert "calrig-run" not in head.unknown()


def test_tables_and_dotted_keys_are_kept():
    lines = "# calrig-run = 1\n# bench = {room = 7}\n# lab.room = 8\n# lab.door = 'west'\ny\n"
    head, _, _ = split_head(lines, "f")
    assert head.unknown() == {"bench": "{room = 7}", "lab.room": 8, "lab.door": "west"}
    again, _, _ = split_head(head_text(head.values.items()) + "y\n", "f")
    assert again == head


def test_lists_of_texts_and_notes():
    notes = (Note(Severity.ERROR, "a", 'line "one"\nline two'),)
    head = read([("channels", toml_list(["AX", "з ком, ою"])), ("notes", toml_notes(notes))])
    assert head.texts("channels") == ("AX", "з ком, ою")
    assert head.texts("axes") == ()
    assert head.notes() == notes


def test_lists_of_something_else():
    for value in ("[1]", "{}"):
        wrong = read([("channels", TomlText(value))])
        with pytest.raises(FormatError, match="channels"):
            wrong.texts("channels")
    wrong = read([("notes", TomlText("[{severity='x'}]"))])
    with pytest.raises(FormatError, match="notes"):
        wrong.notes()


def test_lines_without_a_key_are_kept_as_a_comment():
    head, _, _ = split_head("# calrig-run = 1\n# measured by hand\n#\n# twice\ny\n", "f")
    assert head.values["comment"] == "measured by hand\n\ntwice"


def test_what_begins_like_a_run_file():
    assert is_run_file("# calrig-run = 1\n")
    assert is_run_file('\n"# calrig-run = 1";;\n')
    assert not is_run_file("PW09 0 0 0 calrig-run")
    assert not is_run_file("")
