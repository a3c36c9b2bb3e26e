"""How far the model and the data are apart, in total, between positions, and held out."""

import math

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import cells
from core.discrepancy.engine import Engine
from core.discrepancy.result import Gap
from core.discrepancy.slots import State
from core.fit.quantiles import f_sf

_FOLDS = 5
_DUST = 1e-9


def gap_of(engine: Engine, state: State) -> Gap:
    """The gap of a state."""
    space = engine.search.bank.space
    dof = max(space.dof - state.added.shape[1], 1)
    raw = space.chol @ state.residual
    reduced = state.rss / dof
    return Gap(
        rms=float(np.sqrt(np.mean(raw**2))),
        gap=math.sqrt(reduced),
        chi2_red=reduced,
        dof=space.dof - state.added.shape[1],
        p_value=f_sf(reduced, dof, max(space.prior, 1.0)),
        lack_p=_lack_of_fit(engine, state),
    )


def held_out_gap(engine: Engine, state: State) -> float:
    """Gap of rows that were left out of the fit, a run at a time (a fifth where there is one run).

    A figure of stability, no confirmation: the errors of the head repeat in every run, and the
    names were chosen with all rows.
    """
    problem, space = engine.problem, engine.search.bank.space
    run = np.tile(problem.run.run, problem.channels)
    runs = np.unique(run)
    if len(runs) < 2:
        run = np.tile(np.arange(problem.rows) % _FOLDS, problem.channels)
        runs = np.unique(run)
    change = sum((slot.change for slot in state.slots), np.zeros(len(problem.y)))
    y = problem.y + change
    design = np.hstack([problem.design(), *(slot.raw for slot in state.slots)])
    size = np.linalg.norm(design, axis=0)
    design = design / np.where(size > 0.0, size, 1.0)
    covariance = space.chol @ space.chol.T
    total, count = 0.0, 0
    for one in runs:
        out = run == one
        if out.all():
            return math.nan
        chol = np.linalg.cholesky(covariance[np.ix_(~out, ~out)])
        inverse = np.linalg.pinv(np.linalg.solve(chol, design[~out]), rcond=1e-9)
        values = inverse @ np.linalg.solve(chol, y[~out])
        error = y[out] - design[out] @ values
        spread = covariance[np.ix_(out, out)] + design[out] @ (inverse @ inverse.T) @ design[out].T
        total += float(error @ np.linalg.solve(spread, error))
        count += int(out.sum())
    return math.sqrt(total / count)


def _lack_of_fit(engine: Engine, state: State) -> float:
    """P value of what positions leave beyond what their replicates show (NIST 4.6.1)."""
    problem, space = engine.problem, engine.search.bank.space
    cell = cells(problem)
    groups = np.equal.outer(cell, np.unique(cell)).astype(np.float64)
    between = space.rest(groups)
    shadow = state.added.T @ between
    values, turn = np.linalg.eigh(between.T @ between - shadow.T @ shadow)
    keep = values > _DUST * float(values.max(initial=0.0))
    lack_dof = int(keep.sum())
    pure_dof = space.dof - state.added.shape[1] - lack_dof
    if pure_dof < 2 or not lack_dof:
        return math.nan
    along = turn[:, keep].T @ (between.T @ state.residual)
    lack = float(np.sum(along**2 / values[keep]))
    level = (state.rss - lack + space.prior) / (pure_dof + space.prior)
    ratio = lack / lack_dof / level
    return f_sf(ratio, lack_dof, pure_dof + space.prior)


def predicted(engine: Engine, state: State) -> FloatArray:
    """(n,) what the model of a state says of each row."""
    return engine.problem.y - engine.search.bank.space.chol @ state.residual
