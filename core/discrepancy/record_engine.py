"""The search on the slow view of a long record."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

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
from core.discrepancy.record_refined import NameSet
from core.discrepancy.record_search import ended, leavings, likeliest
from core.discrepancy.record_sets import tied_names
from core.discrepancy.record_shapes import Key, Shapes
from core.discrepancy.record_spread import widened
from core.discrepancy.record_telegraph import telegraph_of
from core.discrepancy.reml import prior_of
from core.discrepancy.result import Step
from core.discrepancy.search import Scored
from core.discrepancy.settings import Settings
from core.discrepancy.slots import Slot, State
from core.model.effect import Effect

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
_RARE = 5.0
"""What speaks against ten times the slow noise before anything is seen, natural logarithm."""
_PART, _PLAIN = 0.5, 10.0
_KEPT, _CARRIED = 3, 5
_ALIKE = 2.0
"""Nats by which much slow noise may lead a telegraph that is told none the less."""
_TELEGRAPH = "telegraph"
_FINE = (24, 64)
"""Half waves over a record of what changes faster than slow curves do, all alike."""


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
        for basis in (waves(t), bumps(t), *(_fine(t, count) for count in _FINE))
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


def _fine(t: FloatArray, count: int) -> FloatArray:
    """Cosines (n, count) over time, the fast ones as large as the slow."""
    x = (t - t[0]) / float(np.ptp(t))
    return np.cos(np.pi * np.outer(x, np.arange(1, count + 1)))


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What the search has found on the slow view.

    Parameters
    ----------
    engine : the blocks under their noise floor
    state : the best set of effects
    unknown : unknown structure, if it ends with that
    doubtful : names that unknown structure could stand for
    tied : names that cannot be told from each slot
    shapes : what the slots were made with
    """

    engine: Engine
    state: State
    unknown: Scored | None
    doubtful: tuple[str, ...] = ()
    tied: tuple[tuple[str, ...], ...] = ()
    shapes: Shapes | None = None

    def measured(self, steps: Sequence[Step]) -> Sequence[Step]:
        """Steps of the slots with all of their uncertainty."""
        return widened(self.shapes, self.engine, self.state, steps) if self.shapes else steps


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
    first = _Readings(problem, settings)
    begun = [
        first.settled(usual_floor(problem)),
        first.settled(first.floor()),
        first.settled(first.floor(slow=_LOUD), slow=_LOUD),
    ]
    paths = telegraph_of(problem, _left_over(begun))
    if paths is not None:
        again = first.beside(paths)
        best = max(begun, key=lambda one: one.worth)
        floors = (usual_floor(problem), again.floor(best.state.slots))
        begun += [again.settled(floor) for floor in floors]
    best, guessed = _chosen(begun)
    engine = calibrated(_told(best, settings))
    shapes = Shapes(engine.search, first.raw)
    sets = likeliest(shapes, _carried([best, *begun]))
    chosen, unknown, doubtful = ended(engine.search, sets)
    found = _with_partial_names(engine, chosen.state, unknown)
    tied = tied_names(shapes, found.state, sets)
    return replace(found, doubtful=(*doubtful, *guessed), tied=tuple(tied), shapes=shapes)


def _carried(readings: Sequence["_Reading"]) -> list[tuple[Slot, ...]]:
    """The likeliest sets of all readings, each set of names once."""
    found: dict[tuple[str, ...], tuple[Slot, ...]] = {}
    for one in readings:
        for each in one.sets[:_CARRIED]:
            if each.names:
                found.setdefault(each.names, each.state.slots)
    return list(found.values())


def _chosen(begun: Sequence["_Reading"]) -> tuple["_Reading", tuple[str, ...]]:
    """The likeliest reading, and what is a guess in it.

    Far more slow noise than usual and a telegraph are much alike; where the noise leads by little
    the telegraph is told, in doubt.
    """
    best = max(begun, key=lambda one: one.worth)
    between = [one for one in begun if _TELEGRAPH in one.names]
    rival = max(between, key=lambda one: one.worth, default=best)
    if _TELEGRAPH not in best.names and rival.worth > best.worth - _ALIKE:
        return rival, (_TELEGRAPH,)
    return best, ()


