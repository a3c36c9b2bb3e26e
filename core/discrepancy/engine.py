"""From a run to the set of effects that explains it, in three rounds.

The noise is found with what was named left out of it, for a real drift looks like noise until it
has a name, and noise that ate an effect hides it (Patterson and Thompson's contrasts cannot help
where the effect has the shape of the noise).
"""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Bank
from core.discrepancy.curves import Regressor, regressors_of
from core.discrepancy.features import curve_of, features_of, unnamed
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.relabels import Relabelling, Relabels, relabellings_of
from core.discrepancy.search import Scored, Search
from core.discrepancy.settings import Settings
from core.discrepancy.slots import Slot, State
from core.discrepancy.views import together, views_of

_START, _LEAST = 3.0, 1.0
_SEED = 20120917
_UNLUCKY = 0.015


@dataclass(frozen=True, slots=True, eq=False)
class Engine:
    """A run under one noise floor.

    Parameters
    ----------
    problem, settings, bank, floor : what is compared, and against what
    regressors : against what residuals are looked at
    search : all hypotheses, with the threshold of this plan and this noise
    nulls : (n, k) whitened residuals of data that are only noise
    top : (k,) evidence of the best name in each of them, ascending
    answer : what the search finds, where it had to be asked already
    """

    problem: Problem
    settings: Settings
    bank: Bank
    floor: Floor
    regressors: tuple[Regressor, ...]
    search: Search
    nulls: FloatArray
    top: FloatArray
    answer: tuple[State, Scored | None] | None = None

    @classmethod
    def of(cls, problem: Problem, settings: Settings) -> "Engine":
        """Prepare a run; what is found in a first round is left out of the noise."""
        made = relabellings_of(problem)
        problem, bank, gross = _gross(problem, settings, made)
        engine = under(problem, settings, bank, Floor.of(problem, settings, gross), made=made)
        state, _ = engine.search.run()
        if not _same(state.slots, gross):
            floor = Floor.of(problem, settings, state.slots)
            engine = under(problem, settings, bank, floor, made=made)
        engine = calibrated(_seen(engine))
        if engine.search.views:
            answer = engine.search.run()
            if _same(answer[0].slots, state.slots):
                return replace(engine, answer=answer)
            floor = Floor.of(problem, settings, answer[0].slots)
            engine = calibrated(_seen(under(problem, settings, bank, floor, made=made)))
        return engine

    def found(self, forced: tuple[Slot, ...] = ()) -> tuple[State, Scored | None]:
        """The best set of effects that holds the forced ones."""
        if self.answer is not None and not forced:
            return self.answer
        return self.search.run(forced)

    def p_value(self, evidence: float) -> float:
        """Probability of so much evidence for any name in data without any effect."""
        above = len(self.top) - int(np.searchsorted(self.top, evidence))
        return (above + 1.0) / (len(self.top) + 1.0)


def _gross(
    problem: Problem, settings: Settings, made: tuple[Relabelling, ...]
) -> tuple[Problem, Bank, tuple[Slot, ...]]:
    """What stands out by far under the stated noise, and the problem without what it bent.

    Rows that mean something else than they say make a mockery of the replicates, and bend the
    response through which the rig acts; what else seemed to stand out is looked at again then.
    """
    relabelled: tuple[Slot, ...] = ()
    right = problem
    while True:
        bank = Bank.of(right)
        floor = Floor.stated(right, settings)
        search = under(right, settings, bank, floor, (), made).search  # names alone
        found = search.gross(search.state(relabelled)).slots
        further = tuple(slot for slot in found if not slot.raw.shape[1])
        if len(further) == len(relabelled):
            return right, bank, found
        relabelled = further
        right = problem.corrected(sum((slot.change for slot in relabelled), 0.0 * problem.y))


