"""Tumbles that cannot be used: too few angles, the wrong angles, a saturated output."""

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, RankDeficient

_SAME_DEG = 1e-6
_FLAT_DEG = 15.0
"""A sine is not flat over so wide an arc: the same number throughout it is a limit."""


def check_angles(alpha_deg: FloatArray, harmonics: int) -> None:
    """Refuse angles that do not determine the series.

    Raises
    ------
    RankDeficient
        Only multiples of 90 degrees: sin 2a is zero at all of them, cos 2a plus or minus one.
    FitError
        Fewer distinct angles than coefficients.
    """
    distinct = np.unique(np.round(alpha_deg % 360.0 / _SAME_DEG).astype(np.int64))
    distinct = np.unique(distinct % round(360.0 / _SAME_DEG)) * _SAME_DEG
    needed = 2 * harmonics + 1
    if np.all(np.abs((distinct + 45.0) % 90.0 - 45.0) < 2.0 * _SAME_DEG):
        raise RankDeficient(
            ("C3",) if len(distinct) == 4 else ("C3", "C4"),
            "all angles are multiples of 90 degrees, where the second harmonic is invisible;"
            " measure between them, e.g. every 45 or every 5 degrees",
        )
    if len(distinct) < needed:
        raise FitError(
            f"{len(distinct)} different angles for {needed} coefficients; measure at least"
            f" {needed}, better every 5 degrees"
        )


def check_saturation(alpha_deg: FloatArray, y: FloatArray) -> None:
    """Refuse an output that stays at its extreme over an arc.

    Raises
    ------
    FitError
        The same extreme number at angles that span more than a sine can be flat over.
    """
    for extreme, word in ((y.max(), "largest"), (y.min(), "smallest")):
        angles = np.sort(alpha_deg[y == extreme])
        if len(angles) < 3:
            continue
        widest = float(np.max(np.diff(angles, append=angles[0] + 360.0)))
        span = 360.0 - widest
        if _FLAT_DEG < span < 180.0:
            raise FitError(
                f"the output is {extreme:g}, its {word}, over {span:.0f} degrees: it is saturated;"
                " choose a wider range of the sensor"
            )