def _told(best: "_Reading", settings: Settings) -> Engine:
    """The engine of a reading; of all paths of a telegraph that were tried the best alone."""
    engine = best.engine
    path = next((slot for slot in best.state.slots if slot.name == _TELEGRAPH), None)
    if path is None:
        return engine
    others = (one for one in engine.problem.effects if one.id != _TELEGRAPH)
    problem = replace(engine.problem, effects=(*others, path.instance.effect))
    return under(problem, settings, Bank.of(problem), engine.floor, engine.regressors)


def _left_over(begun: Sequence["_Reading"]) -> list[FloatArray]:
    """What the likeliest sets, and all small ones, leave (n,): a telegraph may be in it."""
    found: list[FloatArray] = []
    for one in begun:
        chol = one.engine.search.bank.space.chol
        found += [chol @ each.state.residual for each in one.sets[:_KEPT]]
    search = begun[0].engine.search
    return [*found, *(search.bank.space.chol @ left for left in leavings(search))]


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


@dataclass(frozen=True, slots=True, eq=False)
class _Reading:
    """A record under one floor, with what the search finds there and what all is worth."""

    engine: Engine
    sets: list[NameSet]
    state: State
    worth: float

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its slots."""
        return tuple(slot.name for slot in self.state.slots)


class _Readings:
    """Searches of one record under several floors, none done twice."""

    def __init__(self, problem: Problem, settings: Settings) -> None:
        self._problem, self._settings = problem, settings
        self._bank = Bank.of(problem)
        self._floors: dict[tuple[object, ...], Floor] = {}
        self._done: dict[int, _Reading] = {}
        self.raw: dict[Key, FloatArray] = {}

    def beside(self, effect: Effect) -> "_Readings":
        """The same with one more effect to be looked for."""
        problem = replace(self._problem, effects=(*self._problem.effects, effect))
        more = _Readings(problem, self._settings)
        more.raw = self.raw
        more._floors = self._floors
        return more

    def floor(self, slots: tuple[Slot, ...] = (), slow: float = 1.0) -> Floor:
        """The floor that the likelihood finds beside some effects."""
        key = (slow, *(slot.key for slot in slots))
        if key not in self._floors:
            self._floors[key] = record_floor(self._problem, slots, slow)
        return self._floors[key]

    def settled(self, floor: Floor, slow: float = 1.0) -> _Reading:
        """The search under a floor, and again under the floor that what was found leaves."""
        first = self._searched(floor)
        known = [one.state.slots for one in first.sets[:_CARRIED] if one.names]
        found = self._searched(self.floor(first.state.slots, slow), known)
        return found if slow == 1.0 else replace(found, worth=found.worth - _RARE)

    def _searched(self, floor: Floor, known: Sequence[tuple[Slot, ...]] = ()) -> _Reading:
        if id(floor) not in self._done:
            sigma = np.sqrt(np.diag(floor.covariance))
            regressors = record_regressors(self._problem, sigma)
            engine = under(self._problem, self._settings, self._bank, floor, regressors)
            sets = likeliest(Shapes(engine.search, self.raw), known)
            best, unknown, _ = ended(engine.search, sets)
            self._done[id(floor)] = _Reading(
                engine, sets, best.state, _worth(engine, best, unknown)
            )
        return self._done[id(floor)]


def _worth(engine: Engine, best: NameSet, unknown: Scored | None) -> float:
    """Logarithm of the evidence of noise and effects together, but for a constant."""
    space, sizes = engine.search.bank.space, engine.floor.sizes
    plain = engine.search.state(())
    design = space.white(engine.problem.design())
    determinant = float(np.sum(np.log(np.diag(space.chol))))
    determinant += 0.5 * float(np.linalg.slogdet(design.T @ design)[1])
    log = 2.0 * np.log(sizes.ratio)
    prior = float(log @ np.linalg.solve(prior_of(engine.floor.parts), log))
    explained = best.worth
    if unknown is not None:
        explained += unknown.evidence - engine.search.threshold
    level = float(np.log(space.prior + plain.rss))
    # A size that is known before tells more than one that only the data tell (Laplace).
    known = np.linalg.slogdet(sizes.spread)[1] - np.linalg.slogdet(prior_of(engine.floor.parts))[1]
    fit = -determinant - 0.5 * (space.prior + space.dof) * level
    return explained + fit - 0.5 * prior + 0.5 * float(known)
