"""Aliases that have no columns of their own; how much data must speak for a relabelling."""

import numpy as np

from core.discrepancy.ladder import Ladder
from core.discrepancy.sets import aliases, rivals_of
from core.discrepancy.settings import Settings
from tests.core.discrepancy.hidden import ARCSEC, head_run

QUICK = Settings(advise=False)
CARDINAL = [
    (run, mount, angle)
    for run in (1, 2, 3)
    for mount in ("X_from", "X_to", "Y_from")
    for angle in (0.0, 90.0, 180.0, 270.0)
]
FINE = [
    (run, mount, angle)
    for run in (1, 2)
    for mount in ("X_from", "X_to", "Y_from")
    for angle in np.arange(0.0, 360.0, 15.0)
]


def eccentric(rows) -> tuple[str, ...]:
    hidden = lambda q: 60.0 * ARCSEC * np.cos(np.radians(q.head)) * q.slope  # noqa: E731
    ladder = Ladder.of(head_run(hidden, rows, seed=5), QUICK).with_effect("head_eccentricity")
    return aliases(ladder.engine, ladder.state, 0)


def test_a_fast_error_of_the_dial_folds_onto_the_slow_ones_at_four_angles():
    assert "head_periodic_error" in eccentric(CARDINAL)
    assert "head_periodic_error" not in eccentric(FINE)


def test_a_name_tied_with_the_slow_error_of_a_dial_is_tied_with_the_fast_one_too():
    ladder = Ladder.of(head_run(lambda q: 4e-4 * q.a[:, 2] ** 2, CARDINAL, seed=5), QUICK).found()
    names = rivals_of(ladder.engine, ladder.state, 0).names
    assert ladder.slots[0].name == "second_order_nonlinearity"
    assert {"head_eccentricity", "head_periodic_error"} <= set(names)


def test_a_relabelling_needs_a_hundred_to_one_whatever_the_threshold_of_the_plan():
    engine = Ladder.of(head_run(rows=CARDINAL), QUICK).engine
    search = engine.search
    assert {"mount_reversed", "positions_swapped"} <= set(search.relabels.all_names)
    found = search.scores(search.state(()))
    for name in search.relabels.all_names:
        asked = found[name].evidence - found[name].margin + search.threshold
        assert asked >= np.log(100.0) - 1e-9
