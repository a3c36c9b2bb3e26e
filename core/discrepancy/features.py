"""Single features that no name describes: one hump, one step, one wave, one slow follower.

A smooth curve is free to go anywhere and pays for all of that; a disagreement that is one feature
at one place is told from the names by far fewer rows if it may say so.
"""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import BoolArray, FloatArray
from core.discrepancy.bank import Projected
from core.discrepancy.components import times
from core.discrepancy.curves import Curve, Regressor
from core.discrepancy.evidence import block_evidence, log_mean, many_block_evidence
from core.discrepancy.problem import Problem
from core.discrepancy.space import Space
from core.model.catalogue.terms import ideal, own

_STRETCHES_DEG, _PULLS_DEG = (18.0, 35.0), (30.0, 50.0)
_AROUND_DEG = 15.0
_PLACES = 15
_WIDTHS, _EDGE = (0.1, 0.2), 0.08
"""Of humps and of a step, in parts of the largest input."""
_WAVES = np.arange(4.0, 13.0)
"""Radians a wave turns through between no input and the largest."""
_ROWS = (1.5, 4.0, 8.0, 16.0, 32.0)
"""Time constants of what follows late, in rows."""
_NAMED = 0.95
"""Part of a feature beyond which a name that explains it takes its place."""
_SEEN, _FREE = 1e-3, 1e-4


def unnamed(regressor: Regressor, bank: Projected) -> Regressor:
    """Without the features that one name of the catalogue explains as well."""
    if regressor.width != 1:
        return regressor
    rest = bank.space.rest(regressor.basis)
    size = np.sum(rest**2, axis=0)
    explained, _ = bank.explained(rest, np.zeros((len(rest), 0)))
    kept = explained.max(axis=0, initial=0.0) < _NAMED * size
    return replace(regressor, basis=regressor.basis[:, kept])


def curve_of(regressor: Regressor, space: Space) -> "Curve | Features":
    """A regressor in a whitened space."""
    return Features.of(regressor, space) if regressor.width else Curve.of(regressor, space)


def features_of(problem: Problem, sigma: FloatArray) -> tuple[Regressor, ...]:
    """All features that a run could show, of unit amplitude in units of the noise.

    Parameters
    ----------
    sigma : (n c,) standard deviation of the noise of each row
    """
    run, n = problem.run, problem.rows
    typical = float(np.median(sigma))
    found: list[Regressor] = []

    def add(name: str, unit: str, x: FloatArray, columns: FloatArray, width: int = 1) -> None:
        x = np.tile(x, problem.channels)
        size = np.max(np.abs(columns), axis=0)
        columns = columns[:, size > 0.0] / size[size > 0.0] * typical
        if np.ptp(x) > 0.0 and columns.shape[1]:
            found.append(Regressor(name, unit, x, columns, competes=True, width=width))

    on_table = run.test == "rate_table"
    if not on_table:
        head = np.mod(run.head_deg, 360.0)
        own_each = [_around(head, width) for width in _PULLS_DEG]
        columns = [_in_channel(problem, i, c) for i in range(problem.channels) for c in own_each]
        if run.test == "dividing_head":
            slope = problem.slope()[:, None]
            columns += [
                np.tile(_around(head, width), (problem.channels, 1)) * slope
                for width in _STRETCHES_DEG
            ]
        add("head_deg", "deg", head, np.hstack(columns))
    if run.test != "static_positions":
        for channel, model in enumerate(problem.models):
            sensor = model.sensor
            name = "set_rate_dps" if on_table else f"a_{sensor.axis}"
            x = own(problem.stimulus, sensor)
            largest = float(np.max(np.abs(x)))
            if largest == 0.0:
                continue
            x = x / largest
            unit = "deg/s" if on_table else "m/s^2"
            shown = sensor.input(problem.stimulus)[:, sensor.index]
            add(name, unit, shown, _in_channel(problem, channel, _local(x)))
            turns = np.outer(x, _WAVES)
            waves = np.stack([np.sin(turns), np.cos(turns)], axis=2).reshape(n, -1)
            add(name, unit, shown, _in_channel(problem, channel, waves), 2)
        late = [
            _in_channel(problem, i, _late(problem, ideal(problem.stimulus, model.sensor)))
            for i, model in enumerate(problem.models)
        ]
        place = run.set_rate_dps if on_table else np.mod(run.head_deg, 360.0)
        before = np.concatenate([place[:1], place[:-1]])
        add("previous", "deg/s" if on_table else "deg", before, np.hstack(late))
    timed = bool(np.all(np.isfinite(run.t_s)))
    turns = np.where(np.arange(n) % 2, -1.0, 1.0)[:, None]
    every = np.hstack([_in_channel(problem, i, turns) for i in range(problem.channels)])
    order = np.arange(n, dtype=np.float64)
    add(*(("t_s", "s", run.t_s) if timed else ("order", "", order)), every)
    return tuple(found)


def _in_channel(problem: Problem, channel: int, columns: FloatArray) -> FloatArray:
    """Columns (n, q) of one channel as columns (n c, q) of all."""
    found = np.zeros((problem.rows * problem.channels, columns.shape[1]))
    found[channel * problem.rows : (channel + 1) * problem.rows] = columns
    return found


