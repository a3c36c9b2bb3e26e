"""Where the case axes point in the picture of the dividing head.

The picture looks along the shaft from its free end towards the head: the base axis s comes out of
the plane towards the viewer, l points to the right and v up.
"""

from dataclasses import dataclass

from core.arrays import FloatArray
from core.plans.orientation import case_from_base, tilter_rotation
from gui.widgets.states import Pose

ALONG_VIEW = 0.2
"""An axis with a smaller part in the plane than this is drawn as coming or going."""


@dataclass(frozen=True, slots=True)
class AxisMark:
    """One case axis in the plane of the picture.

    Parameters
    ----------
    name : ``"X"``, ``"Y"`` or ``"Z"``
    right, up : part of the unit vector in the plane
    toward : its part towards the viewer
    """

    name: str
    right: float
    up: float
    toward: float

    @property
    def in_plane(self) -> bool:
        """Whether it is drawn as an arrow; otherwise as a circled dot or cross."""
        return self.right**2 + self.up**2 > ALONG_VIEW**2


def case_axes(pose: Pose) -> FloatArray:
    """Rows X, Y, Z of the case in base components s, l, v; (3, 3).

    Raises
    ------
    ValueError
        The pose names no mount.
    """
    axes = case_from_base(pose.mount, pose.head_deg)
    return tilter_rotation(*pose.tilt_deg) @ axes if any(pose.tilt_deg) else axes


def axis_marks(axes: FloatArray) -> tuple[AxisMark, ...]:
    """Return how to draw the rows of `axes`, (3, 3) in base components s, l, v."""
    return tuple(
        AxisMark(name, float(right), float(up), float(toward))
        for name, (toward, right, up) in zip("XYZ", axes, strict=True)
    )
