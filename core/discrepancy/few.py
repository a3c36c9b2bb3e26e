"""Fewer rows than any noise could be found from: only what is far beyond all noise counts."""

from dataclasses import replace

import numpy as np

from core.discrepancy.bank import Bank
from core.discrepancy.engine import Engine, calibrated, under
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.settings import Settings
from core.model.catalogue.terms import small_gain

_SIGMAS = 6.0
_USUAL = {"accelerometer": 1.0, "gyro": 0.1}
"""Scatter that no sound sensor exceeds where none is stated, mg or deg/s."""


def striking(problem: Problem, settings: Settings) -> Engine | None:
    """The engine of a run whose few spare rows contradict the model beyond any noise.

    One or two degrees of freedom tell that something is missing, never what: every effect that
    these rows can show explains them.

    Returns
    -------
    Engine or None
        None where what is left could be noise.
    """
    stated = bool(np.all(np.isfinite(problem.se)))
    if not stated:
        if not all(model.sensor.response for model in problem.models):
            return None  # a gyro at rest has told no scale factor that would say what is usual
        size = [abs(small_gain(m.sensor)) * _USUAL[m.sensor.kind] for m in problem.models]
        problem = replace(problem, se=np.repeat(size, problem.rows))
    floor = Floor.stated(problem, settings)
    if not stated:
        floor = replace(floor, source="residual")
    engine = under(problem, settings, Bank.of(problem), floor)
    left = engine.search.state(()).rss
    return calibrated(engine) if left > _SIGMAS**2 else None
