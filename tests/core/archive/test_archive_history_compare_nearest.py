"""Statistics of a parameter over time, and of two calibrations."""

import math
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from core.archive.compare import compare
from core.archive.entry import BAD, Entry, Quantity
from core.archive.history import history_of
from core.archive.limits import Limit
from core.archive.nearest import ranked
from core.archive.search import Reading

BEGIN = datetime(2020, 1, 1, tzinfo=UTC)


def entry(days: float = 0.0, temperature_c: float = 25.0, verdict: str = "good") -> Entry:
    when = (BEGIN + timedelta(days=days)).isoformat(timespec="seconds")
    return Entry(
        "calibration",
        f"{days}",
        "PW09",
        measured=when,
        temperature_c=temperature_c,
        verdict=verdict,
    )


def bias(value: float, u: float = 1.0, unit: str = "code") -> Quantity:
    return Quantity("acc_x", "bias", "U0", unit, value, u)


def series(values: Sequence[float], step_days: float = 365.25) -> list[Reading]:
    return [Reading(entry(step_days * i), bias(value)) for i, value in enumerate(values)]


def test_scatter_drift_and_excess_are_those_of_the_book() -> None:
    history = history_of(series([1.0, 3.0, 2.0, 6.0]), [Limit("bias", "code", -10.0, 10.0)])
    assert history.mean == 3.0
    assert history.repeatability == pytest.approx(np.std([1, 3, 2, 6], ddof=1))
    assert history.excess == pytest.approx(math.sqrt(14.0 / 3.0 - 1.0))
    assert history.u_repeatability == pytest.approx(history.repeatability / math.sqrt(6.0))
    assert history.drift is not None
    assert history.drift.value == pytest.approx(1.4, abs=0.002)
    assert history.drift.unit == "code/year"
    # Residuals of the line 0.9 + 1.4 t: 0.1, 0.7, -1.7, 0.9; s = sqrt(4.2 / 2), over sqrt(5).
    assert history.drift.u == pytest.approx(math.sqrt(2.1 / 5.0), rel=1e-3)
    assert history.limit is not None


@pytest.mark.slow
def test_the_excess_finds_the_true_turn_on_scatter() -> None:
    rng = np.random.default_rng(4)
    found = [
        history_of(series(rng.normal(0.0, 2.0, 20) + rng.normal(0.0, 1.0, 20))).excess ** 2
        for _ in range(400)
    ]
    assert np.mean(found) == pytest.approx(4.0, rel=0.06)


def test_what_does_not_belong_is_shown_and_told_and_does_not_count() -> None:
    readings = [
        Reading(entry(0.0), bias(1.0, unit="V")),
        Reading(entry(1.0, verdict=BAD), bias(900.0)),
        Reading(entry(2.0, temperature_c=60.0), bias(50.0)),
        Reading(entry(3.0), bias(1.0)),
        Reading(entry(4.0), bias(2.0)),
    ]
    history = history_of(readings, temperature_c=24.0)
    assert history.counted == (False, False, True, True)
    assert history.mean == 1.5
    assert history.drift is None
    assert [note.subject for note in history.notes] == [
        "other_units",
        "bad_left_out",
        "far_left_out",
    ]
    assert math.isnan(history_of(readings[-1:]).repeatability)
    with pytest.raises(ValueError, match="nothing"):
        history_of([])


def test_a_difference_is_judged_by_the_combined_uncertainty() -> None:
    later = (entry(10.0, 31.0), (bias(7.0, 4.0), Quantity("acc_y", "bias", "U0", "V", 1, 1)))
    earlier = (entry(0.0), (bias(1.0, 3.0), Quantity("acc_y", "bias", "U0", "code", 1, 1)))
    compared = compare(later, earlier)
    assert compared.first.measured < compared.second.measured
    row = compared.rows[0]
    assert (row.difference, row.u, row.ratio, row.marked) == (6.0, 5.0, 1.2, False)
    assert [note.subject for note in compared.notes] == ["other_units", "other_temperature"]
    assert compare(earlier, (entry(1.0), (bias(-8.0, 3.0),))).rows[0].ratio == pytest.approx(
        -9.0 / math.hypot(3.0, 3.0)
    )
    assert compare(earlier, (entry(1.0), (bias(-8.0, 3.0),))).marked == 1
    nothing = compare(earlier, (entry(1.0), (Quantity("z", "k", "k", "V", 1.0, 1.0),)))
    assert nothing.rows == ()
    assert "nothing_common" in {note.subject for note in nothing.notes}


def test_unchanged_units_are_marked_once_in_twenty() -> None:
    rng = np.random.default_rng(7)
    marks = [
        compare((entry(), (bias(a),)), (entry(1.0), (bias(b),))).marked
        for a, b in rng.normal(0.0, 1.0, (2000, 2))
    ]
    assert np.mean(marks) == pytest.approx(0.0455, abs=0.014)


def test_the_nearest_calibration_weighs_days_and_kelvins() -> None:
    entries = [
        entry(0.0, 25.0),
        entry(30.0, 60.0),
        entry(200.0, 55.0),
        entry(31.0, 60.0, BAD),
        Entry("calibration", "no date", "PW09"),
    ]
    when = BEGIN + timedelta(days=25)
    by_date = ranked(entries, when)
    assert [proposal.entry.path for proposal in by_date] == ["30.0", "0.0", "200.0"]
    assert by_date[0].days == pytest.approx(5.0)
    cold = ranked(entries, when, 26.0)
    assert [proposal.entry.path for proposal in cold] == ["0.0", "200.0", "30.0"]
    assert cold[0].kelvin == pytest.approx(-1.0)
    unknown = ranked([entry(0.0, math.nan), entry(0.5, 45.0)], when, 30.0)
    assert unknown[0].entry.path == "0.0"
