"""How straight a measured characteristic is: what is left beside its line.

Everything here is linear in the outputs, so every number comes with its uncertainty. Rows weigh
as in the fit; where sigma had to come from the scatter about the line, a bent line would inflate
it, and the scatter about two separate half-lines is taken instead.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.fit.estimate import Estimate
from core.fit.quantiles import chi2_sf, f_sf
from core.fit.result import FitResult
from core.units import PPM

INPUT_UNIT = "deg/s"
_HALF = 0.5
_HIGHEST = 3
"""The highest power of the input that is tested."""


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """What does not depend on the outputs, and sensors measured together have in common.

    Parameters
    ----------
    x : (n,) set rate about the input axis; the Earth's adds the same to every row
    relative : (n,) sigma of the rows in shares of the largest
    leverage : (n,) of the rows in the line
    halves : (n, r) orthonormal basis of two separate half-lines, weighted
    powers : for the second and the third power: orthonormal basis (n, power + 1) of the polynomial
        and the length of its last column beside the others, both for x in shares of its largest
    with_zero, without_zero : (2, 2, n) weights of the outputs in intercept and slope of the lines
        through positive and through negative input; None where one has fewer than two values
    tried : (t,) inputs above zero that were tried in both senses, rising
    answers : (t, n) weights of the outputs in half the difference between the two senses
    both_ways : (h,) inputs that were reached from below and from above
    differences : (h, n) weights of the outputs in the difference between the two ways
    """

    x: FloatArray
    relative: FloatArray
    leverage: FloatArray
    halves: FloatArray
    powers: tuple[tuple[FloatArray, float], ...]
    with_zero: FloatArray | None
    without_zero: FloatArray | None
    tried: FloatArray
    answers: FloatArray
    both_ways: FloatArray
    differences: FloatArray

    @classmethod
    def of(cls, x: FloatArray, relative: FloatArray, came: FloatArray) -> "Shape":
        """Prepare the rows of a line.

        Parameters
        ----------
        x : (n,) set rates
        relative : (n,) what sigma is in proportion to
        came : (n,) above zero where the rate had risen, below where it had fallen, zero if unknown
        """
        weight = 1.0 / relative[:, None]
        one = np.ones_like(x)
        line = _basis(np.column_stack([one, x]) * weight)
        bent = np.column_stack([one, x, np.abs(x), np.sign(x)])
        powers: list[tuple[FloatArray, float]] = []
        for power in range(2, min(_HIGHEST, len(np.unique(x)) - 1) + 1):
            columns = (x / np.abs(x).max())[:, None] ** np.arange(power + 1)
            q, r = np.linalg.qr(columns * weight)
            powers.append((q, float(r[-1, -1])))
        tried, answers = _contrasts(np.abs(x), x > 0, x < 0)
        both_ways, differences = _contrasts(x, came > 0, came < 0)
        return cls(
            x=x,
            relative=relative,
            leverage=np.sum(line**2, axis=1),
            halves=_basis(bent * weight),
            powers=tuple(powers),
            with_zero=_half_lines(x, relative, x >= 0, x <= 0),
            without_zero=_half_lines(x, relative, x > 0, x < 0),
            tried=tried,
            answers=answers / 2.0,
            both_ways=both_ways,
            differences=differences,
        )


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """A characteristic and the line through it.

    Parameters
    ----------
    shape : where it was measured
    y : (n,) outputs
    fit : its fit with `bias` and `scale_factor`
    full_scale : input that ppm of full scale refer to
    """

    shape: Shape
    y: FloatArray
    fit: FitResult
    full_scale: float

    @property
    def x(self) -> FloatArray:
        """Set rates (n,)."""
        return self.shape.x

    @property
    def k(self) -> float:
        """Scale factor of the line."""
        return self.fit.value("scale_factor")

    def branch_sigma(self) -> tuple[FloatArray, float]:
        """Standard uncertainty (n,) of the rows without the bend of the line, and its freedom."""
        if self.fit.sigma_source == "known":
            return self.fit.sigma, float("inf")
        q = self.shape.halves
        dof = len(self.y) - q.shape[1]
        if dof < 1:
            return self.fit.sigma, float(self.fit.dof)
        scaled = self.y / self.shape.relative
        left = scaled - q @ (q.T @ scaled)
        return self.shape.relative * np.sqrt(float(left @ left) / dof), float(dof)


@dataclass(frozen=True, slots=True)
class Term:
    """One more power of the input beside those below it.

    Parameters
    ----------
    power : 2 or 3
    coefficient : output per input to this power, from the polynomial that ends with it
    statistic, p_value : F (chi-square where sigma is known), probability of a larger one without it
    bend_ppm : how far it bends the characteristic at full scale, ppm of full scale
    """

    power: int
    coefficient: Estimate
    statistic: float
    p_value: float
    bend_ppm: float


@dataclass(frozen=True, slots=True)
class Nonlinearity:
    """The largest deviation from the line.

    Parameters
    ----------
    largest : deviation, input units
    at : input where it is
    ppm : the same in ppm of full scale
    full_scale : that full scale, input units
    """

    largest: Estimate
    at: float
    ppm: Estimate
    full_scale: float


@dataclass(frozen=True, slots=True)
class Hysteresis:
    """Difference between outputs reached by rising and by falling input.

    Parameters
    ----------
    mean : rising less falling, over all inputs reached both ways, input units
    largest : the largest such difference, input units
    at : input where it is
    """

    mean: Estimate
    largest: Estimate
    at: float


@dataclass(frozen=True, slots=True)
class Threshold:
    """Smallest input that is answered by at least half of the expected output (IEEE 528).

    Parameters
    ----------
    above : largest tried input that was not answered; 0 if all were
    below : smallest tried input that was
    """

    above: float
    below: float


def nonlinearity(points: Points) -> Nonlinearity:
    """Largest deviation from the least-squares line over the full scale."""
    deviation = points.fit.residuals / points.k
    place = int(np.argmax(np.abs(deviation)))
    sigma, dof = points.branch_sigma()
    own = max(1.0 - float(points.shape.leverage[place]), 0.0)
    u = float(sigma[place]) * math.sqrt(own) / abs(points.k)
    largest = Estimate(float(deviation[place]), u, dof, INPUT_UNIT)
    return Nonlinearity(
        largest,
        float(points.x[place]),
        largest.scaled(1.0 / (points.full_scale * PPM), "ppm"),
        points.full_scale,
    )


def bends(points: Points, output_unit: str) -> tuple[Term, ...]:
    """Test a second and a third power of the input beside the line, as far as the rows allow."""
    known = points.fit.sigma_source == "known"
    span = float(np.abs(points.x).max())
    # With known sigma its own size counts, else only the proportions.
    sigma = points.fit.sigma if known else points.shape.relative
    scale = float(sigma.max())
    scaled = points.y / points.shape.relative
    terms: list[Term] = []
    for power, (q, length) in enumerate(points.shape.powers, start=2):
        dof = len(points.y) - power - 1
        if dof < (0 if known else 1):
            break
        along = q.T @ scaled
        left = scaled - q @ along
        mean_square = scale**2 if known else float(left @ left) / dof
        statistic = float(along[-1]) ** 2 / mean_square if mean_square > 0 else math.inf
        coefficient = Estimate(
            float(along[-1]) / length / span**power,
            math.sqrt(mean_square) / abs(length) / span**power,
            math.inf if known else float(dof),
            f"{output_unit}/({INPUT_UNIT})^{power}",
        )
        bend = coefficient.value * points.full_scale ** (power - 1) / points.k / PPM
        p_value = chi2_sf(statistic, 1) if known else f_sf(statistic, 1, dof)
        terms.append(Term(power, coefficient, statistic, p_value, bend))
    return tuple(terms)


def slopes(points: Points) -> tuple[Estimate, Estimate, Estimate] | None:
    """Scale factors of positive and of negative input, and their asymmetry in ppm.

    Returns
    -------
    tuple or None
        None where one sign of the input has fewer than two values.

    Notes
    -----
    Asymmetry (IEEE 528) is the difference of the two over their mean; rows without input belong
    to both lines.
    """
    lines = points.shape.with_zero
    if lines is None:
        return None
    sigma, dof = points.branch_sigma()
    rows = np.array([lines[0, 1], lines[1, 1], lines[0, 1] - lines[1, 1]])
    up, down, difference = rows @ points.y
    u = np.sqrt(rows**2 @ sigma**2)
    mean = (up + down) / 2.0
    unit = points.fit.parameters[points.fit.index("scale_factor")].unit
    return (
        Estimate(float(up), float(u[0]), dof, unit),
        Estimate(float(down), float(u[1]), dof, unit),
        Estimate(float(difference / mean) / PPM, float(u[2] / abs(mean)) / PPM, dof, "ppm"),
    )


def bias_asymmetry(points: Points) -> Estimate | None:
    """Intercept of positive less that of negative input, in input units.

    A dead band of full width D makes it -D. Rows without input are left out; None where one sign
    of the input has fewer than two values.
    """
    lines = points.shape.without_zero
    if lines is None:
        return None
    sigma, dof = points.branch_sigma()
    # A dead band makes the line through all rows too flat; the two half-lines are not.
    k = float(lines[:, 1].mean(axis=0) @ points.y)
    row = (lines[0, 0] - lines[1, 0]) / k
    return Estimate(float(row @ points.y), float(np.sqrt(row**2 @ sigma**2)), dof, INPUT_UNIT)


def hysteresis(points: Points) -> Hysteresis | None:
    """Compare inputs that were reached from below and from above.

    Returns
    -------
    Hysteresis or None
        None where no input was reached both ways.
    """
    rows = points.shape.differences / points.k
    if not len(rows):
        return None
    sigma, dof = points.branch_sigma()
    found, variance = rows @ points.y, rows**2 @ sigma**2
    weight = 1.0 / variance
    worst = int(np.argmax(np.abs(found)))
    return Hysteresis(
        Estimate(
            float(weight @ found / weight.sum()),
            float(1.0 / np.sqrt(weight.sum())),
            dof,
            INPUT_UNIT,
        ),
        Estimate(float(found[worst]), float(np.sqrt(variance[worst])), dof, INPUT_UNIT),
        float(points.shape.both_ways[worst]),
    )


def threshold(points: Points) -> Threshold | None:
    """Bracket the threshold by the inputs that were tried; None without both signs of one."""
    tried = points.shape.tried
    if not len(tried):
        return None
    silent = tried[points.shape.answers @ points.y / (tried * points.k) < _HALF]
    above = float(silent[-1]) if len(silent) else 0.0
    answered = tried[tried > above]
    return Threshold(above, float(answered[0]) if len(answered) else math.inf)


def _contrasts(
    value: FloatArray, first: NDArray[np.bool_], second: NDArray[np.bool_]
) -> tuple[FloatArray, FloatArray]:
    """Values (t,) with rows of both kinds, and weights (t, n) of first mean less second mean."""
    found: list[float] = []
    rows: list[FloatArray] = []
    for one in np.unique(value).tolist():
        plus, minus = (value == one) & first, (value == one) & second
        if plus.any() and minus.any():
            found.append(one)
            rows.append(plus / plus.sum() - minus / minus.sum())
    return np.array(found), np.array(rows).reshape(len(found), len(value))


def _half_lines(
    x: FloatArray, relative: FloatArray, *sides: NDArray[np.bool_]
) -> FloatArray | None:
    """Weights (2, 2, n) of the outputs in intercept and slope of the line through each side."""
    lines = np.zeros((len(sides), 2, len(x)))
    for line, side in zip(lines, sides, strict=True):
        chosen = np.flatnonzero(side)
        if not chosen.size or np.ptp(x[chosen]) == 0:
            return None
        weight = 1.0 / relative[chosen]
        design = np.column_stack([weight, x[chosen] * weight])
        line[:, chosen] = np.linalg.pinv(design) * weight
    return lines


def _basis(design: FloatArray) -> FloatArray:
    """Orthonormal basis of the columns; a column that the others hold adds nothing."""
    u, s, _ = np.linalg.svd(
        design / np.linalg.norm(design, axis=0).clip(1e-300), full_matrices=False
    )
    return u[:, s > 1e-9 * s[0]]
