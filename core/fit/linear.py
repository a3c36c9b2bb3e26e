"""Weighted least squares of one sensor.

Sigma is an input where the rows bring it (accumulations, stated setting errors), and chi-square
is then an output that may reject the model. Rows without a standard error (the legacy files) are
weighted alike beside the stated setting errors, and their common scatter is found from the
residuals, with Student t for the few degrees of freedom that are left.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, RankDeficient, Severity
from core.fit.quantiles import chi2_sf, f_sf
from core.fit.result import FitResult, LackOfFit
from core.fit.variance import RowVariance, setting_errors
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions

REJECTED = 0.01
"""A model is called rejected below this p-value."""

_FREE = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Measured outputs of one sensor.

    Parameters
    ----------
    y : (n,) means, output units
    se : (n,) their standard errors, NaN where unknown
    se_dof : (n,) degrees of freedom of the standard errors, inf where known well
    """

    y: FloatArray
    se: FloatArray
    se_dof: FloatArray

    @classmethod
    def of(cls, y: FloatArray, se: FloatArray | None = None) -> "Rows":
        """Rows with well-known standard errors, or with none."""
        return cls(y, np.full_like(y, np.nan) if se is None else se, np.full(y.shape, np.inf))


def fit_sensor(
    model: SensorModel, stimulus: Stimulus, rows: Rows, conditions: Conditions
) -> FitResult:
    """Estimate the parameters of one sensor.

    Parameters
    ----------
    model : the effects that act
    stimulus : what acted, n rows
    rows : what was measured, n rows
    conditions : g with its uncertainty and the setting errors; NaN means "not stated"

    Returns
    -------
    FitResult
        With the uncertainty of g and of the settings in its covariance.

    Raises
    ------
    RankDeficient
        The rows leave parameters free; they are named.
    FitError
        A value is not finite, or there are fewer rows than parameters.
    """
    design = model.design(stimulus)
    _check(model, design, rows)
    n = len(rows.y)
    settings = np.zeros((2, n))
    parts = RowVariance(rows.se**2, np.zeros(n), rows.se_dof)
    # The setting error's effect depends on the slope that is being fitted: two rounds settle it
    # to parts in 1e6, since the slope of the first is already right to parts in 1e3.
    variance = _row_variance(design, rows.y, parts)
    solution = _Solution.of(design, rows.y, variance)
    for _ in range(2 if _has_setting_error(conditions) else 0):
        settings = setting_errors(model, solution.values, stimulus, conditions)
        parts = RowVariance(rows.se**2, (settings**2).sum(axis=0), rows.se_dof)
        variance = _row_variance(design, rows.y, parts)
        solution = _Solution.of(design, rows.y, variance)
    shared = np.hstack(
        [solution.inverse * error for error in settings]
        + [_gravity_response(model, stimulus, solution, conditions)]
    )
    return _result(model, stimulus, rows, shared, parts, variance, solution)


@dataclass(frozen=True, slots=True, eq=False)
class _Solution:
    values: FloatArray
    inverse: FloatArray  # (p, n): values = inverse @ y
    condition: float

    @classmethod
    def of(cls, design: FloatArray, y: FloatArray, variance: FloatArray) -> "_Solution":
        weight = 1.0 / np.sqrt(variance)
        length = np.linalg.norm(design, axis=0)
        u, s, vt = np.linalg.svd((design / length) * weight[:, None], full_matrices=False)
        inverse = ((vt.T / s) @ u.T) * weight / length[:, None]
        return cls(inverse @ y, inverse, float(s[0] / s[-1]))


def _has_setting_error(conditions: Conditions) -> bool:
    stated = (conditions.head_u_arcsec, conditions.rate_u_ppm, conditions.rate_u_dps)
    return any(u > 0 for u in stated)


def _check(model: SensorModel, design: FloatArray, rows: Rows) -> None:
    n, p = design.shape
    bad = np.flatnonzero(~np.isfinite(rows.y))
    if bad.size:
        raise FitError(f"row {bad[0] + 1}: the output is not a number")
    names = tuple(parameter.symbol for parameter in model.parameters)
    length = np.linalg.norm(design, axis=0)
    scaled = design / np.where(length > 0, length, 1.0)
    s, vt = np.linalg.svd(scaled, full_matrices=True)[1:]
    rank = int(np.sum(s > _FREE * s[0])) if s.size else 0
    if rank == p:
        return
    # A parameter is free if a direction that the rows do not see moves it.
    free = np.abs(vt[rank:]).max(axis=0) > 1e-6
    raise RankDeficient(
        tuple(name for name, is_free in zip(names, free, strict=True) if is_free),
        f"{n} rows of these positions determine {rank} of {p} parameters; measure positions in"
        " which the missing axes change, or fit fewer parameters",
    )


def _row_variance(design: FloatArray, y: FloatArray, parts: RowVariance) -> FloatArray:
    """Variance of each row; without standard errors the common part comes from the residuals."""
    if parts.known:
        return parts.accumulation + parts.setting
    n, p = design.shape
    if n == p:
        return parts.setting + 1.0
    return parts.setting + _common_variance(design, y, parts.setting)


