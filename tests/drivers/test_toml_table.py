"""Strict reading of tables: types, unknown keys, and the line where it stands."""

import tomllib
from collections.abc import Callable

import pytest

from core.errors import FormatError
from drivers.toml_table import Table

TEXT = """\
schema = 1
[port]
# baud = 3
baud = [9600]
"format" = "8N1"
[[field]]
names = ["a"]
[[field]]
names = ["b", 2]
inner = { at = 4, deep = { x = 1 } }
"""


def top() -> Table:
    return Table("x.toml", TEXT, tomllib.loads(TEXT), "")


def test_values_and_defaults():
    port = top().table("port")
    assert port.integers("baud") == (9600,)
    assert port.text("format") == "8N1"
    assert port.integer("settle_ms", 5) == 5
    assert port.flag("dtr", False) is False
    assert port.texts("none", ()) == ()
    port.done()


@pytest.mark.parametrize(
    ("ask", "line", "words"),
    [
        (lambda t: t.table("port").text("baud"), 4, "must be a text"),
        (lambda t: t.table("port").integer("format"), 5, "whole number"),
        (lambda t: t.table("port").number("settle"), 2, "is missing"),
        (lambda t: t.table("port").choice("format", ["8N2", "7E1"]), 5, 'did you mean "8N2"'),
        (lambda t: t.tables("field")[1].texts("names"), 9, "every entry"),
        (lambda t: t.tables("field")[0].texts("roles"), 6, "is missing"),
        (lambda t: t.tables("field")[1].table("inner").integer("at", high=3), 10, "0 and 3"),
        (lambda t: t.tables("field")[1].table("inner").table("deep").text("x"), 10, "inner.x"),
        (lambda t: t.integer("port"), 2, "whole number"),
        (lambda t: t.table("schema"), 1, "must be a table"),
        (lambda t: t.tables("port"), 2, "sections"),
        (lambda t: t.integer("version"), 0, "is missing"),
        (lambda t: t.table("port").flag("format", True), 5, "true or false"),
        (lambda t: t.table("port").number("format"), 5, "finite number"),
        (lambda t: t.table("port").texts("format"), 5, "list"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_with_its_line(ask: Callable[[Table], object], line: int, words: str):
    with pytest.raises(FormatError) as caught:
        ask(top())
    assert caught.value.line == line
    assert caught.value.path == "x.toml"
    assert words in str(caught.value)


def test_unknown_keys_are_refused_with_the_likely_one():
    port = top().table("port")
    port.integers("baud")
    port.text("formats", "8N1")
    with pytest.raises(FormatError, match=r'line 5: \[port\] format: .* did you mean "formats"'):
        port.done()


def test_not_a_number_and_infinity_are_no_numbers():
    text = "a = nan\nb = inf\nc = true\n"
    table = Table("x", text, tomllib.loads(text), "")
    for key in "abc":
        with pytest.raises(FormatError):
            table.number(key)
    with pytest.raises(FormatError):
        table.integer("c")
