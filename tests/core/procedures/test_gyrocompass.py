"""Heading and drift on both hemispheres, with tilt, with a ramp; what cannot be done is refused."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError, RankDeficient
from core.procedures.gyrocompass import find_north, run_of_headings
from core.samples.run import Conditions

EARTH_DPH = 15.041067
QUARTERS = np.array([0.0, 90.0, 180.0, 270.0])
KYIV = Conditions(latitude_deg=50.45)


def felt(
    headings: np.ndarray,
    azimuth: float,
    latitude: float,
    drift: float,
    tilt_deg: float | np.ndarray = 0.0,
) -> np.ndarray:
    """By vectors in the room: north, east, up; in deg/h."""
    earth = EARTH_DPH * np.array([np.cos(np.radians(latitude)), 0.0, np.sin(np.radians(latitude))])
    around, up = np.radians(azimuth + headings), np.radians(tilt_deg) * np.ones_like(headings)
    axis = np.column_stack([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
    return axis @ earth + drift


@pytest.mark.parametrize("latitude", [50.45, 0.0, -33.9, -70.0])
@pytest.mark.parametrize("azimuth", [0.0, 10.0, 137.5, 270.0, 359.0])
def test_heading_and_drift_on_both_hemispheres(latitude: float, azimuth: float):
    rates = felt(QUARTERS, azimuth, latitude, -0.8)
    run = run_of_headings(QUARTERS, rates, "deg/h", se=np.full(4, 1e-4))
    found = find_north(run, Conditions(latitude_deg=latitude))
    assert (found.heading.value - azimuth + 180.0) % 360.0 - 180.0 == pytest.approx(0.0, abs=1e-3)
    assert found.drift.value == pytest.approx(-0.8, abs=1e-6)
    assert found.level.value == pytest.approx(found.expected_dph, rel=1e-5)
    assert "level_rate" not in [note.subject for note in found.notes]


def test_any_headings_serve():
    headings = np.array([3.0, 50.0, 111.0, 200.0, 333.0])
    run = run_of_headings(headings, felt(headings, 77.0, 50.45, 2.0), "deg/h")
    found = find_north(run, KYIV)
    assert found.heading.value == pytest.approx(77.0)
    assert found.fit.dof == 2


def test_tilt_is_taken_into_account():
    tilt = np.array([0.5, -0.3, -0.5, 0.3])
    rates = felt(QUARTERS, 20.0, 50.45, 1.0, tilt)
    se = np.full(4, 1e-3)
    known = run_of_headings(QUARTERS, rates, "deg/h", se=se, tilt_deg=tilt)
    assert find_north(known, KYIV).heading.value == pytest.approx(20.0, abs=1e-6)
    unknown = find_north(run_of_headings(QUARTERS, rates, "deg/h", se=se), KYIV)
    assert abs(unknown.heading.value - 20.0) > 0.1
    (note,) = (note for note in unknown.notes if note.subject == "tilt_unknown")
    assert "by 1.2 arcmin" in note.text
    # In the south the same tilt acts the other way.
    south = Conditions(latitude_deg=-50.45)
    mirrored = run_of_headings(
        QUARTERS, felt(QUARTERS, 20.0, -50.45, 1.0, tilt), "deg/h", se=se, tilt_deg=tilt
    )
    assert find_north(mirrored, south).heading.value == pytest.approx(20.0, abs=1e-6)
    assert abs(find_north(mirrored, KYIV).heading.value - 20.0) > 0.2


def test_an_unsure_tilt_is_in_the_uncertainty():
    run = run_of_headings(
        QUARTERS,
        felt(QUARTERS, 20.0, 50.45, 1.0),
        "deg/h",
        se=np.full(4, 1e-6),
        tilt_deg=np.zeros(4),
    )
    found = find_north(run, KYIV, u_tilt_arcmin=1.0)
    expected = np.tan(np.radians(50.45)) / np.sqrt(2.0) / 60.0
    assert found.heading.u == pytest.approx(expected, rel=0.02)


def test_a_ramp_is_estimated_along():
    headings = np.append(QUARTERS, [0.0, 90.0])
    t = np.arange(6) * 20.0
    rates = felt(headings, 200.0, 50.45, 0.5) + 3.0 * (t - t.mean()) / 3600.0 * 100.0
    run = run_of_headings(headings, rates, "deg/h", t_s=t)
    found = find_north(run, KYIV, ramp=True)
    assert found.heading.value == pytest.approx(200.0)
    assert found.fit.value("ramp") == pytest.approx(300.0)
    assert abs(find_north(run, KYIV).heading.value - 200.0) > 0.5


def test_units_and_scale_factor():
    rates = felt(QUARTERS, 40.0, 50.45, 1.0)
    per_s = run_of_headings(QUARTERS, rates / 3600.0, "deg/s", se=np.full(4, 1e-6))
    codes = run_of_headings(QUARTERS, -79.4 * rates / 3600.0, "code", se=np.full(4, 1e-4))
    radians = run_of_headings(QUARTERS, np.radians(rates / 3600.0), "rad/s", se=np.full(4, 1e-8))
    for run, scale in ((per_s, np.nan), (codes, -79.4), (radians, np.nan)):
        found = find_north(run, KYIV, scale_factor=scale)
        assert found.heading.value == pytest.approx(40.0)
        assert found.drift.value == pytest.approx(1.0)
    with pytest.raises(FitError, match=r"in code, which is no rate; state the scale factor"):
        find_north(codes, KYIV)


def test_a_wrong_scale_factor_is_noticed_but_does_no_harm():
    run = run_of_headings(
        QUARTERS, 1.2 * felt(QUARTERS, 40.0, 50.45, 1.0), "deg/h", se=np.full(4, 0.01)
    )
    found = find_north(run, KYIV)
    assert found.heading.value == pytest.approx(40.0)
    assert "level_rate" in [note.subject for note in found.notes]


def test_latitude_may_be_unknown_on_a_level_base():
    run = run_of_headings(QUARTERS, felt(QUARTERS, 40.0, 50.45, 1.0), "deg/h", se=np.full(4, 0.01))
    found = find_north(run, Conditions())
    assert found.heading.value == pytest.approx(40.0)
    assert "latitude_missing" in [note.subject for note in found.notes]
    tilted = replace(run, extra={"tilt_deg": np.zeros(4)})
    with pytest.raises(FitError, match="state the latitude"):
        find_north(tilted, Conditions())


def test_what_cannot_be_done_is_refused_in_words():
    run = run_of_headings(QUARTERS, felt(QUARTERS, 40.0, 50.45, 1.0), "deg/h", se=np.full(4, 0.01))
    for pole in (90.0, -90.0, 89.8):
        with pytest.raises(FitError, match="at a pole a gyro finds no heading"):
            find_north(run, Conditions(latitude_deg=pole))
    with pytest.raises(FitError, match="does not exist"):
        find_north(run, Conditions(latitude_deg=120.0))
    opposite = run.rows([0, 2, 0, 2])
    with pytest.raises(RankDeficient, match="steps of 90 degrees"):
        find_north(opposite, KYIV)
    loud = replace(run, y_se=np.full((4, 1), 20.0))
    with pytest.raises(FitError, match=r"north cannot be told from noise"):
        find_north(loud, KYIV)
    bare = run.rows([0, 1, 2])
    with pytest.raises(FitError, match="leave no uncertainty"):
        find_north(replace(bare, y_se=np.full((3, 1), np.nan)), KYIV)


@pytest.mark.slow
@pytest.mark.parametrize("known", [True, False])
def test_intervals_hold_the_truth(known: bool):
    rng = np.random.default_rng(12)
    headings = np.tile(QUARTERS, 2)
    trials, noise, hits = 1000, 0.3, np.zeros(2)
    for _ in range(trials):
        rates = felt(headings, 359.5, 50.45, -0.8) + noise * rng.standard_normal(8)
        se = np.full(8, noise) if known else None
        found = find_north(run_of_headings(headings, rates, "deg/h", se=se), KYIV)
        away = (359.5 - found.heading.value + 180.0) % 360.0 - 180.0
        low, high = (
            limit - found.heading.value for limit in (found.heading.low, found.heading.high)
        )
        hits += [low < away < high, abs(found.drift.value + 0.8) < found.drift.expanded()]
    assert np.all((hits / trials > 0.93) & (hits / trials < 0.97))
