import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gui.widgets.number_text import (
    MINUS,
    aligned,
    decimals_of,
    fixed,
    grouped,
    significant,
    value_and_uncertainty,
)


@pytest.mark.parametrize(
    ("value", "uncertainty", "shown"),
    [
        (-79.378668, 0.01234, (f"{MINUS}79.379", "0.012")),
        (1316.4912, 12.7, ("1316", "13")),
        (1316.4912, 127.0, ("1320", "130")),
        (0.00012345, 0.0000996, ("0.00012", "0.00010")),
        (10.0, 0.0996, ("10.00", "0.10")),
        (0.04, 1.0, ("0.0", "1.0")),
        (-0.04, 1.0, ("0.0", "1.0")),
        (5.0, 9.96, ("5", "10")),
        (1.0, 0.0, ("1.000000", "—")),
        (1.0, math.nan, ("1.000000", "—")),
        (math.nan, 0.1, ("—", "0.10")),
        (math.inf, math.inf, ("∞", "—")),
    ],
)
def test_two_digits_of_the_uncertainty(value, uncertainty, shown):
    assert value_and_uncertainty(value, uncertainty) == shown


@given(
    st.floats(-1e6, 1e6),
    st.floats(1e-9, 1e6),
)
def test_rounding_never_takes_much_of_the_uncertainty(value, uncertainty):
    text, spread = value_and_uncertainty(value, uncertainty)
    shown, width = float(text.replace(MINUS, "-")), float(spread)
    assert abs(shown - value) <= 0.0501 * uncertainty + 1e-15 * abs(value)
    assert abs(width - uncertainty) <= 0.0501 * uncertainty
    assert not text.startswith(f"{MINUS}0") or shown != 0.0


def test_an_impossible_uncertainty_has_no_digits():
    for wrong in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="gives no number of digits"):
            decimals_of(wrong)


def test_significant():
    assert significant(0.0, 5) == "0"
    assert significant(-438.08364, 7) == f"{MINUS}438.0836"
    assert significant(1234567.8, 4) == "1234568"
    assert significant(1.5e-9, 3) == "1.50e\N{MINUS SIGN}09"
    assert significant(2.5e12, 2) == "2.5e+12"


def test_grouped():
    assert grouped(9999) == "9999"
    assert grouped(12480) == "12\N{NARROW NO-BREAK SPACE}480"
    assert grouped(-1234567).startswith(f"{MINUS}1")


def test_points_stand_in_one_column():
    figure, punctuation = "\N{FIGURE SPACE}", "\N{PUNCTUATION SPACE}"
    assert aligned(["1.25", "10", f"{MINUS}3.5"]) == [
        "1.25",
        "10" + punctuation + 2 * figure,
        f"{MINUS}3.5" + figure,
    ]
    assert aligned(["12", "7"]) == ["12", "7"]
    assert aligned([]) == []


def test_fixed_before_the_point():
    assert fixed(1234.0, -2) == "1200"
    assert fixed(-0.0001, 2) == "0.00"
