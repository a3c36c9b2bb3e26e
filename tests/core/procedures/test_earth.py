"""When the rate of the Earth matters."""

import math

import pytest

from core.procedures.earth import feels, latitude_missing, level_dps, vertical_dps


def test_the_earth_in_kyiv():
    assert vertical_dps(50.45) * 3600.0 == pytest.approx(11.60, abs=0.005)
    assert level_dps(50.45) * 3600.0 == pytest.approx(9.58, abs=0.005)
    assert math.isnan(vertical_dps(math.nan))


@pytest.mark.parametrize(
    ("uncertainty", "stability", "expected"),
    [(1e-3, math.nan, True), (1e-2, math.nan, False), (1e-2, 1e-4, True), (1e-4, 1e-2, False)],
)
def test_a_stated_stability_decides_before_the_uncertainty(uncertainty, stability, expected):
    assert feels(uncertainty, 0.003, stability) is expected


def test_the_note_says_how_much_and_what_to_do():
    note = latitude_missing("b_zz", "state it")
    assert "15.0 deg/h" in note.text
    assert note.text.endswith("state it")