def _common_variance(design: FloatArray, y: FloatArray, setting: FloatArray) -> float:
    """The common variance s^2 at which chi-square equals its degrees of freedom.

    Mandel and Paule's estimate; zero setting errors give the classical s^2 = RSS/(n - p) in one
    step. Where the stated setting errors alone exceed the scatter, s^2 is their own floor.
    """
    n, p = design.shape

    def excess(common: float) -> float:
        variance: FloatArray = setting + common
        residual = y - design @ _Solution.of(design, y, variance).values
        return float(np.sum(residual**2 / variance)) / (n - p) - 1.0

    residual = y - design @ _Solution.of(design, y, np.ones(n)).values
    # Noise-free data keep the rounding of their largest value as scatter.
    floor = float(np.spacing(np.abs(y).max())) ** 2
    classical = max(float(np.sum(residual**2)) / (n - p), floor)
    if not np.any(setting > 0):
        return classical
    low = classical * 1e-6
    if excess(low) <= 0:
        return low
    high = classical
    while excess(high) > 0:
        high *= 2.0
    for _ in range(60):
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if excess(middle) > 0 else (low, middle)
    return float(np.sqrt(low * high))


def _result(
    model: SensorModel,
    stimulus: Stimulus,
    rows: Rows,
    shared: FloatArray,
    parts: RowVariance,
    variance: FloatArray,
    solution: _Solution,
) -> FitResult:
    n, p = len(rows.y), len(model.parameters)
    dof = n - p
    fitted = model.design(stimulus) @ solution.values
    residuals = rows.y - fitted
    chi2 = float(np.sum(residuals**2 / variance)) if dof else 0.0
    lack = _lack_of_fit(model.design(stimulus), rows.y, residuals)
    covariance = (solution.inverse * variance) @ solution.inverse.T
    notes: list[Note] = []
    if parts.known:
        source = "known"
        t_dof = _welch_satterthwaite(solution.inverse, parts, variance)
        p_value = chi2_sf(chi2, dof) if dof else 1.0
        if p_value < REJECTED:
            covariance *= chi2 / dof
            t_dof = np.minimum(t_dof, dof)
            notes.append(_rejected(p_value, chi2 / dof))
    elif dof:
        source = "residual"
        t_dof = np.full(p, float(dof))
    else:
        source = "none"
        t_dof = np.zeros(p)
        covariance = np.full((p, p), np.nan)
        notes.append(_no_uncertainty(n))
    if lack is not None and lack.p_value < REJECTED:
        notes.append(_lack_note(lack))
    covariance = covariance + np.outer(shared[:, -1], shared[:, -1])
    return FitResult(
        parameters=model.parameters,
        values=frozen(solution.values),
        covariance=frozen(covariance),
        shared=frozen(shared),
        t_dof=frozen(t_dof),
        fitted=frozen(fitted),
        residuals=frozen(residuals),
        sigma=frozen(np.sqrt(variance)),
        sigma_source=source,
        chi2=chi2,
        dof=dof,
        condition=solution.condition,
        lack_of_fit=lack,
        notes=tuple(notes),
    )


def _welch_satterthwaite(
    inverse: FloatArray, parts: RowVariance, variance: FloatArray
) -> FloatArray:
    """Effective degrees of freedom (p,) of the standard uncertainties (GUM, G.2b)."""
    total = (inverse**2) @ variance
    doubt = (inverse**4) @ (parts.accumulation**2 / parts.accumulation_dof)
    with np.errstate(divide="ignore"):
        return np.where(doubt > 0, total**2 / doubt, np.inf)


def _lack_of_fit(design: FloatArray, y: FloatArray, residuals: FloatArray) -> LackOfFit | None:
    """F test against replicates: rows whose design is the same to rounding."""
    scale = np.abs(design).max(axis=0)
    keys = np.round(design / np.where(scale > 0, scale, 1.0), 9) + 0.0
    group = np.unique(keys, axis=0, return_inverse=True)[1].ravel()
    count = np.bincount(group)
    n, p = design.shape
    pure_dof = n - len(count)
    lack_dof = n - p - pure_dof
    if pure_dof < 1 or lack_dof < 1:
        return None
    mean = np.bincount(group, weights=y) / count
    pure = float(np.sum((y - mean[group]) ** 2))
    lack = max(float(np.sum(residuals**2)) - pure, 0.0)
    if pure == 0.0:
        return None
    statistic = (lack / lack_dof) / (pure / pure_dof)
    return LackOfFit(
        float(np.sqrt(pure / pure_dof)), pure_dof, statistic, f_sf(statistic, lack_dof, pure_dof)
    )


def _gravity_response(
    model: SensorModel, stimulus: Stimulus, solution: _Solution, conditions: Conditions
) -> FloatArray:
    """Change (p, 1) of the values by one standard deviation of g, common to all rows."""
    if not conditions.u_g_mps2 > 0:
        return np.zeros((len(solution.values), 1))
    step = 1e-6
    change = model.design(stimulus.scaled_force(1.0 + step)) - model.design(stimulus)
    slope = -solution.inverse @ (change @ solution.values) / step
    return (slope * conditions.u_g_mps2 / conditions.g_mps2)[:, None]


def _no_uncertainty(n: int) -> Note:
    return Note(
        Severity.WARNING,
        "no_uncertainty",
        f"{n} rows for {n} parameters leave no degree of freedom: the numbers have no uncertainty"
        " and nothing can contradict them; repeat positions",
    )


def _rejected(p_value: float, ratio: float) -> Note:
    return Note(
        Severity.WARNING,
        "model_rejected",
        f"the residuals are {np.sqrt(ratio):.1f} times larger than the stated uncertainties of the"
        f" rows allow (p = {p_value:.2g}); all uncertainties were enlarged by that factor, and the"
        " model lacks something",
    )


def _lack_note(lack: LackOfFit) -> Note:
    return Note(
        Severity.WARNING,
        "lack_of_fit",
        f"repeated positions agree to {lack.pure_sd:.3g} but the model misses the means by more"
        f" (F = {lack.statistic:.3g}, p = {lack.p_value:.2g}): the model lacks something",
    )
