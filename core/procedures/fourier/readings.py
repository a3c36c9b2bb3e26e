"""Angles and readings as a run."""

from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import FitError
from core.samples.run import Run

UPRIGHT, FLIPPED = "Z_to@-90", "Z_from@-90"
"""Mounts in which X is level at head angle 0 and rises with it, Y up and Y down at 0."""


def run_of_angles(
    head_deg: FloatArray | Sequence[float],
    u: FloatArray,
    unit: str,
    *,
    u_se: FloatArray | None = None,
    flipped: bool = False,
    device: str = "",
) -> Run:
    """Readings of one accelerometer in the arrangement of the source as a run.

    Parameters
    ----------
    head_deg : (m,) elevation of the input axis by the head's scale
    u : (m,) or (m, r) readings of r realisations
    unit : of the readings
    u_se : their standard errors, same shape
    flipped : the sensor was turned by 180 degrees about its input axis in the fixture

    Raises
    ------
    FitError
        There are more angles than readings, or fewer.
    """
    angles = np.asarray(head_deg, dtype=np.float64)
    readings = np.asarray(u, dtype=np.float64)
    readings = readings[:, None] if readings.ndim == 1 else readings
    if angles.ndim != 1 or readings.ndim != 2 or len(readings) != len(angles):
        raise FitError(
            f"{angles.shape} angles for {np.shape(u)} readings; one angle a row is needed"
        )
    m, r = readings.shape
    n = m * r
    unknown = np.full(n, np.nan)
    realisation: IntArray = np.arange(n, dtype=np.int64) // m + 1
    errors = unknown if u_se is None else np.reshape(u_se, (m, r)).T.ravel()
    return Run(
        test="dividing_head",
        sensor="accelerometer",
        device=device,
        channels=("u",),
        axes=("x",),
        unit=unit,
        y=readings.T.reshape(n, 1),
        y_se=errors[:, None],
        run=realisation,
        order=np.arange(n, dtype=np.int64),
        mount=(FLIPPED if flipped else UPRIGHT,) * n,
        head_deg=np.tile(angles, r),
        set_rate_dps=unknown,
        temperature_c=unknown,
        t_s=unknown,
    )
