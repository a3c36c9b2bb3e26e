"""One number with its uncertainty."""

import math
from dataclasses import dataclass

import numpy as np

from core.fit.quantiles import student_t
from core.fit.result import FitResult


@dataclass(frozen=True, slots=True)
class Estimate:
    """A value, its standard uncertainty and what that rests on.

    Parameters
    ----------
    value : the estimate
    u : standard uncertainty, k = 1; NaN where nothing tells it
    dof : effective degrees of freedom of `u`
    unit : unit of both
    """

    value: float
    u: float
    dof: float
    unit: str

    def expanded(self, level: float = 0.95) -> float:
        """Half width of the two-sided coverage interval, by Student t."""
        return student_t(level, self.dof) * self.u if self.u > 0 else self.u

    @property
    def significant(self) -> bool:
        """Whether zero lies outside the 99 % interval."""
        return abs(self.value) > self.expanded(0.99)

    def scaled(self, factor: float, unit: str) -> "Estimate":
        """The same quantity in another unit, `factor` of which make one of this."""
        return Estimate(self.value * factor, self.u * abs(factor), self.dof, unit)


def parameter(fit: FitResult, name: str) -> Estimate:
    """One parameter of a fit."""
    place = fit.index(name)
    return Estimate(
        float(fit.values[place]),
        float(fit.stderr[place]),
        float(fit.t_dof[place]),
        fit.parameters[place].unit,
    )


def ratio(fit: FitResult, over: str, under: str, unit: str) -> Estimate:
    """One parameter of a fit divided by another, with their correlation."""
    i, k = fit.index(over), fit.index(under)
    value = float(fit.values[i] / fit.values[k])
    slope = np.array([1.0, -value]) / fit.values[k]
    u = float(np.sqrt(slope @ fit.covariance[np.ix_([i, k], [i, k])] @ slope))
    parts = slope * fit.stderr[[i, k]]
    dofs = (float(fit.t_dof[i]), float(fit.t_dof[k]))
    dof = dofs[0] if dofs[0] == dofs[1] else freedom((float(parts[0]), float(parts[1])), dofs)
    return Estimate(value, u, dof, unit)


def quotient(over: Estimate, under: Estimate, unit: str) -> Estimate:
    """One estimate divided by another that is independent of it (GUM, G.2b for the freedom)."""
    value = over.value / under.value
    parts = (over.u / under.value, value * under.u / under.value)
    u = math.hypot(*parts)
    return Estimate(value, u, freedom(parts, (over.dof, under.dof)), unit)


def freedom(parts: tuple[float, ...], dofs: tuple[float, ...]) -> float:
    """Effective degrees of freedom of a root sum of squares (Welch-Satterthwaite)."""
    total = math.fsum(part**2 for part in parts)
    if not total > 0:
        return min(dofs)
    doubt = math.fsum(
        (part**2 / total) ** 2 / dof for part, dof in zip(parts, dofs, strict=True) if dof > 0
    )
    if any(dof <= 0 and part != 0 for part, dof in zip(parts, dofs, strict=True)):
        return 0.0
    return 1.0 / doubt if doubt > 0 else math.inf
