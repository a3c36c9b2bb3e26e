"""Faults at the table: every story is told for its own fault, and none where there is none."""

import numpy as np
import pytest

from core.procedures.rate_faults import Examined, examine

RATES = np.arange(-100.0, 101.0, 20.0)
K, ZERO = -79.4, -438.0


def look(
    x: np.ndarray, implied: np.ndarray, se: np.ndarray | None = None, sigma: float = 1.0
) -> Examined:
    """Outputs of one sensor that truly turned at `implied`."""
    y = ZERO + K * implied + np.random.default_rng(1).normal(0.0, sigma, len(x))
    unknown = np.full((len(x), 1), np.nan)
    rows = list(range(1, len(x) + 1))
    return examine(x, y[:, None], unknown if se is None else se[:, None], ["g"], rows)


def test_good_rows_raise_nothing():
    for seed in range(200):
        slip = np.random.default_rng(seed).normal(0.0, 0.2, 11)
        found = look(RATES, RATES + slip)
        assert found.notes == ()
        assert not found.clipped.any()


@pytest.mark.parametrize(
    ("row", "implied", "story"),
    [
        (9, 0.0, "the table stood still"),
        (8, -60.0, "turned the wrong way"),
        (8, 42.0, "70 % of the accumulation"),
        (8, 60.0 * 180 / np.pi, "rad/s"),
        (8, 360.0, "rpm"),
        (5, 30.0, "something disturbed"),
        (8, 80.0, "the set rate is wrong"),
    ],
)
def test_each_fault_has_its_story(row: int, implied: float, story: str):
    turned = RATES.copy()
    turned[row] = implied
    found = look(RATES, turned)
    (note,) = found.notes
    assert note.subject == "wrong_rate"
    assert note.text.startswith(f"row {row + 1}, {RATES[row]:g} deg/s")
    assert story in note.text
    assert not found.clipped.any()


def test_a_table_fault_is_said_once_for_all_sensors():
    turned = RATES.copy()
    turned[3] = 0.0
    y = ZERO + turned[:, None] * np.array([K, 80.0, 10.0])
    found = examine(RATES, y, np.full((11, 3), np.nan), ["a", "b", "c"], list(range(1, 12)))
    (note,) = found.notes
    assert " in " not in note.text.split(";")[0]
    y[3, 0] = ZERO + RATES[3] * K
    found = examine(RATES, y, np.full((11, 3), np.nan), ["a", "b", "c"], list(range(1, 12)))
    assert "the output in b, c stands" in found.notes[0].text


@pytest.mark.parametrize(
    ("limit", "clipped"),
    [(90.0, [0, 10]), (50.0, [0, 1, 2, 8, 9, 10]), (101.0, [])],
)
def test_clipped_rates_are_found_at_both_ends(limit: float, clipped: list[int]):
    found = look(RATES, np.clip(RATES, -limit, limit))
    assert list(np.flatnonzero(found.clipped[:, 0])) == clipped
    assert {note.subject for note in found.notes} == ({"clipped"} if clipped else set())


def test_clipping_at_one_end_only():
    found = look(RATES, np.minimum(RATES, 70.0))
    assert list(np.flatnonzero(found.clipped[:, 0])) == [9, 10]


def test_a_sensor_that_bends_a_little_is_not_clipped():
    found = look(RATES, RATES * (1.0 - 2e-6 * RATES**2))
    assert not found.clipped.any()


def test_a_stop_at_the_last_rate_is_told_from_clipping_by_its_scatter():
    turned = RATES.copy()
    turned[-1] = 85.0
    se = np.ones(11)
    se[-1] = 60.0
    found = look(RATES, turned, se)
    assert not found.clipped.any()
    assert [note.subject for note in found.notes] == ["unsteady", "wrong_rate"]


def test_an_unsteady_row_is_named():
    se = np.full(11, 0.5)
    se[4] = 20.0
    (note,) = look(RATES, RATES, se).notes
    assert note.subject == "unsteady"
    assert note.text.startswith("row 5, -20 deg/s: the mean is 40 times less certain")


def test_too_few_rates_are_not_judged():
    x = np.array([-10.0, 0.0, 10.0])
    assert look(x, np.array([-10.0, 0.0, -10.0])).notes == ()


def test_repeated_rates_are_judged_together():
    x = np.tile(RATES, 2)
    found = look(x, np.clip(x, -90.0, 90.0))
    assert list(np.flatnonzero(found.clipped[:, 0])) == [0, 10, 11, 21]
