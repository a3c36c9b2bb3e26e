"""Weighted least squares of one sensor.

Sigma is an input where the rows bring it (accumulations, stated setting errors), and chi-square
is then an output that may reject the model. Rows without a standard error (the legacy files) are
weighted alike, and their common scatter beside the stated setting errors is found from the
residuals, with Student t for the few degrees of freedom that are left.

A standard error tells the noise within an accumulation, not the drift from one to the next. Where
the repeatability is declared unknown, extra scatter is allowed for as the residuals suggest.

Measured coverage of the 95 % intervals: 94 to 96 % where the standard errors are known well, 92 to
96 % where they rest on ten degrees of freedom, 95 % from residuals alone, and 94 to 99 % from
residuals beside stated setting errors (the more, the less the residuals show).
"""

from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, Severity
from core.fit.design import Design, Solution
from core.fit.lack import REJECTED, lack_note, lack_of_fit, model_p_value, rejected_note
from core.fit.quantiles import student_t_dof
from core.fit.result import FitResult
from core.fit.scatter import Scatter, common_scatter, extra_scatter, rounding_variance
from core.fit.variance import RowVariance, setting_errors
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions


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
    return fit_design(Design.of(model, stimulus), rows, conditions)


def fit_design(design: Design, rows: Rows, conditions: Conditions) -> FitResult:
    """Estimate the parameters of one sensor over a design that was prepared before.

    Parameters
    ----------
    design : the model over its stimulus, shared by sensors that were measured together
    rows, conditions : as `fit_sensor`

    Raises
    ------
    FitError
        An output is not finite.
    """
    bad = np.flatnonzero(~np.isfinite(rows.y))
    if bad.size:
        raise FitError(f"row {bad[0] + 1}: the output is not a number")
    model, stimulus = design.model, design.stimulus
    settings = np.zeros((2, len(rows.y)))
    state = _State.of(design, rows, settings, 0.0)
    if _has_setting_error(conditions):
        # The setting error acts by the slope that is being fitted; equal weights find that to
        # parts in 1e3, which changes the weights of the second round by no more.
        settings = setting_errors(model, state.solution.values, stimulus, conditions)
        state = _State.of(design, rows, settings, 0.0)
    repeatability = _in_output(conditions.repeatability, model, state.solution.values)
    if state.parts.known and repeatability != 0.0:
        state = _State.of(design, rows, settings, repeatability)
    inverse = state.solution.inverse
    shared = np.vstack(
        [inverse.T * error[:, None] for error in settings]
        + [_gravity_response(model, stimulus, state.solution, conditions).T]
    ).T
    result = _result(design, rows, shared, state)
    if state.parts.known and not result.dof and np.isnan(repeatability):
        result = replace(result, notes=(*result.notes, _no_check(len(rows.y))))
    told = int(np.isfinite(rows.se).sum())
    if told and not state.parts.known:
        result = replace(result, notes=(*result.notes, _not_all_told(told, len(rows.y))))
    return result


@dataclass(frozen=True, slots=True, eq=False)
class _State:
    parts: RowVariance
    variance: FloatArray
    scatter: Scatter | None  # where the residuals had to tell a part of it
    solution: Solution

    @classmethod
    def of(cls, design: Design, rows: Rows, settings: FloatArray, repeatability: float) -> "_State":
        drift = np.nan_to_num(repeatability) ** 2
        parts = RowVariance(rows.se**2, (settings**2).sum(axis=0) + drift, rows.se_dof)
        n, p = design.matrix.shape
        scatter = None
        variance: FloatArray
        if parts.known:
            variance = parts.accumulation + parts.setting
            if np.isnan(repeatability) and n > p:
                scatter = extra_scatter(design.matrix, rows.y, variance)
                variance = scatter.variance
        elif n == p:
            variance = parts.setting + 1.0
        elif np.any(parts.setting > 0):
            # The estimates stay those of equal weights, as the pair formulas give them; only their
            # uncertainties know that the settings act on some rows more than on others.
            scatter = common_scatter(design.matrix, rows.y, parts.setting)
            variance = scatter.variance
            return cls(parts, variance, scatter, design.solve(rows.y, np.ones_like(variance)))
        else:
            residual = rows.y - design.matrix @ design.solve(rows.y, parts.setting).values
            common = max(float(residual @ residual) / (n - p), rounding_variance(rows.y))
            variance = common + parts.setting
        return cls(parts, variance, scatter, design.solve(rows.y, variance))


def _has_setting_error(conditions: Conditions) -> bool:
    stated = (conditions.head_u_arcsec, conditions.rate_u_ppm, conditions.rate_u_dps)
    return any(u > 0 for u in stated)


def _in_output(repeatability: float, model: SensorModel, values: FloatArray) -> float:
    """Repeatability in units of the output: that of the input times the scale factor."""
    names = [parameter.name for parameter in model.parameters]
    if not repeatability > 0 or "scale_factor" not in names:
        return repeatability
    return repeatability * abs(float(values[names.index("scale_factor")]))


