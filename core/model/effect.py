"""One named physical cause, written once.

The simulator plays an effect, the fit estimates it, the finder of discrepancies proposes it and
the reports name it; all four through this class.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from enum import Enum

import numpy as np

from core.arrays import FloatArray, IntArray
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
    response : (3,) output per unit of input along the case axes, as far as it is known; effects of
        the rig act through it. Empty for 1 along the own axis and 0 across
    """

    kind: str
    axis: str
    unit: str
    response: tuple[float, ...] = ()

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
    def sensitivity(self) -> FloatArray:
        """Output (3,) per unit of input along the case axes."""
        if self.response:
            return np.array(self.response)
        return np.array([float(axis == self.axis) for axis in AXES])

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


class Kind(Enum):
    """How an effect takes part in a search for what a model lacks."""

    MODEL = "model"
    """Belongs to every calibration model; never proposed."""
    BLOCK = "block"
    """Columns, perhaps at several places or of several shapes."""
    EVENT = "event"
    """Columns at single rows: one thing that went wrong once."""
    RELABEL = "relabel"
    """Rows mean something else than they say; nothing is fitted."""
    EXCHANGE = "exchange"
    """Two rows stand in each other's place; nothing is fitted."""
    NOISE = "noise"
    """How the scatter of a record goes with frequency; no columns."""
    FACT = "fact"
    """A fault of the data that is counted, not fitted; no columns."""


class Effect(ABC):
    """A physical cause that adds to the output of a sensor, linear in its parameters.

    What is not linear (a time constant, a place, a level) is the shape of an instance: every
    instance is an effect itself, and `instances` lists those that the rows could show.

    Attributes
    ----------
    id : stable identifier
    name : standard name (IEEE 528, 1293, 952 where one exists)
    plain : what it does, in plain words
    equation : the term that it adds to the output U
    needs : columns of the stimulus beyond `a` and `w`
    kind : how it takes part in a search
    tests : tests of a `Run` in which it can act
    sensors : kinds of sensor in which it can act
    shared : it acts on all sensors of a unit at once, by the same parameters
    alone : it never acts on all sensors of a unit at once, each by its own parameters
    together : it always does
    seen_as : what its residuals look like
    remedy : what to do about it
    confused_with : identifiers of effects that look alike in some plans
    typical : usual size of its first parameter, by kind of sensor
    instant : it depends on what acts at the moment alone, so that a rig can play it
    timed : it changes with time alone
    log_odds : what speaks for it before the outputs are looked at, natural logarithm
    step : its first parameter is likely a whole number of these; 0 where it is not
    """

    id: str
    name: str
    plain: str
    equation: str
    needs: tuple[str, ...] = ()
    kind: Kind = Kind.MODEL
    tests: tuple[str, ...] = ()
    sensors: tuple[str, ...] = ("accelerometer", "gyro")
    shared: bool = False
    alone: bool = False
    together: bool = False
    seen_as: str = ""
    remedy: str = ""
    confused_with: tuple[str, ...] = ()
    typical: dict[str, float] = {}  # noqa: RUF012
    instant: bool = True
    timed: bool = False
    log_odds: float = 0.0
    step: float = 0.0

    @abstractmethod
    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """The parameters (p,) of this effect for one sensor."""

    @abstractmethod
    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Return (n, p): the output that one unit of each parameter adds in each row."""

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """What this instance is fixed at: time constant, level, row, run..."""
        return ()

    def shaped(self, *values: float) -> "Effect":
        """The instance of this shape.

        Raises
        ------
        ValueError
            It has another number of shape values.
        """
        if len(values) != len(self.shape):
            raise ValueError(f"{self.id} has {len(self.shape)} shape values, not {len(values)}")
        return type(self)(*values) if values else self

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple["Effect", ...]:
        """The places and shapes that these rows could show; this one alone where it has none."""
        return (self,)

    def near(self, fraction: float = 1.0) -> tuple["Effect", ...]:
        """Instances whose shape is so much of a grid step smaller and larger, to refine a grid."""
        return ()

    def at(self, values: FloatArray) -> "Effect":
        """The instance whose columns are right for values (p,) that are not small."""
        return self

    def relabel(self, stimulus: Stimulus, y: FloatArray) -> tuple[Stimulus, FloatArray]:
        """Put right what the rows say; `y` is (n, c). Only for relabelling effects."""
        return stimulus, y

    def exchanges(self, stimulus: Stimulus) -> IntArray:
        """Return (m, 2): pairs of rows that could stand in each other's place."""
        return np.zeros((0, 2), dtype=np.int64)

    def exchanged(self, first: int, second: int) -> "Effect":
        """The instance that exchanges two rows."""
        return self
