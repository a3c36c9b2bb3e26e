"""The noise floor of a run: its covariance, what is behind it, and data that are only noise."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.discrepancy.components import Component, cells, components_of, times
from core.discrepancy.problem import Problem
from core.discrepancy.reml import Sizes, find_sizes, stated_sizes
from core.discrepancy.result import NoiseFloor
from core.discrepancy.settings import Settings
from core.discrepancy.slots import Slot
from core.discrepancy.space import Space
from core.units import RAD_PER_DEG

_ENOUGH = 10
_CERTAIN = 60.0
_STATED = 12.0
_NOTHING = 1.0
_NULLS, _DRAWS, _MANY = 324, 12, 160
_DECAYS = (0.05, 0.15, 0.5)


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """What the model is judged against.

    Parameters
    ----------
    parts : of the noise, at their stated sizes
    sizes : as they were found
    covariance : (n, n)
    prior : degrees of freedom behind its level
    source : as `NoiseFloor.source`
    """

    parts: tuple[Component, ...]
    sizes: Sizes
    covariance: FloatArray
    prior: float
    source: str

    @classmethod
    def stated(cls, problem: Problem, settings: Settings) -> "Floor":
        """The noise as it is stated."""
        parts = components_of(problem, settings)
        sizes = stated_sizes(parts)
        return cls(parts, sizes, sizes.total(parts), _STATED, "y_se")

    @classmethod
    def of(cls, problem: Problem, settings: Settings, slots: tuple[Slot, ...]) -> "Floor":
        """Find the noise; what the slots add is left out of it."""
        parts = components_of(problem, settings)
        y = problem.y + np.sum([slot.change for slot in slots], axis=0) if slots else problem.y
        own = [slot.raw for slot in slots if slot.raw.shape[1]]
        nuisance = np.hstack([_repeating(problem), _timely(problem), problem.design(), *own])
        replicates = len(y) - np.linalg.matrix_rank(_unit(nuisance)) >= _ENOUGH
        stated = bool(np.all(np.isfinite(problem.se)))
        if replicates:
            sizes = find_sizes(parts, y, nuisance)
            source, prior = "replicates", min(_CERTAIN, float(sizes.dof))
        else:
            smooth = np.hstack([_smooth(problem), _timely(problem), problem.design(), *own])
            rank = np.linalg.matrix_rank(_unit(smooth))
            if len(y) - rank < _ENOUGH:
                smooth = np.eye(len(y))
            sizes = find_sizes(parts, y, smooth)
            source, prior = ("y_se", _STATED) if stated else ("residual", _NOTHING)
        return cls(parts, sizes, sizes.total(parts), prior, source)

    def space(self, design: FloatArray) -> Space:
        """The whitened space of a plain model."""
        return Space.of(self.covariance, design, self.prior)

    def nulls(self, space: Space, rng: np.random.Generator) -> FloatArray:
        """Whitened residuals (n, k) of data that are only noise.

        The sizes of the parts are drawn as they could be as well, so that what is not known of
        them is in the threshold.
        """
        n = len(self.covariance)
        found: list[FloatArray] = []
        draws = _DRAWS if n > _MANY else 3 * _DRAWS
        for sizes in self.sizes.drawn(draws, rng):
            covariance = sizes.total(self.parts)
            jitter = 1e-12 * float(np.mean(np.diag(covariance))) * np.eye(n)
            root = np.linalg.cholesky(covariance + jitter)
            noise = root @ rng.standard_normal((n, _NULLS // draws))
            found.append(space.rest(noise))
        return np.hstack(found)

    def result(self, unit: str) -> NoiseFloor:
        """For the report."""
        sizes: dict[str, float] = {}
        ratios: dict[str, float] = {}
        for part, ratio in zip(self.parts, self.sizes.ratio, strict=True):
            rms = float(np.sqrt(np.mean(np.diag(part.matrix)))) * float(ratio)
            sizes[part.name] = rms
            # Where nothing is stated nothing can be exceeded.
            ratios[part.name] = float(ratio) if part.common == 0.0 else 1.0
        slow = sizes.pop("slow_drift")
        before = np.hypot(sizes["drift"], slow)
        ratios["drift"] = float(np.hypot(ratios["drift"], ratios.pop("slow_drift")) / np.sqrt(2.0))
        sizes["drift"] = float(before)
        return NoiseFloor(
            sigma=float(np.sqrt(np.mean(np.diag(self.covariance)))),
            unit=unit,
            components=sizes,
            ratios=ratios,
            source=self.source,
            dof=self.sizes.dof,
        )


def _unit(columns: FloatArray) -> FloatArray:
    size = np.linalg.norm(columns, axis=0)
    return columns / np.where(size > 0.0, size, 1.0)


def _repeating(problem: Problem) -> FloatArray:
    """What is the same at the same position, and offsets of the runs."""
    cell = cells(problem)
    positions = np.equal.outer(cell, np.unique(cell)).astype(np.float64)
    return np.hstack([positions, _runs(problem)])


def _smooth(problem: Problem) -> FloatArray:
    """What is smooth in the head angle or the rate, mounting by mounting, and offsets of runs."""
    run = problem.run
    if run.test == "rate_table":
        x = run.set_rate_dps / max(float(np.max(np.abs(run.set_rate_dps))), 1e-300)
        curves = np.column_stack([np.ones_like(x), x, x**2, x**3, np.abs(x), np.sign(x)])
    else:
        angle = RAD_PER_DEG * run.head_deg
        waves = [wave(k * angle) for k in (1, 2, 3) for wave in (np.sin, np.cos)]
        curves = np.column_stack([np.ones_like(angle), *waves])
    mount = problem.stimulus.column("mount")
    by_mount = np.hstack([curves * (mount == one)[:, None] for one in np.unique(mount)])
    own = np.kron(np.eye(problem.channels), by_mount)
    return np.asarray(np.hstack([own, _runs(problem)]), dtype=np.float64)


def _runs(problem: Problem) -> FloatArray:
    run = problem.run.run
    offsets = np.equal.outer(run, np.unique(run)).astype(np.float64)
    return np.asarray(np.kron(np.eye(problem.channels), offsets), dtype=np.float64)


def _timely(problem: Problem) -> FloatArray:
    """What goes with time: a drift of the noise must not eat them."""
    t = times(problem)
    x = (t - t[0]) / max(float(np.ptp(t)), 1e-9)
    columns = [x, *(np.exp(-x / decay) for decay in _DECAYS)]
    temperature = problem.stimulus.columns.get("temperature_c", np.full(len(x), np.nan))
    if np.all(np.isfinite(temperature)) and np.ptp(temperature) > 0.0:
        warm = temperature - temperature.mean()
        columns.append(warm)
        parts = [np.column_stack(columns)] * problem.channels
        for place, model in enumerate(problem.models):
            acts = model.sensor.input(problem.stimulus)[:, model.sensor.index]
            parts[place] = np.column_stack([parts[place], warm * np.nan_to_num(acts)])
    else:
        parts = [np.column_stack(columns)] * problem.channels
    q = parts[0].shape[1]
    found = np.zeros((len(problem.y), q * problem.channels))
    for place, part in enumerate(parts):
        rows = slice(place * problem.rows, (place + 1) * problem.rows)
        found[rows, place * q : (place + 1) * q] = part
    return found
