import math
from pathlib import Path

import pytest

from core.errors import FormatError
from core.records.legacy.reader import parse_legacy
from core.records.legacy.rows import number_of, text_rows, why_no_number

SPECIMENS = Path(__file__).parents[3] / "data" / "legacy"


def edited(name: str, line: int, column: int, cell: str) -> str:
    text = (SPECIMENS / name).read_text(encoding="utf-8")
    lines = [row.split("\t") for row in text.splitlines()]
    lines[line - 1][column - 1] = cell
    return "\n".join("\t".join(row) for row in lines)


@pytest.mark.parametrize(
    ("cell", "value"),
    [("0", 0), ("+27", 27), ("-40", -40), ("1,5", 1.5), (".5", 0.5), ("5.", 5), ("1.5E-3", 0.0015)],
)
def test_numbers(cell, value):
    assert number_of(cell) == value


@pytest.mark.parametrize(
    "cell", ["", "nan", "inf", "1_0", "1 0", "0x1", "1.2.3", "1,234.5", "٣", "+", "1e", "1e999"]
)
def test_what_is_no_number(cell):
    assert math.isnan(number_of(cell))
    assert why_no_number(cell)


def test_separators_that_tell_where_the_name_ends():
    (strict,) = text_rows(["Gyro  31\t1\t2"])
    assert (strict.cells, strict.sure) == (["Gyro  31", "1", "2"], True)
    assert strict.fits(2)
    assert not strict.fits(1)
    (loose,) = text_rows(["Gyro 31 1 2"])
    assert loose.fits(2)
    assert loose.fits(3)
    assert loose.name(2) == "Gyro 31"
    (empty,) = text_rows(["a;1;;2;"])
    assert empty.cells == ["a", "1", "", "2"]


def test_a_name_never_ends_with_a_measured_number():
    (row,) = text_rows(["Gyro -0.5 1 2"])
    assert row.fits(3)
    assert not row.fits(2)


def test_both_decimal_marks_in_one_file_are_refused():
    with pytest.raises(FormatError) as caught:
        parse_legacy(edited("OpticalDividingHead_202405140930.txt", 6, 9, "152,03"), "f.txt")
    error = caught.value
    assert (error.line, error.column) == (6, 9)
    assert "decimal mark" in error.why
