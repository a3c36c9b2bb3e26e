"""Where the disagreement is: one regressor at a time, multiplicity controlled."""

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.discrepancy.curves import Curve
from core.discrepancy.engine import Engine
from core.discrepancy.features import Features, curve_of
from core.discrepancy.result import Where
from core.discrepancy.slots import State

_KNOTS = 60
_LEVEL = 0.95
_EDGE = 0.05
"""Share of the simulated noise beyond which its tail is a law, no count."""


def locate(engine: Engine, state: State) -> tuple[Where, ...]:
    """Return all regressors, the most significant first.

    P values are those of Westfall and Young (1993): the smallest of all regressors in simulated
    noise is what each must beat.
    """
    space = engine.search.bank.space.with_columns(
        np.hstack([np.zeros((len(state.residual), 0)), *(slot.raw for slot in state.slots)])
    )
    nulls = engine.nulls - state.added @ (state.added.T @ engine.nulls)
    curves = [curve_of(regressor, space) for regressor in engine.regressors]
    if not curves:
        return ()
    observed = np.array([float(c.evidence(state.residual, space)) for c in curves])
    null = np.array([c.evidence(nulls, space) for c in curves])
    count = null.shape[1]
    own = _chances(null, observed[:, None])[:, 0]
    smallest = _chances(null, null).min(axis=0)
    adjusted = [(1.0 + float(np.sum(smallest <= p))) / (1.0 + count) for p in own]
    raw, raw_nulls = space.chol @ state.residual, space.chol @ nulls
    found = [
        _where(engine, curve, state, p, raw, raw_nulls)
        for curve, p in zip(curves, adjusted, strict=True)
    ]
    by_name: dict[str, Where] = {}
    for place in np.lexsort((-observed, adjusted)):
        # A smooth and a local curve of the same regressor: the more significant is shown.
        by_name.setdefault(found[int(place)].regressor, found[int(place)])
    return tuple(by_name.values())


def _chances(null: FloatArray, values: FloatArray) -> FloatArray:
    """Probability (k, m) of so much evidence in noise, from that (k, j) of simulated noise.

    Beyond all noise that was simulated it falls as fast as noise may favour a hypothesis at most
    (Markov): else of many regressors one always seems to be the first in some noise.
    """
    count = null.shape[1]
    ordered = np.sort(null, axis=1)
    edge = ordered[:, [int((1.0 - _EDGE) * count)]]
    below = np.zeros(values.shape)
    for place, (row, one) in enumerate(zip(ordered, values, strict=True)):
        below[place] = np.searchsorted(row, one)
    share = (1.0 + count - below) / (1.0 + count)
    return np.where(values > edge, _EDGE * np.exp(np.minimum(edge - values, 0.0)), share)


def _where(
    engine: Engine,
    curve: Curve | Features,
    state: State,
    p_value: float,
    raw: FloatArray,
    raw_nulls: FloatArray,
) -> Where:
    problem, regressor = engine.problem, curve.regressor
    smooth = curve.fitted(state.residual)
    excess = state.rss - engine.search.bank.space.dof
    taken = state.rss - float(np.sum((state.residual - smooth) ** 2))
    whole = engine.search.bank.space.chol @ smooth
    channel = problem.channel
    # One channel is drawn: that in which the curve is strongest.
    sizes = [float(np.sum(whole[channel == c] ** 2)) for c in range(problem.channels)]
    own = channel == int(np.argmax(sizes))
    x = regressor.x[own]
    bins = _bins(x)
    count = np.bincount(bins)
    mean = np.bincount(bins, raw[own]) / count
    null = np.array([np.bincount(bins, one) for one in raw_nulls[own].T]).T / count[:, None]
    sigma = np.sqrt(np.mean(null**2, axis=1)) + 1e-300
    level = float(np.quantile(np.max(np.abs(null) / sigma[:, None], axis=0), _LEVEL))
    knots = np.bincount(bins, x) / count
    worst = int(np.argmax(np.abs(mean) / sigma))
    return Where(
        regressor=regressor.name,
        unit=regressor.unit,
        p_value=p_value,
        share=float(np.clip(taken / excess, 0.0, 1.0)) if excess > 0.0 else 0.0,
        worst_value=float(knots[worst]),
        worst_sigma=float(mean[worst] / sigma[worst]),
        x=frozen(regressor.x),
        residual=frozen(raw),
        channel=frozen_int(channel),
        knots=frozen(knots),
        curve=frozen(np.bincount(bins, whole[own]) / count),
        band=frozen(level * sigma),
        shown=int(np.argmax(sizes)),
    )


def _bins(x: FloatArray) -> IntArray:
    """Number of the bin of each row; bins ascend and none is empty."""
    values, place = np.unique(x.round(9), return_inverse=True)
    if len(values) <= _KNOTS:
        return place.astype(np.int64)
    coarse = place * _KNOTS // len(values)
    return np.unique(coarse, return_inverse=True)[1].astype(np.int64)
