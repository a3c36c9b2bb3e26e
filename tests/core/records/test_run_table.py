import numpy as np
import pytest

from core.errors import FormatError
from core.records.run_table import Output, read_table


def table(*lines):
    return read_table(list(lines), 10, "f")


def test_lines_are_counted_over_blank_lines_and_long_cells():
    found = table("a,b", "", '1,"x', 'y"', "2,z", "nope,z")
    assert found.lines == [13, 14, 15]
    assert found.texts("b") == ("x\ny", "z", "z")
    with pytest.raises(FormatError, match="'nope' is no number") as caught:
        found.numbers("a")
    assert (caught.value.line, caught.value.column) == (15, 1)


def test_semicolons_bring_decimal_commas():
    found = table("a;b", "1,5;2", ";3")
    np.testing.assert_array_equal(found.numbers("a"), [1.5, np.nan])


def test_missing_columns():
    found = table("a", "1", "2")
    assert np.isnan(found.numbers("b")).all()
    assert found.integers("b", np.arange(2.0)).tolist() == [0, 1]
    assert found.texts("b") == ("", "")


def test_columns_of_outputs():
    assert table("y,y_se", "1,2").outputs(()) == [Output("y", "y_se", "")]
    assert table("y_x,y_se_x,y_z,y_z_se", "1,2,3,4").outputs(()) == [
        Output("y_x", "y_se_x", "x"),
        Output("y_z", "y_z_se", "z"),
    ]
    assert table("y_a,y_se_a,y_se_b", "1,2,3").outputs(()) == [
        Output("y_a", "y_se_a", "a"),
        Output("y_se_b", "y_se_b_se", "se_b"),
    ]
    with pytest.raises(FormatError, match="2 channels are named, 1 outputs found"):
        table("y", "1").outputs(("a", "b"))


def test_numbers_too_large_to_count():
    with pytest.raises(FormatError, match="no whole number"):
        table("run", "1e30").integers("run", np.ones(1))


def test_empty_tables():
    for lines in (("a,b",), ("a,b", ",", "")):
        with pytest.raises(FormatError, match="holds no rows"):
            table(*lines)
    with pytest.raises(FormatError, match="has no name"):
        table("a,,b", "1,2,3")