def under(
    problem: Problem,
    settings: Settings,
    bank: Bank,
    floor: Floor,
    regressors: tuple[Regressor, ...] | None = None,
    made: tuple[Relabelling, ...] | None = None,
) -> Engine:
    """A run under a noise floor, without the threshold; `regressors` other than those of a run.

    `made` are its relabellings, where they are there already.
    """
    space = floor.space(problem.design())
    projected = bank.in_space(space)
    if regressors is None:
        sigma = np.sqrt(np.diag(floor.covariance))
        features = (unnamed(one, projected) for one in features_of(problem, sigma))
        regressors = (*regressors_of(problem, sigma), *(f for f in features if f.basis.shape[1]))
    search = Search(
        problem=problem,
        bank=projected,
        relabels=Relabels.of(problem, space, relabellings_of(problem) if made is None else made),
        curves=tuple(curve_of(one, space) for one in regressors),
        doubts={},
        curve_doubts=(0.0,) * len(regressors),
        threshold=_START,
        most=settings.max_effects,
    )
    none = np.zeros((len(problem.y), 0))
    return Engine(problem, settings, bank, floor, regressors, search, none, np.zeros(0))


def _same(some: tuple[Slot, ...], others: tuple[Slot, ...]) -> bool:
    return {slot.key for slot in some} == {slot.key for slot in others}


def _seen(engine: Engine) -> Engine:
    """With the run under all sizes of the noise that are possible."""
    search = engine.search
    views = views_of(engine.problem, engine.bank, engine.floor, engine.regressors, search.relabels)
    return replace(engine, search=replace(search, views=views))


def calibrated(engine: Engine) -> Engine:
    """With the threshold that data without any effect exceed in `alpha` of cases."""
    search, space = engine.search, engine.search.bank.space
    rng = np.random.default_rng(_SEED)
    nulls = engine.floor.nulls(space, rng)
    if search.views:
        evidence = _marginal(engine, space.chol @ nulls)
        doubts = np.zeros(len(evidence))
    else:
        exact = space.project(rng.standard_normal(nulls.shape))
        evidence = _evidence(engine, nulls)
        # What goes with time may be no more than a larger drift; what repeats, a worse head.
        doubts = np.maximum(_highest(evidence) - _highest(_evidence(engine, exact)), 0.0)
    top = np.sort(np.max(evidence - doubts[:, None], axis=0))
    threshold = max(_LEAST, float(np.quantile(top, 1.0 - engine.settings.alpha)))
    names = len(engine.bank.names)
    doubted = dict(zip(engine.bank.names, doubts[:names].tolist(), strict=True))
    # Noise favours what has no parameters by more than 1 / alpha in alpha of all cases at most
    # (Markov); no noise needs to be simulated for that.
    short = max(-float(np.log(engine.settings.alpha)) - threshold, 0.0)
    search = replace(
        search,
        threshold=threshold,
        doubts=doubted | dict.fromkeys(search.relabels.all_names, short),
        curve_doubts=tuple(doubts[names:].tolist()),
    )
    return replace(engine, search=search, nulls=nulls, top=top)


def _highest(evidence: FloatArray) -> FloatArray:
    """Mean of the highest values of each row (m,): steadier than a quantile so far out."""
    count = max(round(_UNLUCKY * evidence.shape[1]), 1)
    return np.mean(np.sort(evidence, axis=1)[:, -count:], axis=1)


def _evidence(engine: Engine, residuals: FloatArray) -> FloatArray:
    """Evidence of all names and curves (m, k) in residuals (n, k)."""
    search = engine.search
    added = np.zeros((len(residuals), 0))
    names = engine.bank.by_name(search.bank.evidence(residuals, added))
    curves = [curve.evidence(residuals, search.bank.space) for curve in search.curves]
    return np.vstack([names, *curves])


def _marginal(engine: Engine, noise: FloatArray) -> FloatArray:
    """The same in outputs (n, k) that are only noise, under all sizes that are possible."""
    added = np.zeros((len(noise), 0))
    each, heard = list[FloatArray](), list[FloatArray]()
    for view in engine.search.views:
        space = view.bank.space
        residuals = space.rest(noise)
        names = engine.bank.by_name(view.bank.evidence(residuals, added))
        each.append(np.vstack([names, *(c.evidence(residuals, space) for c in view.curves)]))
        heard.append(view.heard(np.sum(residuals**2, axis=0)))
    return together(each, heard)
