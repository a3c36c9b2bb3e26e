"""What the operator reads when something cannot be done."""

from pathlib import Path

import pytest

from core.errors import FitError, FormatError, LabError, LinkError, RankDeficient


@pytest.mark.parametrize(
    ("place", "text"),
    [
        ({"line": 3, "column": 8}, "a.txt, line 3, column 8: no number"),
        ({"line": 3}, "a.txt, line 3: no number"),
        ({}, "a.txt: no number"),
    ],
)
def test_a_format_error_says_where(place: dict[str, int], text: str):
    error = FormatError(Path("a.txt"), "no number", **place)
    assert str(error) == text
    assert (error.path, error.why) == ("a.txt", "no number")


def test_a_rank_deficient_fit_names_what_is_free():
    error = RankDeficient(("k_xy", "k_xz"), "measure with Z down")
    assert str(error) == "not determined: k_xy, k_xz; measure with Z down"
    assert isinstance(error, FitError)
    assert error.free == ("k_xy", "k_xz")


def test_a_link_error_says_what_to_do():
    assert str(LinkError("COM4", "is busy", "close the other program")) == (
        "COM4: is busy (close the other program)"
    )
    assert str(LinkError("COM4", "is busy")) == "COM4: is busy"
    assert isinstance(LinkError("COM4", "is busy"), LabError)
