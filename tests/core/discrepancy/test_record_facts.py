"""Faults of the data: each is found where it is, and nowhere else."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.record_facts import departures, facts_of, loudest
from core.discrepancy.record_problem import Samples
from core.samples.run import Run
from tests.core.discrepancy.recorded import WHITE, hour_run


def changed(run: Run, change: Callable[[np.ndarray], None]) -> Run:
    y = np.array(run.y)
    change(y[:, 0])
    return replace(run, y=y)


def stuck(y: np.ndarray) -> None:
    y[1000:1012] = y[1000]


def bumped(y: np.ndarray) -> None:
    y[2000] += 14.0 * WHITE


def shaken(y: np.ndarray) -> None:
    y[1500:1800] += 3.0 * WHITE * np.random.default_rng(1).standard_normal(300)


def clipped(y: np.ndarray) -> None:
    np.minimum(y, np.quantile(y, 0.97), out=y)


def combed(y: np.ndarray) -> None:
    code = np.rint(y / 4e-5).astype(int)
    code[code % 4 == 0] += 1
    y[:] = code * 4e-5


@pytest.mark.parametrize("seed", range(6))
def test_sound_records_are_accused_of_nothing(seed: int):
    assert facts_of(Samples.of(hour_run(seed=seed))) == ()


@pytest.mark.parametrize(
    ("fault", "name"),
    [
        (stuck, "stuck_reading"),
        (bumped, "outlier"),
        (shaken, "variance_burst"),
        (clipped, "clipping"),
        (combed, "missing_codes"),
    ],
)
def test_a_fault_is_named_alone(fault: Callable[[np.ndarray], None], name: str):
    found = facts_of(Samples.of(changed(hour_run(seed=3), fault)))
    assert [fact.effect for fact in found] == [name]
    assert found[0].chance <= 1e-5


def test_the_place_of_a_fault_is_told():
    run = hour_run(seed=4)
    (outlier,) = facts_of(Samples.of(changed(run, bumped)))
    assert outlier.rows.tolist() == [2000]
    (held,) = facts_of(Samples.of(changed(run, stuck)))
    assert held.rows.tolist() == list(range(1001, 1012))
    (burst,) = facts_of(Samples.of(changed(run, shaken)))
    assert np.mean((burst.rows >= 1450) & (burst.rows < 1850)) > 0.85


def test_samples_that_never_came_are_counted():
    run = hour_run(seed=5)
    there = np.ones(len(run), dtype=bool)
    there[500:540] = there[2500:2507] = False
    (lost,) = facts_of(Samples.of(run.rows(np.flatnonzero(there))))
    assert lost.effect == "dropouts"
    numbers = {each.name: each.value for each in lost.parameters}
    assert numbers == {"lost": 47.0, "gaps": 2.0, "longest": 40.0, "first": 499.0}


def test_a_temperature_that_stands_still_is_stale_but_a_coarse_one_is_not():
    run = hour_run(seed=6)
    held = replace(run, temperature_c=np.full(len(run), 24.137))
    assert [fact.effect for fact in facts_of(Samples.of(held))] == ["stale_temperature"]
    for coarse in (24.0, 24.5, 24.0625):
        calm = replace(run, temperature_c=np.full(len(run), coarse))
        assert facts_of(Samples.of(calm)) == ()
    frozen_late = np.array(run.temperature_c)
    frozen_late[1800:] = frozen_late[1800]
    late = replace(run, temperature_c=frozen_late)
    assert [fact.effect for fact in facts_of(Samples.of(late))] == ["stale_temperature"]


def test_departures_are_in_units_of_the_noise_also_where_the_record_climbs():
    run = hour_run(lambda hour: 5e-6 * hour.t, seed=7)
    rest = departures(Samples.of(run))
    assert np.std(rest) == pytest.approx(1.0, abs=0.06)
    assert np.max(np.abs(rest)) < 5.0


def test_the_loudest_window_of_sound_noise_stays_below_its_limit():
    """Seven robust deviations alone are exceeded once in some thousand windowings."""
    rng = np.random.default_rng(5)
    beyond = [0, 0]
    for _ in range(3000):
        means = np.mean(rng.standard_normal((112, 32)) ** 2, axis=1)
        middle = np.median(means)
        spread = 1.4826 * np.median(np.abs(means - middle))
        beyond[0] += means.max() > middle + 7.0 * spread
        beyond[1] += means.max() > loudest(32, 112) * middle
    assert beyond[0] >= 1
    assert beyond[1] == 0
    # scipy.stats.chi2.isf(1e-5 / 112, 32) / 32 = 2.888; the approximation is good to a per cent.
    assert loudest(32, 112) == pytest.approx(2.888, rel=0.01)
