"""What the variance of a row is made of.

The standard error of the accumulation, and the error of the
setting (head angle, table rate) times the local slope of the output. The setting error must not
be hidden: an output that repeats well on a worn table otherwise gives intervals that miss.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus
from core.samples.run import Conditions
from core.units import PPM, RAD_PER_ARCSEC


@dataclass(frozen=True, slots=True, eq=False)
class RowVariance:
    """Variance of each row, by origin, output units squared.

    Parameters
    ----------
    accumulation : (n,) square of the standard error of the mean; NaN where unknown
    setting : (n,) effect of the setting error of head or table
    accumulation_dof : (n,) degrees of freedom of the standard error, inf where it is known well
    """

    accumulation: FloatArray
    setting: FloatArray
    accumulation_dof: FloatArray

    @property
    def known(self) -> bool:
        """Whether every row brought a positive standard error of its own."""
        return bool(np.all(np.isfinite(self.accumulation)) and np.all(self.accumulation > 0))


def setting_errors(
    model: SensorModel, values: FloatArray, stimulus: Stimulus, conditions: Conditions
) -> FloatArray:
    """Change of each row's output by one standard deviation of its own setting error, signed.

    The slope is that of the model at `values`, so a fit calls this again after each solution.

    Returns
    -------
    (2, n) : by the head's angle error and by the table's rate error, output units. Other channels
        measured at the same time have the same errors, which correlates their parameters.
    """
    errors = np.zeros((2, len(stimulus)))
    u_head = conditions.head_u_arcsec * RAD_PER_ARCSEC
    if u_head > 0:
        step = 1e-4
        ahead = model.predict(stimulus.turned(step), values)
        behind = model.predict(stimulus.turned(-step), values)
        errors[0] = u_head * (ahead - behind) / (2.0 * step)
    if conditions.rate_u_ppm > 0 or conditions.rate_u_dps > 0:
        u_rate = rate_uncertainty(stimulus, conditions)
        step = 1e-3
        ahead = model.predict(stimulus.spun(step), values)
        behind = model.predict(stimulus.spun(-step), values)
        errors[1] = u_rate * (ahead - behind) / (2.0 * step)
    return errors


def rate_uncertainty(stimulus: Stimulus, conditions: Conditions) -> FloatArray:
    """Standard uncertainty (n,) of the set rate, deg/s: absolute and relative part combined."""
    rates = stimulus.columns.get("set_rate_dps")
    if rates is None:
        return np.zeros(len(stimulus))
    relative = np.nan_to_num(conditions.rate_u_ppm) * PPM * np.abs(np.nan_to_num(rates))
    absolute = np.nan_to_num(conditions.rate_u_dps) * np.isfinite(rates)
    return np.hypot(relative, absolute)
