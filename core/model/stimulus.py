"""What acted on the sensor, row by row."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.plans.orientation import (
    LEVEL,
    BaseOrientation,
    case_from_base,
    earth_rate,
    specific_force_in_base,
)
from core.samples.run import Run


@dataclass(frozen=True, slots=True, eq=False)
class Stimulus:
    """True input of a sensor in its case axes.

    Parameters
    ----------
    a : (n, 3) specific force, m/s^2; +g on an axis that points up at rest (2.3)
    w : (n, 3) angular rate, deg/s
    da_dhead : (n, 3) change of `a` with the head angle, (m/s^2)/rad; zeros where there is no head
    dw_drate : (n, 3) change of `w` with the set rate of the table; zeros where there is no table
    columns : further regressors, (n,) each, by the column names of a `Run`
    """

    a: FloatArray
    w: FloatArray
    da_dhead: FloatArray
    dw_drate: FloatArray
    columns: Mapping[str, FloatArray] = field(default_factory=dict[str, FloatArray])

    def __len__(self) -> int:
        return self.a.shape[0]

    def column(self, name: str) -> FloatArray:
        """Return a regressor.

        Raises
        ------
        FitError
            The data hold no such column, or it has gaps.
        """
        column = self.columns.get(name)
        if column is None or not np.all(np.isfinite(column)):
            raise FitError(f"the data hold no complete column {name!r}, which the model needs")
        return column

    def scaled_force(self, factor: float) -> "Stimulus":
        """The same with `a` multiplied: what another value of g would have done."""
        return replace(self, a=self.a * factor, da_dhead=self.da_dhead * factor)

    def turned(self, head_rad: float) -> "Stimulus":
        """The same with every head angle moved by a small angle."""
        return replace(self, a=self.a + self.da_dhead * head_rad)

    def spun(self, rate_dps: float) -> "Stimulus":
        """The same with every set rate of the table moved by a small rate."""
        return replace(self, w=self.w + self.dw_drate * rate_dps)


def stimulus_of(
    run: Run, g: float, *, latitude_deg: float | None = None, base: BaseOrientation = LEVEL
) -> Stimulus:
    """Return what acted on the sensors of a run.

    Parameters
    ----------
    run : a run on the dividing head or the rate table
    g : local gravity, m/s^2
    latitude_deg : adds the rate of the Earth to `w`; without it the Earth stands still
    base : how the head's base plate stands

    Raises
    ------
    FitError
        g is not positive, a mount is unknown or a head angle is missing.
    """
    if not (np.isfinite(g) and g > 0):
        raise FitError(f"local gravity must be a positive number in m/s^2, got {g!r}")
    n = len(run)
    a = np.zeros((n, 3))
    derivative = np.zeros((n, 3))
    w = np.zeros((n, 3))
    up = specific_force_in_base(g, base)
    for row, (mount, angle) in enumerate(zip(run.mount, run.head_deg, strict=True)):
        if not np.isfinite(angle):
            raise FitError(f"row {row + 1}: the head angle is missing")
        try:
            a[row] = case_from_base(mount, float(angle)) @ up
        except ValueError as error:
            raise FitError(f"row {row + 1}: {error}") from error
        # A first harmonic: half the difference a quarter turn away is the exact derivative.
        ahead = case_from_base(mount, float(angle) + 90.0)
        behind = case_from_base(mount, float(angle) - 90.0)
        derivative[row] = (ahead - behind) @ up / 2.0
        if latitude_deg is not None:
            w[row] = earth_rate(mount, float(angle), latitude_deg, base)
    return Stimulus(
        a=a,
        w=w,
        da_dhead=derivative,
        dw_drate=np.zeros((n, 3)),
        columns={
            "head_deg": run.head_deg,
            "set_rate_dps": run.set_rate_dps,
            "temperature_c": run.temperature_c,
            "t_s": run.t_s,
            "order": run.order.astype(np.float64),
            "run": run.run.astype(np.float64),
            **run.extra,
        },
    )
