"""Sets of names for records: pairs that nearly cancel, what is tied, what a curve could be."""

from functools import cache

import numpy as np
import pytest

from core.discrepancy.bank import Bank
from core.discrepancy.engine import under
from core.discrepancy.record_engine import record_regressors
from core.discrepancy.record_floor import usual_floor
from core.discrepancy.record_problem import Samples, record_problem
from core.discrepancy.record_refined import (
    NameSet,
    alone,
    is_needed,
    own_evidence,
    refined,
)
from core.discrepancy.record_search import ended, likeliest
from core.discrepancy.record_sets import tied_names
from core.discrepancy.record_shapes import Shapes
from core.discrepancy.settings import Settings
from tests.core.discrepancy.recorded import NOTHING, Hidden, hour_run


def lagged(values: np.ndarray, tau: float) -> np.ndarray:
    found = values.copy()
    for i in range(1, len(found)):
        found[i] = found[i - 1] + (values[i] - found[i - 1]) / tau
    return found


def cancelling(hour) -> np.ndarray:
    """Two that go with the temperature, each large, together small."""
    return 5e-4 * (hour.temperature - lagged(hour.temperature, 300.0))


def wave(hour) -> np.ndarray:
    return 4e-4 * np.sin(2.0 * np.pi * 1.7 * hour.t / 3600.0)


def shapes_of(hidden: Hidden, seed: int) -> Shapes:
    problem = record_problem(Samples.of(hour_run(hidden, seed=seed)))
    floor = usual_floor(problem)
    regressors = record_regressors(problem, np.sqrt(np.diag(floor.covariance)))
    engine = under(problem, Settings(), Bank.of(problem), floor, regressors)
    return Shapes(engine.search, {})


@cache
def found(hidden: Hidden, seed: int) -> tuple[Shapes, tuple[NameSet, ...]]:
    shapes = shapes_of(hidden, seed)
    return shapes, tuple(likeliest(shapes))


def test_two_that_nearly_cancel_are_found_together():
    shapes, sets = found(cancelling, 5)
    pair = next(one for one in sets if one.names == ("bias_temperature", "thermal_lag"))
    singly = [alone(shapes, slot, shapes.state(())) for slot in pair.state.slots]
    together = pair.worth + 2.0 * shapes.search.threshold
    assert together > max(singly) + 20.0
    assert pair.worth > sets[0].worth - 3.0
    lag = next(slot for slot in pair.state.slots if slot.name == "thermal_lag")
    ((_, tau),) = lag.instance.effect.shape
    assert 100.0 < tau < 700.0


def test_every_name_of_a_kept_set_stands_out_beside_the_others():
    shapes, sets = found(cancelling, 5)
    for one in sets:
        assert is_needed(shapes, one)
        assert len(set(one.names) - {"bias_jump", "pickup"}) == len(
            [name for name in one.names if name not in ("bias_jump", "pickup")]
        )


def test_nothing_hidden_leaves_the_empty_set():
    _, sets = found(NOTHING, 6)
    assert sets[0].names == ()
    assert sets[0].worth == 0.0


def test_refining_never_makes_a_set_worse_and_comes_to_the_true_time_constant():
    hidden = lambda h: 1.2e-4 * lagged(h.temperature, 400.0)  # noqa: E731
    shapes = shapes_of(hidden, 7)
    bank = shapes.search.bank.bank
    lags = [one.effect for one in bank.instances if one.effect.id == "thermal_lag"]
    begun = (shapes.made(lags[0]),)
    one = refined(shapes, begun)
    plain = shapes.state(())
    assert shapes.gain(one.state.slots[0], plain) >= shapes.gain(begun[0], plain)
    ((_, tau),) = one.state.slots[0].instance.effect.shape
    assert tau == pytest.approx(400.0, rel=0.35)
    # The name is averaged over its time constants, which can only cost.
    slot = one.state.slots[0]
    assert own_evidence(shapes, slot, plain) < alone(shapes, slot, plain)


def test_a_slow_wave_ends_with_unknown_structure_though_four_names_imitate_it():
    shapes, sets = found(wave, 8)
    best, unknown, doubtful = ended(shapes.search, list(sets))
    assert unknown is not None
    assert (best.names, doubtful) == ((), ())
    assert len(sets[0].names) > 2


def test_what_explains_as_much_in_the_place_of_a_slot_is_tied_with_it():
    shapes, sets = found(cancelling, 5)
    pair = next(one for one in sets if one.names == ("bias_temperature", "thermal_lag"))
    worse = [one for one in sets if one.worth < pair.worth - 10.0]
    tied = tied_names(shapes, pair.state, worse)
    assert len(tied) == 2
    for slot, names in zip(pair.state.slots, tied, strict=True):
        assert slot.name not in names
        assert "bias_jump" not in names
    # Another set that is as good: what it has instead is tied with what it has not.
    other = next(one for one in sets if one.names == ("bias_temperature", "temperature_rate"))
    as_good = tied_names(shapes, pair.state, [NameSet(other.state, pair.worth)])
    by_name = dict(zip((slot.name for slot in pair.state.slots), as_good, strict=True))
    assert by_name == {"bias_temperature": (), "thermal_lag": ("temperature_rate",)}


def test_columns_of_two_degrees_of_one_curve_are_not_taken_for_each_other():
    shapes = shapes_of(NOTHING, 6)
    curves = [
        one.effect
        for one in shapes.search.bank.bank.instances
        if one.effect.id == "bias_temperature"
    ]
    assert [shapes.made(one).raw.shape[1] for one in curves] == [1, 2]
    assert shapes.rest(shapes.made(curves[1])).shape[1] == 2
