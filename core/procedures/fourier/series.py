"""The Fourier series (14) as effects of a model."""

import numpy as np

from core.arrays import FloatArray
from core.model.effect import AXES, Effect, Parameter, Sensor
from core.model.stimulus import Stimulus


class Harmonics(Effect):
    """Fourier series (14) of the output against the elevation of the input axis.

    Parameters
    ----------
    order : highest harmonic, 2 or 3
    cross : the other case axis in the plane of rotation
    """

    id = "harmonics"
    name = "Harmonics of the tumble"
    plain = "how the output changes over a turn of the head"
    equation = "C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a"

    def __init__(self, order: int, cross: str) -> None:
        self._order = order
        self._cross = AXES.index(cross)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """C0, then sine and cosine of each harmonic."""
        return tuple(Parameter(f"c{i}", f"C{i}", sensor.unit) for i in range(2 * self._order + 1))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Harmonics of the angle of the specific force in the plane."""
        alpha = np.arctan2(stimulus.a[:, sensor.index], stimulus.a[:, self._cross])
        columns = [np.ones_like(alpha)]
        for order in range(1, self._order + 1):
            columns += [np.sin(order * alpha), np.cos(order * alpha)]
        return np.column_stack(columns)


class LinearDrift(Effect):
    """A steady change of the output from the first row to the last."""

    id = "linear_drift"
    name = "Drift"
    plain = "the output changes steadily while the head is turned"
    equation = "D * (order - middle) / (last - first)"
    needs = ("order",)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """One: the change over the run."""
        return (Parameter("drift", "D", sensor.unit),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:  # noqa: ARG002
        """Share of the run that has passed, from its middle."""
        order = stimulus.column("order")
        return ((order - order.mean()) / max(float(np.ptp(order)), 1.0))[:, None]
