"""The Accuracy tab's part of the demonstration: a full turn of roll, judged."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.fit.quantiles import student_t
from core.procedures.accuracy import INTER
from core.procedures.angle_errors import ROLL
from drivers.virtual.compass import OWN_ERROR_DEG
from drivers.virtual.truth import Compared
from gui.accuracy.tab import AccuracyTab
from gui.measuring.demonstrating import Stage, Told, process, walk

TITLE = "Accuracy"
_ACCUMULATION_S = 5.0
_SPEED = 8
"""Of the rig: slow enough for its operator to be in time where the computer is busy."""
_SETTLE_S = 6.0
"""Longer than the operator of the rig looks at the dial before the last degrees."""


def play(stage: Stage) -> Told:
    """Measure the roll of the attitude unit, and put its error beside the truth."""
    stage.connect("pointer", speed=_SPEED)
    tab = stage.show(TITLE)
    if not isinstance(tab, AccuracyTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    stage.until(lambda: tab.sitting.walk.status is not None, "the rig did not answer")
    tab.presenter.set_plan("roll_accuracy")
    times = {"accumulation_s": _ACCUMULATION_S, "settle_s": _SETTLE_S}
    tab.presenter.set_settings(replace(tab.sitting.settings, **times))
    session = walk(stage, tab, "accuracy-measuring")
    stage.until(lambda: not tab.results.busy, "the angles were not judged")
    process(stage, tab, "accuracy-roll", ("csv",))
    return Told(TITLE, (_own_roll(tab),), Path(session))


def _own_roll(tab: AccuracyTab) -> Compared:
    """The mean error of the unit's own roll beside what its electronics add."""
    state = tab.results.state
    if state is None:
        raise RuntimeError("the results were closed")
    trace = state.found.trace(INTER)
    # Resolution and the setting of the head are alike in all rows as far as is known.
    half = student_t(0.95, float("inf")) * float(np.sqrt(np.mean(trace.u_error**2)))
    error, truth = float(np.mean(trace.error)), OWN_ERROR_DEG[ROLL]
    return Compared("Inter", "Δγ", "deg", error, half, truth, abs(error - truth) <= half)
