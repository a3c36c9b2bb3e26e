"""What record to make next where names are tied; lines that are no sines."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.bank import Bank, Instance
from core.discrepancy.engine import under
from core.discrepancy.ladder import explain
from core.discrepancy.record import explain_record
from core.discrepancy.record_doubts import (
    has_harmonics,
    moves_between,
    of_no_channel,
    seldom_or_regular,
    there_and_back,
)
from core.discrepancy.record_engine import search_record
from core.discrepancy.record_floor import usual_floor
from core.discrepancy.record_followups import follow_records
from core.discrepancy.record_problem import Samples, record_problem
from core.discrepancy.record_telegraph import telegraph_of
from core.discrepancy.settings import Settings
from core.discrepancy.slots import Slot, State
from core.discrepancy.to_json import explanation_to_json
from core.model.catalogue.record import Telegraph
from core.model.catalogue.timeline import BiasDrift, BiasJump
from core.model.effect import Effect
from tests.core.discrepancy.recorded import hour_run


def settling(hour) -> np.ndarray:
    return 4e-4 * np.exp(-hour.t / 1800.0)


def test_every_further_record_has_its_own_course_of_temperature_and_channels():
    problem = record_problem(Samples.of(hour_run(seed=1)))
    found = {each.title: each for each in follow_records(problem)}
    assert len(found) == 6
    now = float(problem.stimulus.column("temperature_c")[-1])
    for each in found.values():
        columns = each.stimulus.columns
        assert int(each.measured.sum()) == problem.rows
        assert all(len(column) == len(each.measured) for column in columns.values())
        assert set(problem.stimulus.columns) <= set(columns)
        assert each.plan.test == "record"
        idle = each.plan.settle_s / 60.0
        assert each.minutes == pytest.approx(each.plan.accumulation_s / 60.0 + idle)
    ramp = found["Temperature up and down by 20 degC at 1 degC/min"]
    warm, t = ramp.stimulus.column("temperature_c"), ramp.stimulus.column("t_s")
    assert warm.max() == pytest.approx(now + 20.0, abs=0.01)
    assert np.max(np.abs(np.diff(warm) / np.diff(t))) == pytest.approx(1.0 / 60.0, rel=0.01)
    assert ramp.minutes == pytest.approx(80.0)
    assert ramp.plan.temperatures_c == (round(now + 20.0, 1), round(now, 1))
    # What is switched off begins again, what stays on goes on.
    assert found["Restart from cold"].stimulus.column("t_s")[0] < 20.0
    assert found["Another record right behind this one"].stimulus.column("t_s")[0] > 3580.0


def test_a_tie_of_a_settling_and_a_drift_is_broken_by_going_on_and_the_advice_comes_true():
    """One record cannot tell them; a second one right behind has the drift or has it not."""
    story = explain(hour_run(settling, seed=3))
    (step,) = [s for s in story.steps if s.effect in ("warm_up", "bias_drift")]
    assert {step.effect, *step.indistinguishable_from} >= {"warm_up", "bias_drift"}
    best = story.next_measurements[0]
    assert best.title == "Another record right behind this one"
    assert "tells apart bias_drift, warm_up" in best.why
    assert best.probability > 0.9
    document = explanation_to_json(story)["next_measurements"][0]
    assert document["plan"]["test"] == "record"
    assert document["plan"]["steps"] == [{"group": "as before, 60 min"}]
    assert document["plan"]["temperatures_c"] == []
    # Played: of the settling little is left in the second hour, of a drift all would be.
    behind = explain_record(hour_run(lambda h: 4e-4 * np.exp(-(h.t + 3600.0) / 1800.0), seed=4))
    fall = (1.0 - np.exp(-2.0)) * 4e-4
    slopes = [p for s in behind.steps if s.effect == "bias_drift" for p in s.parameters[:1]]
    assert all(abs(p.value + fall) > 5.0 * p.u for p in slopes)


def test_where_nothing_is_tied_no_record_is_advised_and_jumps_there_and_back_are_a_telegraph():
    story = explain_record(hour_run(lambda h: 2.5e-4 * (h.t > 1400.0), seed=11))
    jump = story.steps[0]
    assert jump.indistinguishable_from == ()
    assert story.next_measurements == ()
    size = jump.parameters[0]
    for value, tied in ((-size.value, ("telegraph",)), (-2.0 * size.value, ())):
        other = replace(jump, parameters=(replace(size, value=value), *jump.parameters[1:]))
        assert [s.indistinguishable_from for s in there_and_back([jump, other])] == [tied, tied]


@pytest.mark.parametrize(("form", "doubtful"), [("sine", False), ("sawtooth", True)])
def test_a_line_with_harmonics_is_not_surely_a_pickup(form: str, doubtful: bool):
    cycles = 5.6

    def hidden(hour) -> np.ndarray:
        turn = cycles * hour.t / 3600.0
        return 1.6e-4 * (np.sin(2.0 * np.pi * turn) if form == "sine" else 1.9 * (turn % 1.0))

    engine = search_record(Samples.of(hour_run(hidden, seed=5)), Settings()).engine
    plain = engine.search.state(())
    line = engine.search.scores(plain)["pickup"].slot
    assert line is not None
    named = engine.search.state((engine.search.polished(line, plain),))
    assert named.slots[0].instance.effect.shape[0][1] == pytest.approx(cycles, abs=0.1)
    assert has_harmonics(engine, named) == doubtful
    assert not has_harmonics(engine, plain)


@pytest.mark.parametrize("form", ["levels", "wave"])
def test_between_the_jumps_of_a_telegraph_the_bias_stands_still(form: str):
    at = (300.0, 700.0, 1150.0, 1500.0, 2000.0, 2250.0, 2800.0, 3200.0)

    def hidden(hour) -> np.ndarray:
        level = np.sum([hour.t >= one for one in at], axis=0) % 2 - 0.5
        edges = np.array([0.0, *at, 3600.0])
        turn = np.interp(hour.t, edges, np.arange(len(edges)))
        wave = -0.5 * np.pi * np.sin(np.pi * turn) / 2.0
        return 3e-4 * (level if form == "levels" else wave)

    problem = record_problem(Samples.of(hour_run(hidden, seed=7)))
    paths = telegraph_of(problem, [problem.y - problem.y.mean()])
    assert paths is not None
    problem = replace(problem, effects=(*problem.effects, paths))
    engine = under(problem, Settings(), Bank.of(problem), usual_floor(problem))
    path = engine.search.scores(engine.search.state(()))["telegraph"].slot
    assert path is not None
    assert moves_between(engine, engine.search.state((path,))) == (form == "wave")
    assert not moves_between(engine, engine.search.state(()))


def made_of(*effects: Effect) -> State:
    none = np.zeros((0, 1))
    slots = tuple(Slot(one.id, Instance(one, 0), none, none[:, 0]) for one in effects)
    return State(slots, none, none[:, 0], 0.0)


@pytest.mark.parametrize(
    ("rows", "doubtful"),
    [
        ((120, 160), True),  # one visit is anything that passes
        ((40, 55, 130, 141, 260, 300), False),
        ((40, 80, 118, 157, 199, 240, 281), True),  # as regular as something that turns
        ((40, 110, 170, 222, 266, 304, 336), True),  # faster and faster
    ],
)
def test_a_telegraph_changes_often_and_at_random(rows: tuple[int, ...], doubtful: bool):
    assert seldom_or_regular(made_of(Telegraph((rows,), (0.0,)))) == doubtful
    assert not seldom_or_regular(made_of(BiasJump(100)))


def test_several_names_that_follow_no_channel_can_draw_any_curve():
    drift, jump, path = BiasDrift(), BiasJump(100), Telegraph(((40, 55, 130),), (0.0,))
    assert of_no_channel(made_of(drift, jump)) == ()
    assert of_no_channel(made_of(drift, jump, path)) == ("bias_jump", "telegraph")
    assert of_no_channel(made_of(drift, jump, BiasJump(200))) == ("bias_jump", "bias_drift")
