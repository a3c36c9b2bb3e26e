"""The sensor, the rig and the laboratory's statements."""

from dataclasses import dataclass, field

from core.model.effect import Sensor
from core.plans.orientation import LEVEL, BaseOrientation
from core.procedures.slow_noise import RateNoise
from core.samples.run import Conditions

HEAD, TABLE, CHAMBER, LEVEL_BASE = "dividing head", "rate table", "climate chamber", "level base"
TOOLS = (HEAD, TABLE, CHAMBER, LEVEL_BASE)


@dataclass(frozen=True, slots=True)
class Bench:
    """What there is to measure with.

    Parameters
    ----------
    kind : ``"accelerometer"`` or ``"gyro"``
    noise : coefficients of the sensor, in m/s^2 or deg/s
    conditions : g, latitude, and the uncertainties of g and of the settings
    axis : case axis of the sensor
    tools : of `TOOLS`
    pause_s : time that a change of the position takes, besides settling
    base : how the head's base plate stands
    """

    kind: str
    noise: RateNoise
    conditions: Conditions
    axis: str = "z"
    tools: frozenset[str] = field(default_factory=lambda: frozenset(TOOLS))
    pause_s: float = 15.0
    base: BaseOrientation = LEVEL

    @property
    def sensor(self) -> Sensor:
        """The sensor with a scale factor of one: its output is in units of the input."""
        return Sensor(self.kind, self.axis, "m/s^2" if self.kind == "accelerometer" else "deg/s")
