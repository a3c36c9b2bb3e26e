"""What was found, weighed against what stands in no catalogue."""

import numpy as np

from core.discrepancy.engine import Engine
from core.discrepancy.search import Scored
from core.discrepancy.slots import Slot, State
from core.discrepancy.two_levels import SURE, two_levels

_SHARE = 0.65
"""Part of the evidence of several names that one unknown curve must reach to be their rival."""

_AHEAD = 3.0
"""Nats by which two levels must lead names to replace them; with less of a lead they are rivals."""


def weighed(engine: Engine, forced: tuple[Slot, ...]) -> tuple[State, Scored | None, bool]:
    """The best set of names, unknown structure at its end, and whether one curve does as much.

    Two or three names can imitate a curve that the catalogue does not know; it does more than any
    one name then. A larger drift, a jump or an offset imitate a bias that goes to and fro.
    """
    search = engine.search
    state, unknown = engine.found(forced)
    plain, found = search.state(forced), state.slots[len(forced) :]
    levels = two_levels(engine, plain, found)
    imitated = False
    if levels is not None and levels.evidence > SURE and unknown is None:
        if levels.evidence > levels.named + _AHEAD:
            return plain, _scored(engine, levels.evidence, levels.path), False
        beside = two_levels(engine, state)
        if beside is not None and beside.evidence > SURE:
            unknown = _scored(engine, beside.evidence, beside.path)
        imitated = levels.evidence > levels.named
    if len(found) > 1:
        curve = search.unknown(plain).evidence
        one = max(score.evidence for score in search.scores(plain).values())
        more = curve > one and curve > _SHARE * search.together(found, plain)
        imitated = imitated or more
    return state, unknown, imitated


def _scored(engine: Engine, evidence: float, path: np.ndarray) -> Scored:
    timely = next(i for i, one in enumerate(engine.regressors) if one.name in ("t_s", "order"))
    return Scored(evidence, evidence, None, timely, path)
