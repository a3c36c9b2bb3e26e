"""One run under many sizes of its noise, and what all of them together say.

Few rows tell the sizes of the noise badly. One size that is found first and then taken for true
makes an effect of what is a larger drift, or hides an effect behind a drift that is not there. Here
every hypothesis is weighed under all sizes that the rows and the certificates leave possible
(marginal likelihood; the sizes are samples of what the replicates leave, with their importance).
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.bank import Bank, Projected
from core.discrepancy.curves import Curve, Regressor
from core.discrepancy.evidence import log_mean
from core.discrepancy.features import Features, curve_of
from core.discrepancy.floor import Floor
from core.discrepancy.problem import Problem
from core.discrepancy.relabels import Relabels
from core.discrepancy.reml import prior_of
from core.discrepancy.slots import State, state_of
from core.discrepancy.space import Space, solved

_SEED = 1763
_WORK = 1400
_MOST, _LEAST = 16, 7
_MOST_ROWS = 250
"""Outputs beyond which replicates tell the sizes well enough."""
_WIDER = 1.4
"""How much further the sizes are sampled than they are likely to go."""
_LEVEL = 20.0
"""Degrees of freedom behind the level, once the sizes themselves are uncertain."""


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """A run under one choice of sizes.

    Parameters
    ----------
    bank : columns of all instances
    relabels : hypotheses without parameters
    curves : unknown structure
    weight : logarithm of what speaks for these sizes but for the outputs
    """

    bank: Projected
    relabels: Relabels
    curves: tuple[Curve | Features, ...]
    weight: float

    def state(self, state: State, y: FloatArray) -> State:
        """A state as it looks under these sizes."""
        return state_of(state.slots, self.bank.space, y)

    def heard(self, rss: FloatArray | float) -> FloatArray:
        """What speaks for these sizes when so much is left, natural logarithm."""
        space = self.bank.space
        level = np.log(space.prior + np.asarray(rss, dtype=np.float64))
        return self.weight - 0.5 * (space.prior + space.dof) * level


def views_of(
    problem: Problem,
    bank: Bank,
    floor: Floor,
    regressors: tuple[Regressor, ...],
    relabels: Relabels,
) -> tuple[View, ...]:
    """The views of a run; none where there are so many rows that one floor is enough."""
    n = len(problem.y)
    if n > _MOST_ROWS:
        return ()
    design = problem.design()
    count = int(np.clip(_WORK // n, _LEAST, _MOST))
    prior = np.linalg.inv(prior_of(floor.parts))
    drawn_from = np.linalg.inv(_WIDER**2 * floor.sizes.spread)
    middle = 2.0 * np.log(floor.sizes.ratio)
    found: list[View] = []
    for sizes in floor.sizes.drawn(count, np.random.default_rng(_SEED), _WIDER):
        log = 2.0 * np.log(sizes.ratio)
        space = Space.of(sizes.total(floor.parts), design, _LEVEL)
        away = log - middle
        importance = 0.5 * float(away @ drawn_from @ away - log @ prior @ log)
        curves = tuple(curve_of(one, space) for one in regressors)
        weight = importance - _volume(space, design)
        found.append(View(bank.in_space(space), relabels.in_space(space), curves, weight))
    return tuple(found)


def spread_of(
    views: tuple[View, ...],
    outputs: FloatArray,
    design: FloatArray,
    wide: FloatArray,
    values: FloatArray,
) -> FloatArray:
    """Standard uncertainty (p,) of values that were found under one choice of sizes.

    Parameters
    ----------
    outputs : (n,)
    design, values : (n, p), (p,) all columns and what was found for them
    wide : (n, q) the same columns, and slopes of their shapes behind them
    """
    squares, heard = list[FloatArray](), list[float]()
    for view in views:
        space = view.bank.space
        white, y = space.white(design), space.white(outputs)
        there, _ = solved(white, y)
        _, covariance = solved(space.white(wide), y)
        rss = float(np.sum((y - white @ there) ** 2))
        known = space.prior + len(y) - design.shape[1]
        variance = np.diag(covariance)[: len(values)] * (space.prior + rss) / (known - 2.0)
        squares.append(np.maximum(variance, 0.0) + (there - values) ** 2)
        heard.append(float(view.heard(rss)))
    weights = np.exp(np.array(heard) - max(heard))
    return np.sqrt(weights @ np.array(squares) / weights.sum())


def _volume(space: Space, design: FloatArray) -> float:
    """Half the logarithm of the determinants of the noise and of the plain model in it."""
    scaled = space.white(design / np.linalg.norm(design, axis=0))
    inside = float(np.linalg.slogdet(scaled.T @ scaled)[1])
    return float(np.sum(np.log(np.diag(space.chol)))) + 0.5 * inside


def together(evidence: list[FloatArray], heard: list[FloatArray]) -> FloatArray:
    """Evidence (m,) or (m, k) under all views, each heard (scalar or (k,)) as far as it fits."""
    weights = np.array(heard)
    joint = np.array(evidence) + weights[:, None]
    return log_mean(joint, axis=0) - log_mean(weights, axis=0)
