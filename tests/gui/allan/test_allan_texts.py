"""Numbers of a noise study as people read them."""

import pytest

from core.records.noise_tables import Quote
from gui.allan.texts import duration, interval, number, plain_unit, quoted, short


def quote(value: float, lower: float, upper: float, *, limit: bool = False) -> Quote:
    u = (upper - lower) / 4.0
    return Quote("random_walk", "N", "likelihood", "x", "u", value, u, lower, upper, limit)


@pytest.mark.parametrize(
    ("value", "resolution", "text"),
    [
        (0.0024965, 5.9e-6, "0.0024965"),
        (4.357e-5, 1e-8, "4.3570e−5"),
        (-3e-9, 1e-10, "−3.00e−9"),
        (12.0, float("nan"), "12.0"),
        (12.0, 0.0, "12.0"),
    ],
)
def test_as_many_digits_as_the_interval_allows(value: float, resolution: float, text: str) -> None:
    assert number(value, resolution) == text


def test_what_is_not_detected_is_quoted_as_a_limit() -> None:
    assert quoted(quote(0.0, 0.0, 0.00494, limit=True)) == "< 0.0049"
    assert interval(quote(0.0, 0.0, 0.00494, limit=True)) == ""
    assert quoted(None) == "—"
    assert interval(quote(1.0, 0.95, 1.05)) == "0.950 … 1.050"


def test_lengths_and_units_are_plain() -> None:
    assert [duration(s) for s in (45.0, 750.0, 3600.0, 200_000.0)] == [
        "45 s",
        "12.5 min",
        "1 h",
        "2.31 d",
    ]
    assert plain_unit("deg/s/sqrt(Hz)") == "°/s/√Hz"
    assert short(0.0) == "0"
