"""What acted on the sensor, row by row."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import FitError
from core.plans.orientation import (
    LEVEL,
    NO_TILT,
    BaseOrientation,
    case_from_base,
    earth_rate,
    specific_force_in_base,
    tilter_rotation,
)
from core.samples.run import Run
from core.units import ARCMIN_PER_DEG

TABLE = "rate_table"
"""The test of a run that was made on the rate table."""


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

    def rows(self, chosen: Sequence[int] | IntArray) -> "Stimulus":
        """The stimulus of these rows only, in this order."""
        index = np.asarray(chosen, dtype=np.int64)
        return Stimulus(
            a=self.a[index],
            w=self.w[index],
            da_dhead=self.da_dhead[index],
            dw_drate=self.dw_drate[index],
            columns={name: column[index] for name, column in self.columns.items()},
        )

    def scaled_force(self, factor: float) -> "Stimulus":
        """The same with `a` multiplied: what another value of g would have done."""
        return replace(self, a=self.a * factor, da_dhead=self.da_dhead * factor)

    def turned(self, head_rad: float) -> "Stimulus":
        """The same with every head angle moved by a small angle."""
        return replace(self, a=self.a + self.da_dhead * head_rad)

    def spun(self, rate_dps: float) -> "Stimulus":
        """The same with every set rate of the table moved by a small rate."""
        return replace(self, w=self.w + self.dw_drate * rate_dps)


def stack(*stimuli: Stimulus) -> Stimulus:
    """Put the rows of several runs one below the other; a column that one lacks is NaN there."""
    names = dict.fromkeys(name for stimulus in stimuli for name in stimulus.columns)
    return Stimulus(
        a=np.vstack([stimulus.a for stimulus in stimuli]),
        w=np.vstack([stimulus.w for stimulus in stimuli]),
        da_dhead=np.vstack([stimulus.da_dhead for stimulus in stimuli]),
        dw_drate=np.vstack([stimulus.dw_drate for stimulus in stimuli]),
        columns={
            name: np.concatenate(
                [stimulus.columns.get(name, np.full(len(stimulus), np.nan)) for stimulus in stimuli]
            )
            for name in names
        },
    )


def stimulus_of(
    run: Run,
    g: float,
    *,
    latitude_deg: float | None = None,
    base: BaseOrientation = LEVEL,
    tilter_deg: tuple[float, float, float] = NO_TILT,
) -> Stimulus:
    """Return what acted on the sensors of a run.

    Parameters
    ----------
    run : a run on the dividing head or the rate table
    g : local gravity, m/s^2; NaN on the rate table leaves `a` unknown
    latitude_deg : adds the rate of the Earth to `w`; without it the Earth stands still
    base : how the head's base plate stands; on the rate table how its axis leans from the vertical
    tilter_deg : yaw, pitch, roll that a tilter adds between the head's plate and the case

    Raises
    ------
    FitError
        g is not positive, a mount is unknown, a head angle or a set rate is missing.

    Notes
    -----
    The axis of the rate table is vertical. A mount names the case axis along it as it does along
    the shaft of the head: ``Z_from`` has Z up, ``Z_to`` down. Where no mount is given it is the
    axis of the sensors. A positive set rate is counter-clockwise seen from above, so that the axis
    which points up feels it positive. Gravity and the rate of the Earth act along the table's axis
    alone: their level parts average out over a turn, and what a standing table leaves of them
    reaches an output only by its cross-axis sensitivity.
    """
    if not (np.isfinite(g) and g > 0) and not (run.test == TABLE and np.isnan(g)):
        raise FitError(f"local gravity must be a positive number in m/s^2, got {g!r}")
    acting = _on_table if run.test == TABLE else _on_head
    a, w, da_dhead, dw_drate = acting(run, g, latitude_deg, base)
    if any(tilter_deg):
        tilt = tilter_rotation(*tilter_deg).T
        a, w, da_dhead, dw_drate = a @ tilt, w @ tilt, da_dhead @ tilt, dw_drate @ tilt
    return Stimulus(
        a=a,
        w=w,
        da_dhead=da_dhead,
        dw_drate=dw_drate,
        columns={
            "head_deg": run.head_deg,
            "set_rate_dps": run.set_rate_dps,
            "temperature_c": run.temperature_c,
            "t_s": run.t_s,
            "order": run.order.astype(np.float64),
            "run": run.run.astype(np.float64),
            "mount": _mount_numbers(run),
            **run.extra,
        },
    )


def _mount_numbers(run: Run) -> FloatArray:
    """Each mount's number, from 0, as they first appear; columns hold numbers alone."""
    known = {mount: number for number, mount in enumerate(dict.fromkeys(run.mount))}
    return np.array([float(known[mount]) for mount in run.mount])


_Acting = tuple[FloatArray, FloatArray, FloatArray, FloatArray]


def _on_head(run: Run, g: float, latitude_deg: float | None, base: BaseOrientation) -> _Acting:
    n = len(run)
    a, w, derivative = np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n, 3))
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
    return a, w, derivative, np.zeros((n, 3))


def _on_table(run: Run, g: float, latitude_deg: float | None, base: BaseOrientation) -> _Acting:
    missing = np.flatnonzero(~np.isfinite(run.set_rate_dps))
    if missing.size:
        raise FitError(f"row {missing[0] + 1}: the set rate is missing")
    # A table is a head whose shaft points up.
    upright = replace(base, alpha_arcmin=base.alpha_arcmin + 90.0 * ARCMIN_PER_DEG)
    along = table_axes(run)
    force = 0.0 if np.isnan(g) else specific_force_in_base(g, upright)[0]
    earth = 0.0 if latitude_deg is None else earth_rate("X_from", 0.0, latitude_deg, upright)[0]
    a = np.full_like(along, np.nan) if np.isnan(g) else along * force
    return a, along * (run.set_rate_dps[:, None] + earth), np.zeros_like(along), along


def table_axes(run: Run) -> FloatArray:
    """Direction (n, 3) of the upward axis of the rate table in the case, one row a measurement.

    Raises
    ------
    FitError
        A mount is unknown, or there is none and the sensors do not have one axis in common.
    """
    axes = {axis for axis in run.axes if axis}
    if not all(run.mount) and len(axes) > 1:
        raise FitError(
            f"the sensors look along {', '.join(sorted(axes))}, and the run does not say which of"
            " these axes stood along the table's; give a mount, e.g. Z_from for Z up"
        )
    default = f"{(axes or {'z'}).pop().upper()}_from"
    rows: list[FloatArray] = []
    for row, mount in enumerate(run.mount):
        try:
            rows.append(case_from_base(mount or default, 0.0)[:, 0])
        except ValueError as error:
            raise FitError(f"row {row + 1}: {error}") from error
    return np.array(rows)
