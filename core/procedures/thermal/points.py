"""Bias and scale factor at each plateau, and how they differ between heating and cooling."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.fit.estimate import Estimate, freedom
from core.fit.result import FitResult
from core.procedures.thermal.plateaus import Plateau

_APART = 0.25
"""Inputs that differ by less than this share of the largest do not tell k from the bias."""


@dataclass(frozen=True, slots=True)
class ThermalPoint:
    """One plateau by itself.

    Parameters
    ----------
    temperature_c : mean temperature
    came : +1 reached by heating, -1 by cooling, 0 the first
    level : which temperature of the cycle
    bias : output at zero input
    scale_factor : NaN where the axis stood in one sense only, which mixes it with the bias
    """

    temperature_c: float
    came: int
    level: int
    bias: Estimate
    scale_factor: Estimate


@dataclass(frozen=True, slots=True)
class Hysteresis:
    """One temperature reached both ways.

    Parameters
    ----------
    temperature_c : which
    bias, scale_factor : value reached by heating less value reached by cooling
    """

    temperature_c: float
    bias: Estimate
    scale_factor: Estimate


def points_of(
    fit: FitResult,
    along: FloatArray,
    modelled: tuple[FloatArray, FloatArray],
    plateaus: Sequence[Plateau],
) -> tuple[ThermalPoint, ...]:
    """Bias and scale factor of each plateau: the model's, and what the residuals add.

    Parameters
    ----------
    fit : of all rows
    along : (n,) input along the sensor's axis
    modelled : bias and scale factor by the model at each plateau
    plateaus : of the run
    """
    units = [fit.parameters[fit.index(name)].unit for name in ("bias", "scale_factor")]
    dof = float(fit.t_dof[fit.index("bias")])
    points: list[ThermalPoint] = []
    for place, plateau in enumerate(plateaus):
        x = along[plateau.rows]
        variance = fit.sigma[plateau.rows] ** 2
        both_ways = float(np.ptp(x)) > _APART * float(np.abs(along).max())
        design = np.column_stack([np.ones_like(x), x]) if both_ways else np.ones((len(x), 1))
        inverse = np.linalg.pinv(design)
        away = inverse @ fit.residuals[plateau.rows]
        u = np.sqrt((inverse**2) @ variance)
        bias = Estimate(float(modelled[0][place] + away[0]), float(u[0]), dof, units[0])
        scale = Estimate(
            float(modelled[1][place] + away[1]) if both_ways else float("nan"),
            float(u[1]) if both_ways else float("nan"),
            dof,
            units[1],
        )
        points.append(ThermalPoint(plateau.temperature_c, plateau.came, plateau.level, bias, scale))
    return tuple(points)


def hysteresis_of(points: Sequence[ThermalPoint]) -> tuple[Hysteresis, ...]:
    """Compare heating with cooling wherever a temperature was reached both ways."""
    found: list[Hysteresis] = []
    for level in sorted({point.level for point in points}):
        heated = [one for one in points if one.level == level and one.came > 0]
        cooled = [one for one in points if one.level == level and one.came < 0]
        if heated and cooled:
            bias, scale = (
                _difference(
                    [getattr(one, name) for one in heated], [getattr(one, name) for one in cooled]
                )
                for name in ("bias", "scale_factor")
            )
            mean = float(np.mean([one.temperature_c for one in (*heated, *cooled)]))
            found.append(Hysteresis(mean, bias, scale))
    return tuple(found)


def _difference(heated: Sequence[Estimate], cooled: Sequence[Estimate]) -> Estimate:
    means = [float(np.mean([one.value for one in side])) for side in (heated, cooled)]
    parts = tuple(one.u / len(side) for side in (heated, cooled) for one in side)
    dof = freedom(parts, tuple(one.dof for one in (*heated, *cooled)))
    return Estimate(means[0] - means[1], float(np.hypot.reduce(parts)), dof, heated[0].unit)
