"""Tell by the angle that a unit computes itself whether it stands in the position that was chosen.

For units that send angles and no raw codes: an angle is not linear in gravity, and needs nothing to
be learned first.
"""

import numpy as np

from core.arrays import FloatArray
from core.procedures.angle_errors import main_angle, wrapped
from core.procedures.recognise import Expectation, Recognition, Verdict

_FAR_DEG = 10.0
"""No unit that is worth checking is so wrong."""


class AngleExpectation(Expectation):
    """What pitch or roll should be in a position.

    Parameters
    ----------
    kind : `PITCH` or `ROLL`: the one channel that the means hold, deg
    """

    def __init__(self, kind: str) -> None:
        super().__init__(1.0, ("",))
        self._kind = kind

    def learn(self, inputs: FloatArray, outputs: FloatArray) -> None:
        """There is nothing to learn."""

    def recognise(
        self, outputs: FloatArray, inputs: FloatArray, labels: tuple[str, ...], chosen: int
    ) -> Recognition:
        """Compare the angle (1,) with those of all positions; see `Expectation.recognise`."""
        expected = main_angle(self._kind, inputs, full_turn=False)
        off = np.abs(wrapped(outputs[0] - expected))
        same = tuple(int(i) for i in np.argsort(off, kind="stable") if off[i] < _FAR_DEG)
        if off[chosen] < _FAR_DEG:
            return Recognition(Verdict.FITS, same, "")
        told = f"the unit tells a {self._kind} of {outputs[0]:.1f} deg"
        if not same:
            return Recognition(
                Verdict.NO_POSITION,
                (),
                f"{told}, which is not {labels[chosen]} and no other position of the plan; check"
                " how the unit is mounted and the head angle",
            )
        names = " or ".join(labels[i] for i in same)
        return Recognition(
            Verdict.OTHER_POSITION, same, f"{told}: this looks like {names}, not {labels[chosen]}"
        )