def _result(design: Design, rows: Rows, shared: FloatArray, state: _State) -> FitResult:
    n, p = design.matrix.shape
    dof = n - p
    parts, variance, inverse = state.parts, state.variance, state.solution.inverse
    fitted = design.matrix @ state.solution.values
    residuals = rows.y - fitted
    stated = parts.accumulation + parts.setting if parts.known else variance
    chi2 = float(np.sum(residuals**2 / stated)) if dof else 0.0
    lack = lack_of_fit(design.replicate, p, rows.y, residuals, parts.setting)
    covariance = (inverse * variance) @ inverse.T
    free = 1.0 - np.einsum("na,an->n", design.matrix, inverse)
    p_value = float("nan")
    notes: list[Note] = []
    if parts.known:
        source = "known" if state.scatter is None else "partly"
        doubt = (parts.accumulation / variance) ** 2 / parts.accumulation_dof
        # Weights taken from estimated variances pull towards rows that looked quiet by chance
        # (Meier 1953; Kenward and Roger 1997 for independent variances).
        covariance = (inverse * (variance * (1.0 + 4.0 * free * doubt))) @ inverse.T
        t_dof = _welch_satterthwaite(inverse, parts, variance)
        if dof:
            p_value = model_p_value(chi2, dof, float(np.sum(free**2 * doubt)))
        if state.scatter is not None:
            t_dof = np.minimum(t_dof, _dof_of_scatter(state.scatter, covariance))
        if p_value < REJECTED:
            notes.append(rejected_note(p_value, chi2 / dof, state.scatter is not None))
        if p_value < REJECTED and state.scatter is None:
            covariance *= chi2 / dof
            t_dof = np.minimum(t_dof, dof)
    elif dof:
        source = "residual"
        t_dof = np.full(p, float(dof))
        if state.scatter is not None:
            t_dof = _dof_of_scatter(state.scatter, covariance)
    else:
        source = "none"
        t_dof = np.zeros(p)
        covariance = np.full((p, p), np.nan)
        notes.append(_no_uncertainty(n))
    if lack is not None and lack.p_value < REJECTED:
        notes.append(lack_note(lack))
    covariance = covariance + np.outer(shared[:, -1], shared[:, -1])
    return FitResult(
        parameters=design.model.parameters,
        values=frozen(state.solution.values),
        covariance=frozen(covariance),
        shared=frozen(shared),
        t_dof=frozen(t_dof),
        fitted=frozen(fitted),
        residuals=frozen(residuals),
        sigma=frozen(np.sqrt(variance)),
        free=frozen(free),
        sigma_source=source,
        chi2=chi2,
        dof=dof,
        p_value=p_value,
        condition=state.solution.condition,
        lack_of_fit=lack,
        notes=tuple(notes),
    )


def _dof_of_scatter(scatter: Scatter, covariance: FloatArray) -> FloatArray:
    """Degrees of freedom (p,) whose Student t gives the intervals that the scatter asks for."""
    factors = scatter.half_widths() / np.sqrt(np.diag(covariance))
    return np.array([student_t_dof(float(factor)) for factor in factors])


def _welch_satterthwaite(
    inverse: FloatArray, parts: RowVariance, variance: FloatArray
) -> FloatArray:
    """Effective degrees of freedom (p,) of the standard uncertainties (GUM, G.2b)."""
    total = (inverse**2) @ variance
    doubt = (inverse**4) @ (parts.accumulation**2 / parts.accumulation_dof)
    with np.errstate(divide="ignore"):
        return np.where(doubt > 0, total**2 / doubt, np.inf)


def _gravity_response(
    model: SensorModel, stimulus: Stimulus, solution: Solution, conditions: Conditions
) -> FloatArray:
    """Change (p, 1) of the values by one standard deviation of g, common to all rows."""
    if not conditions.u_g_mps2 > 0:
        return np.zeros((len(solution.values), 1))
    step = 1e-6
    change = model.design(stimulus.scaled_force(1.0 + step)) - model.design(stimulus)
    slope = -solution.inverse @ (change @ solution.values) / step
    return (slope * conditions.u_g_mps2 / conditions.g_mps2)[:, None]


def _not_all_told(told: int, n: int) -> Note:
    return Note(
        Severity.WARNING,
        "standard_errors_unused",
        f"only {told} of {n} rows bring a usable standard error; none is used, and the scatter of"
        " the residuals stands for all",
    )


def _no_check(n: int) -> Note:
    return Note(
        Severity.WARNING,
        "no_check",
        f"{n} rows for {n} parameters leave no residual that could show the drift between"
        " accumulations, and the intervals do not allow for it; repeat positions",
    )


def _no_uncertainty(n: int) -> Note:
    return Note(
        Severity.WARNING,
        "no_uncertainty",
        f"{n} rows for {n} parameters leave no degree of freedom: the numbers have no uncertainty"
        " and nothing can contradict them; repeat positions",
    )
