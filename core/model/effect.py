"""One named physical cause, written once.

The simulator plays an effect, the fit estimates it, the finder of discrepancies proposes it and
the reports name it; all four through this class.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

from core.arrays import FloatArray
from core.model.stimulus import Stimulus

AXES = ("x", "y", "z")


@dataclass(frozen=True, slots=True)
class Sensor:
    """One output of a unit.

    Parameters
    ----------
    kind : ``"accelerometer"`` or ``"gyro"``
    axis : case axis along which the input axis nominally lies, ``"x"``, ``"y"`` or ``"z"``
    unit : unit of the output
    """

    kind: str
    axis: str
    unit: str

    @property
    def index(self) -> int:
        """0, 1 or 2 for x, y, z."""
        return AXES.index(self.axis)

    @property
    def cross_axes(self) -> tuple[str, str]:
        """The two other case axes, in alphabetical order."""
        first, second = (axis for axis in AXES if axis != self.axis)
        return first, second

    @property
    def input_unit(self) -> str:
        """Unit of the quantity that the sensor measures."""
        return "m/s^2" if self.kind == "accelerometer" else "deg/s"

    def input(self, stimulus: Stimulus) -> FloatArray:
        """The quantity that the sensor measures, (n, 3) on the case axes."""
        return stimulus.a if self.kind == "accelerometer" else stimulus.w


@dataclass(frozen=True, slots=True)
class Parameter:
    """One number of an effect.

    Parameters
    ----------
    name : stable identifier, e.g. ``"cross_axis_y"``
    symbol : as the practicum writes it, e.g. ``"k_xy"``
    unit : unit of the number
    """

    name: str
    symbol: str
    unit: str


class Effect(ABC):
    """A physical cause that adds to the output of a sensor, linear in its parameters.

    Attributes
    ----------
    id : stable identifier
    name : standard name (IEEE 528, 1293, 952 where one exists)
    plain : what it does, in plain words
    equation : the term that it adds to the output U
    needs : columns of the stimulus beyond `a` and `w`
    """

    id: str
    name: str
    plain: str
    equation: str
    needs: tuple[str, ...] = ()

    @abstractmethod
    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """The parameters (p,) of this effect for one sensor."""

    @abstractmethod
    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Return (n, p): the output that one unit of each parameter adds in each row."""
