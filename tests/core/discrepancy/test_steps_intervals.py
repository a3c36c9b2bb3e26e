"""Whether the interval of a parameter covers the truth, after its effect was searched for."""

import numpy as np
import pytest

from core.discrepancy.ladder import Ladder
from core.discrepancy.steps import fit_slots
from tests.core.discrepancy.hidden import APART, FORTY_EIGHT, WHITE, head_run

K2, JUMP = 2.5e-4, 6.0 * WHITE
RUNS = 24


def scores(name: str, hidden, rows, true_mg: float) -> list[float]:
    """(estimate - truth) / u of each run in which the effect is named."""
    found: list[float] = []
    for seed in range(RUNS):
        ladder = Ladder.of(head_run(hidden, rows, 500 + seed)).found()
        if [slot.name for slot in ladder.slots] == [name]:
            first = fit_slots(ladder.engine, ladder.state)[0].parameters[0]
            found.append((first.value - true_mg) / first.u)
    return found


@pytest.mark.slow
def test_the_interval_of_a_named_effect_covers_the_truth_as_often_as_it_says():
    z = np.array(
        [
            *scores("second_order_nonlinearity", lambda q: K2 * q.a[:, 2] ** 2, APART, 1e3 * K2),
            *scores("bias_jump", lambda q: JUMP * (q.t > 2000.0), FORTY_EIGHT, 1e3 * JUMP),
        ]
    )
    assert len(z) > 1.4 * RUNS
    # Of 34 intervals of 95 % fewer than 29 hold the truth once in a hundred times.
    assert np.mean(np.abs(z) < 1.96) >= 0.85
    assert 0.6 < np.sqrt(np.mean(z**2)) < 1.35
