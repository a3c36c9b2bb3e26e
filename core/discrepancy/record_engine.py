"""The search on the slow view of a long record."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Bank
from core.discrepancy.components import times
from core.discrepancy.curves import Regressor, bumps, powers, waves
from core.discrepancy.engine import Engine, calibrated, under
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.record_floor import record_floor, usual_floor
from core.discrepancy.record_problem import Samples, record_problem
from core.discrepancy.record_telegraph import telegraph_of
from core.discrepancy.reml import prior_of
from core.discrepancy.search import Scored
from core.discrepancy.settings import Settings
from core.discrepancy.slots import State

_UNITS = {
    "t_s": "s",
    "temperature_c": "degC",
    "AntiNodePeriod": "us",
    "ExcitationDelay": "us",
    "AntiNodeAmplitude": "V",
    "ExcitationAmpl": "V",
    "QuadratureAmpl": "V",
}
_HIGHEST = 5
_LOUD = 10.0
_PART, _PLAIN = 0.5, 10.0


def record_regressors(problem: Problem, sigma: FloatArray) -> tuple[Regressor, ...]:
    """Time, temperature and every channel.

    Parameters
    ----------
    sigma : (n,) standard deviation of the noise of each row
    """
    found: list[Regressor] = []
    t = times(problem)
    found += [
        Regressor("t_s", "s", t, basis * sigma[:, None], competes=True)
        for basis in (waves(t), bumps(t))
    ]
    for name, values in problem.stimulus.columns.items():
        if name in ("t_s", "mount", "run"):
            continue
        basis = powers(values, _HIGHEST)
        if basis.shape[1]:
            unit = _UNITS.get(name, "")
            found.append(Regressor(name, unit, values, basis * sigma[:, None], competes=True))
            if name == "temperature_c":
                local = bumps(values) * sigma[:, None]
                found.append(Regressor(name, unit, values, local, competes=True))
    return tuple(found)


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What the search has found on the slow view.

    Parameters
    ----------
    engine : the blocks under their noise floor
    state : the best set of effects
    unknown : unknown structure, if it ends with that
    """

    engine: Engine
    state: State
    unknown: Scored | None


def search_record(samples: Samples, settings: Settings) -> Found:
    """Search the slow view of a record.

    What goes slowly may be an effect in little noise, or noise. All readings are followed: one
    search begins under the usual noise, one under what the likelihood makes of the record, one
    under the same for sensors with far more slow noise; the reading with the highest total
    evidence stands.

    Raises
    ------
    RankDeficient
        The record is too short.
    """
    problem = record_problem(samples)
    begun = [
        _settled(problem, settings, usual_floor(problem)),
        _settled(problem, settings, record_floor(problem)),
        _settled(problem, settings, record_floor(problem, slow=_LOUD), slow=_LOUD),
    ]
    paths = telegraph_of(
        problem, [engine.search.bank.space.chol @ s.residual for engine, s in begun]
    )
    if paths is not None:
        problem = record_problem(samples, paths)
        _, best = max(begun, key=lambda one: _worth(*one))
        begun += [
            _settled(problem, settings, floor)
            for floor in (usual_floor(problem), record_floor(problem, best.slots))
        ]
    engine, _ = max(begun, key=lambda one: _worth(*one))
    engine = calibrated(engine)
    return _with_partial_names(engine, *engine.found())


def _with_partial_names(engine: Engine, state: State, unknown: Scored | None) -> Found:
    """Name what explains the better part of unknown structure; what is left stays unknown.

    A curve explains a rich record best, but says less than a name that explains most of it.
    """
    search = engine.search
    while unknown is not None and len(state.slots) < search.most:
        best = max(search.scores(state).values(), key=lambda one: one.margin)
        enough = max(_PART * unknown.evidence, search.threshold + _PLAIN)
        if best.slot is None or best.margin < enough:
            break
        state = search.state((*state.slots, search.polished(best.slot, state)))
        unknown = search.unknown(state)
        if unknown.margin <= search.threshold:
            unknown = None
    return Found(engine, state, unknown)


def _settled(
    problem: Problem, settings: Settings, floor: Floor, slow: float = 1.0
) -> tuple[Engine, State]:
    """The search under a floor, and again under the floor that what was found leaves."""
    bank = Bank.of(problem)
    _, state = _searched(problem, settings, bank, floor)
    return _searched(problem, settings, bank, record_floor(problem, state.slots, slow))


def _searched(
    problem: Problem, settings: Settings, bank: Bank, floor: Floor
) -> tuple[Engine, State]:
    regressors = record_regressors(problem, np.sqrt(np.diag(floor.covariance)))
    engine = under(problem, settings, bank, floor, regressors)
    return engine, engine.found()[0]


def _worth(engine: Engine, state: State) -> float:
    """Logarithm of the evidence of noise and effects together, but for a constant."""
    space, sizes = engine.search.bank.space, engine.floor.sizes
    plain = engine.search.state(())
    design = space.white(engine.problem.design())
    determinant = float(np.sum(np.log(np.diag(space.chol))))
    determinant += 0.5 * float(np.linalg.slogdet(design.T @ design)[1])
    log = 2.0 * np.log(sizes.ratio)
    prior = float(log @ np.linalg.solve(prior_of(engine.floor.parts), log))
    explained = _explained(engine, state)
    level = float(np.log(space.prior + plain.rss))
    return explained - determinant - 0.5 * (space.prior + space.dof) * level - 0.5 * prior


def _explained(engine: Engine, state: State) -> float:
    """Evidence of the effects, one after the other, less what each must have."""
    search = engine.search
    total = 0.0
    for place, slot in enumerate(state.slots):
        others = search.state(state.slots[:place])
        total += search.own_evidence(slot, others, search.scores(others)) - search.threshold
    return total
