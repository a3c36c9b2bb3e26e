"""The result of a fit: an object that says what it knows and what it doubts."""

import math
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import Note
from core.fit.quantiles import student_t
from core.model.effect import Parameter


@dataclass(frozen=True, slots=True)
class LackOfFit:
    """Test of the model against replicates (NIST/SEMATECH e-Handbook 4.4.4.6).

    Parameters
    ----------
    pure_sd : standard deviation among replicates, output units
    pure_dof : its degrees of freedom
    statistic : F = mean square of the lack of fit over that of the pure error
    p_value : probability of a larger F with a right model
    """

    pure_sd: float
    pure_dof: int
    statistic: float
    p_value: float


@dataclass(frozen=True, slots=True, eq=False)
class FitResult:
    """Parameters of one sensor with their uncertainties.

    Parameters
    ----------
    parameters : (p,) names, symbols and units
    values : (p,) estimates
    covariance : (p, p) all components of uncertainty, k = 1
    shared : (p, q) response of the values to one standard deviation of each error that sensors
        measured together have in common (head settings, table settings, g), part of `covariance`;
        the covariance between two sensors is the product of their `shared`
    t_dof : (p,) effective degrees of freedom of each standard uncertainty; inf when sigma is known
    fitted, residuals : (m,) model output and measured minus model, output units
    sigma : (m,) standard uncertainty of each row, output units
    free : (m,) share of each row's variance that the fit leaves in its residual, 1 less the
        leverage; NaN where a file does not tell it
    sigma_source : ``"known"`` (from the accumulations and stated inputs), ``"partly"`` (the same
        and extra scatter as the residuals suggest), ``"residual"`` (from the scatter about the
        model) or ``"none"`` (no degrees of freedom, no uncertainty)
    chi2, dof : sum of squared residuals over their known variances (over `sigma` where none is
        known), rows minus parameters
    p_value : probability of a larger chi-square with a right model; NaN unless variances are known
    condition : condition number of the design with columns of unit length
    lack_of_fit : the test against replicates, None without replicates
    notes : every doubt, not the first
    """

    parameters: tuple[Parameter, ...]
    values: FloatArray
    covariance: FloatArray
    shared: FloatArray
    t_dof: FloatArray
    fitted: FloatArray
    residuals: FloatArray
    sigma: FloatArray
    free: FloatArray
    sigma_source: str
    chi2: float
    dof: int
    p_value: float
    condition: float
    lack_of_fit: LackOfFit | None
    notes: tuple[Note, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names (p,) of the parameters."""
        return tuple(parameter.name for parameter in self.parameters)

    @property
    def stderr(self) -> FloatArray:
        """Standard uncertainties (p,), k = 1."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def correlation(self) -> FloatArray:
        """Correlation matrix (p, p)."""
        u = self.stderr
        return self.covariance / np.outer(u, u)

    def expanded(self, level: float = 0.95) -> FloatArray:
        """Half widths (p,) of the two-sided coverage intervals, by Student t."""
        factors = np.array([student_t(level, float(dof)) for dof in self.t_dof])
        return factors * self.stderr

    def residual_limits(self, level: float = 0.95) -> FloatArray:
        """Half widths (m,) within which the residuals of a right model stay with `level`.

        Where sigma comes from the residuals themselves they cannot exceed what they sum up to;
        their law is then Thompson's tau, not Student's t. Infinite without degrees of freedom.
        """
        free = np.where(np.isfinite(self.free), self.free, 1.0)
        if self.sigma_source != "residual":
            factor = student_t(level, math.inf) if self.sigma_source != "none" else math.inf
        elif self.dof < 2:
            factor = math.sqrt(self.dof) if self.dof else math.inf
        else:
            t = student_t(level, self.dof - 1)
            factor = t * math.sqrt(self.dof / (self.dof - 1 + t**2))
        return factor * self.sigma * np.sqrt(np.maximum(free, 0.0))

    def index(self, name: str) -> int:
        """Place of a parameter.

        Raises
        ------
        KeyError
            The model has no such parameter.
        """
        try:
            return self.names.index(name)
        except ValueError:
            raise KeyError(name) from None

    def value(self, name: str) -> float:
        """Estimate of one parameter."""
        return float(self.values[self.index(name)])

    def u(self, name: str) -> float:
        """Standard uncertainty of one parameter."""
        return float(self.stderr[self.index(name)])
