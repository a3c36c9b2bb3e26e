"""What is tied, how further rows would come out, and rows that are chosen for it."""

from dataclasses import replace

import numpy as np
import pytest

from core.discrepancy.advise import advise, next_of
from core.discrepancy.followups import everywhere, followups_of, where_they_differ
from core.discrepancy.ladder import Ladder
from core.discrepancy.outcomes import Outlook
from core.discrepancy.rivals import Tie, ties_of
from core.discrepancy.sets import aliases
from core.discrepancy.tailored import Pool
from core.plans.orientation import Mount
from tests.core.discrepancy.hidden import FORTY_EIGHT, K, felt, head_run

ONE = [(run, "X_from", angle) for run in (1, 2) for angle in np.arange(0.0, 360.0, 15.0)]
FOUR = [(1, mount, 90.0 * step) for mount in ("X_from", "Y_from") for step in range(4)]


@pytest.fixture(scope="module")
def cubic() -> Ladder:
    """One setup, twice round: a third power that could be an odd square as well."""
    return Ladder.of(head_run(lambda q: 3.5e-4 * q.a[:, 2] ** 3, ONE, 2)).found()


def only_tie(ladder: Ladder) -> Tie:
    (tie,) = ties_of(ladder.engine, ladder.state)
    return tie


def spotted() -> Ladder:
    """One bad row: an outlier or a wrong angle."""

    def hidden(q):
        return 6e-4 * (np.arange(len(q.t)) == 20)

    return Ladder.of(head_run(hidden, ONE, 4)).with_effect("outlier")


def test_rivals_are_the_names_of_the_set_with_what_may_come_up_beside_them(cubic: Ladder):
    tie = only_tie(cubic)
    names = {member.name for member in tie.members}
    assert names >= {"third_order_nonlinearity", "odd_quadratic_nonlinearity"}
    near = {one.effect.id for one in tie.near}
    assert near >= names | {"second_order_nonlinearity", "head_periodic_error"}
    assert "bias_jump" not in near
    assert set(tie.share) == near
    assert max(tie.share.values()) == 0.0
    assert only_tie(spotted()).share["outlier"] == pytest.approx(np.log(16 / 48))
    assert tie.others == ()


def test_a_fast_error_of_the_dial_stands_as_a_rival_where_it_folds_onto_a_slow_one():
    """At four angles the third and the fifth harmonic are the first; sixteen tell them apart."""
    rng = np.random.default_rng(3)
    wrong = {angle: 60.0 * np.sin(np.radians(angle) - 1.0) / 3600.0 for _, _, angle in FOUR}
    a = np.array([felt(mount, angle + wrong[angle]) for _, mount, angle in FOUR])
    y = K * (a + 25e-6 * rng.standard_normal((len(FOUR), 3)))
    se = np.full((len(FOUR), 3), K * 25e-6)
    axes = ("x", "y", "z")
    run = replace(head_run(rows=FOUR), y=y, y_se=se, channels=axes, axes=axes)
    ladder = Ladder.of(run).with_effect("head_eccentricity")
    tie = only_tie(ladder)
    fast = [member for member in tie.members if member.name == "head_periodic_error"]
    orders = [value for member in fast for _, value in member.slots[-1].instance.effect.shape]
    assert orders == [3.0, 5.0, 7.0]
    chances = {
        each.title: Outlook.of(ladder.engine, each.run).chance(tie) for each in followups_of(run)
    }
    assert chances["All mountings, mixed"] > 0.95
    assert chances["All mountings, mixed"] > chances["Back to the first mounting"] + 0.1


def test_the_square_of_the_own_axis_is_no_cross_axis_of_another_output_of_a_triad():
    """Else no plan could ever tell the two names apart."""
    a = np.array([felt(mount, angle) for _, mount, angle in FORTY_EIGHT])
    noise = 25e-6 * np.random.default_rng(6).standard_normal(a.shape)
    y = K * (a + noise + 4e-4 * np.column_stack([0.0 * a[:, 0], a[:, 1] ** 2, 0.0 * a[:, 2]]))
    axes = ("x", "y", "z")
    base = head_run(rows=FORTY_EIGHT)
    run = replace(base, y=y, y_se=np.full(y.shape, K * 25e-6), channels=axes, axes=axes)
    ladder = Ladder.of(run).with_effect("second_order_nonlinearity")
    assert "cross_axis_nonlinearity" not in aliases(ladder.engine, ladder.state, 0)


def test_more_and_better_rows_raise_the_chance_and_the_same_again_hardly_does(cubic: Ladder):
    tie, engine = only_tie(cubic), cubic.engine
    chance = {
        each.title: Outlook.of(engine, each.run).chance(tie)
        for each in followups_of(engine.problem.run)
    }
    assert chance["All mountings twice, twice as dense"] > 0.8
    assert chance["All mountings twice, twice as dense"] > chance["Reversed sweep"] + 0.3
    assert all(0.0 <= one <= 1.0 for one in chance.values())