def _around(head_deg: FloatArray, width_deg: float) -> FloatArray:
    """Humps (n, q) over a part of the circle."""
    centres = np.arange(0.0, 360.0, _AROUND_DEG)
    away = (head_deg[:, None] - centres + 180.0) % 360.0 - 180.0
    return np.exp(-0.5 * (away / width_deg) ** 2)


def _local(x: FloatArray) -> FloatArray:
    """Humps and steps (n, q) at places between the largest inputs."""
    places = np.linspace(-0.9, 0.9, _PLACES)
    away = x[:, None] - places
    humps = [np.exp(-0.5 * (away / width) ** 2) for width in _WIDTHS]
    return np.hstack([*humps, np.tanh(away / _EDGE)])


def _late(problem: Problem, output: FloatArray) -> FloatArray:
    """The output (n, q) as it follows late, one column a time constant."""
    t = times(problem)
    steps = np.diff(t, prepend=t[0])
    pause = max(float(np.median(steps[1:])), 1e-9)
    keep = np.exp(-steps[:, None] / (np.array(_ROWS) * pause))
    found = np.zeros((len(t), len(_ROWS)))
    for row in range(1, len(t)):
        found[row] = keep[row] * found[row - 1] + (1.0 - keep[row]) * output[row - 1]
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Features:
    """Features in a whitened space; asked like a `Curve`.

    Parameters
    ----------
    regressor : against what
    blocks : (n, m, p) whitened columns of each
    inner : (m, p, p) their products
    shown : (m,) whether the rows show it
    """

    regressor: Regressor
    blocks: FloatArray
    inner: FloatArray
    shown: BoolArray

    @classmethod
    def of(cls, regressor: Regressor, space: Space) -> "Features":
        """Project the features."""
        width = regressor.width
        rest = space.rest(regressor.basis)
        blocks = rest.reshape(len(rest), -1, width)
        inner = np.einsum("nmp,nmq->mpq", blocks, blocks)
        white = np.sum(space.white(regressor.basis) ** 2, axis=0).reshape(-1, width)
        shown = np.einsum("mpp->m", inner) > _SEEN**2 * np.maximum(white.sum(axis=1), 1e-300)
        return cls(regressor, blocks, inner, shown)

    def evidence(self, residual: FloatArray, space: Space) -> FloatArray:
        """Evidence of one feature in residuals (n,) or (n, k)."""
        many = residual if residual.ndim > 1 else residual[:, None]
        explained, rank = self._explained(many, self.inner)
        rss = np.sum(many**2, axis=0)
        each = many_block_evidence(explained, rank, rss, space.prior, space.dof)
        found = self._mean(np.where((rank > 0)[:, None], each, 0.0))
        return found if residual.ndim > 1 else found[0]

    def beside(self, residual: FloatArray, added: FloatArray, space: Space) -> float:
        """Evidence of one feature in a residual (n,), given `added` (n, s), orthonormal."""
        explained, rank = self._explained(residual[:, None], self._given(added))
        rss = float(residual @ residual)
        dof = space.dof - added.shape[1]
        each = block_evidence(explained[:, 0], rank, rss, space.prior, dof)
        return float(self._mean(np.where(rank > 0, each, 0.0)[:, None])[0])

    def fitted(self, residual: FloatArray) -> FloatArray:
        """Whitened curve (n,) of the feature that explains a residual best."""
        explained, _ = self._explained(residual[:, None], self.inner)
        if not len(explained):
            return np.zeros(len(residual))
        block = self.blocks[:, int(np.argmax(explained[:, 0]))]
        values = np.linalg.lstsq(block, residual, rcond=_FREE)[0]
        return np.asarray(block @ values, dtype=np.float64)

    def _given(self, added: FloatArray) -> FloatArray:
        """Products of what is left of each feature beside `added`."""
        if not added.shape[1]:
            return self.inner
        shadow = np.einsum("ns,nmp->smp", added, self.blocks)
        return self.inner - np.einsum("smp,smq->mpq", shadow, shadow)

    def _mean(self, evidence: FloatArray) -> FloatArray:
        if not np.any(self.shown):
            return np.zeros(evidence.shape[1:])
        shown: FloatArray = evidence[self.shown]
        return log_mean(shown, axis=0)

    def _explained(self, residual: FloatArray, inner: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Sum of squares (m, k) that each feature takes away, and its free columns (m,)."""
        along: FloatArray = np.einsum("nmp,nk->mpk", self.blocks, residual)
        unit = np.sqrt(np.maximum(np.einsum("mpp->mp", self.inner), 1e-300))
        values, vectors = np.linalg.eigh(inner / unit[:, :, None] / unit[:, None, :])
        free = (values > _FREE) & self.shown[:, None]
        inverse = np.where(free, 1.0 / np.where(free, values, 1.0), 0.0)
        turned: FloatArray = np.einsum("mpq,mpk->mqk", vectors, along / unit[:, :, None])
        explained: FloatArray = np.einsum("mqk,mq->mk", turned**2, inverse)
        return explained, free.sum(axis=1).astype(np.float64)