def test_noise_of_new_rows_goes_on_from_that_of_the_old_ones(cubic: Ladder):
    engine = cubic.engine
    outlook = Outlook.of(engine, followups_of(engine.problem.run)[0].run)
    old = outlook.old
    both = outlook.covariance
    assert np.allclose(outlook.follows @ both[np.ix_(old, old)], both[np.ix_(~old, old)])
    again = outlook.follows @ both[np.ix_(old, ~old)] + outlook.fresh @ outlook.fresh.T
    assert np.allclose(again, both[np.ix_(~old, ~old)], rtol=1e-6)


def test_rows_whose_scatter_is_not_stated_are_foretold_with_that_of_the_floor():
    """The new rows have no outputs from which it could be guessed."""
    run = head_run(lambda q: 3.5e-4 * q.a[:, 2] ** 3, ONE, 2)
    run = replace(run, y_se=np.full(run.y_se.shape, np.nan))
    engine = Ladder.of(run).engine
    outlook = Outlook.of(engine, followups_of(engine.problem.run)[0].run)
    now = np.sqrt(np.diag(engine.floor.covariance))
    then = np.sqrt(np.diag(outlook.covariance))[: len(run)]
    assert then == pytest.approx(now, rel=0.05)


def test_rows_are_chosen_where_rivals_differ_most(cubic: Ladder):
    """As many evenly spread rows leave the pair nearer together."""
    engine, tie = cubic.engine, only_tie(cubic)
    run = engine.problem.run
    places, longer = everywhere(run)
    assert len(set(places)) == len(places) == len(longer) - len(run)
    pool = Pool.of(engine, longer, places, (tie,))
    series = list(pool.chosen((24, 48)))
    assert len(series[0][0]) in range(18, 25)
    assert len(series[1][0]) == 48
    assert set(series[0][0]) < set(series[1][0])
    assert series[0][1] < series[1][1]
    follow = where_they_differ(run, series[1][0])
    even = next(each for each in followups_of(run) if each.title == "All mountings twice, mixed")
    assert len(follow.plan.steps) == 96 < len(even.plan.steps)
    chosen, spread = (Outlook.of(engine, each.run).chance(tie) for each in (follow, even))
    assert chosen > spread


def test_chosen_rows_are_sorted_by_mounting_and_mixed_within_it(cubic: Ladder):
    run = cubic.engine.problem.run
    places = everywhere(run)[0]
    follow = where_they_differ(run, places[:12] + places[72:84])
    mounts = [step.mount for step in follow.plan.steps]
    assert mounts == sorted(mounts, key=mounts.index)
    assert all(Mount.parse(mount) for mount in mounts)
    angles = [step.head_deg for step in follow.plan.steps][:24]
    assert angles != sorted(angles)
    assert sorted(angles[:12]) == sorted(angles[12:]) == [angle for _, angle in places[:12]]
    assert angles[:12] != angles[12:]
    assert follow.title == "Where they differ most, 48 positions"
    assert follow.minutes == pytest.approx(48 * 0.5 + 2 * 8.0)


def test_a_mounting_for_a_few_rows_is_left_out():
    steady = np.zeros(10)
    places = (*(("X_to", float(i)) for i in range(8)), ("Z_from", 0.0), ("Z_from", 5.0))
    shown = np.concatenate([steady[:4], np.arange(10.0) + 1.0])
    other = np.ones((14, 1))
    pool = Pool(old=4, places=places, pairs=((shown, other),), channels=1)
    ((some, distance),) = pool.chosen((24,))
    assert {mount for mount, _ in some} == {"X_to"}
    assert distance > 0.0


def test_the_shortest_of_the_best_comes_first_and_what_cannot_decide_is_not_shown(cubic: Ladder):
    tie = only_tie(cubic)
    usual = sorted(followups_of(cubic.engine.problem.run), key=lambda each: each.minutes)
    looked: list[str] = []

    def judged(follow, chance):
        def of(_tie):
            looked.append(follow.title)
            return chance

        return of

    chances = (0.01, 0.5, 0.96, 0.97, 0.99, 0.2)
    pairs = zip(usual, chances, strict=False)
    found = next_of((tie,), ((each, judged(each, chance)) for each, chance in pairs))
    assert [each.probability for each in found] == [0.99, 0.97, 0.96]
    assert looked == [each.title for each in usual[:5]]


def test_advice_of_a_hard_tie_is_a_series_chosen_for_it(cubic: Ladder):
    found = advise(cubic.engine, cubic.state)
    assert found[0].title.startswith("Where they differ most")
    assert found[0].probability > 0.8
    assert found[0].why.startswith("angles at which the tied effects read most differently")
    assert len({step.mount for step in found[0].plan.steps}) <= 4
