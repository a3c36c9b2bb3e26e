"""The units that can be bolted on the rig, with their hidden truth.

Output 1 of each assembly, and the triad of the attitude unit, are those of the practicum's tables;
the other outputs of an assembly scatter around them by chance.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.sensor_model import SensorModel
from drivers.virtual.noise import NoiseLevel

_QUIET = NoiseLevel(0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True, eq=False)
class Output:
    """One hidden sensor.

    Parameters
    ----------
    role : role of the channel that carries it
    model, values : what it does to its input, and by how much
    level : its noise
    warm_up : shift of the output while it is one degree below its warm temperature
    limit : outputs beyond it are clipped
    """

    role: str
    model: SensorModel
    values: FloatArray
    level: NoiseLevel
    warm_up: float
    limit: float

    def value(self, parameter: str) -> float:
        """True value of a parameter by its name."""
        names = [p.name for p in self.model.parameters]
        return float(self.values[names.index(parameter)])

    def shifted(self, drift: float) -> "Output":
        """The same with another bias."""
        names = [p.name for p in self.model.parameters]
        values = self.values.copy()
        values[names.index("bias")] += drift
        return replace(self, values=frozen(values))

    def with_effect(self, effect_id: str, values: tuple[float, ...]) -> "Output":
        """The same with one more effect.

        Raises
        ------
        ValueError
            There is no such effect, or it has another number of parameters.
        """
        effect = CATALOGUE.get(effect_id)
        playable = sorted(name for name, each in CATALOGUE.items() if each.instant)
        if effect is None:
            raise ValueError(f"no effect {effect_id!r}; there are {', '.join(playable)}")
        if not effect.instant:
            raise ValueError(f"effect {effect_id} acts between rows; a rig plays what acts at once")
        wanted = effect.parameters(self.model.sensor)
        shape = tuple(parameter for parameter, _ in effect.shape)
        if len(values) not in (len(wanted), len(wanted) + len(shape)):
            names = ", ".join(f"{p.name} [{p.unit}]" for p in (*wanted, *shape))
            raise ValueError(f"effect {effect_id} takes {len(wanted)} values ({names})")
        numbers, given = values[: len(wanted)], values[len(wanted) :]
        sensor = replace(self.model.sensor, response=self._response())
        return replace(
            self,
            model=replace(self.model, sensor=sensor).with_effect(
                effect.shaped(*given) if given else effect
            ),
            values=frozen([*self.values, *numbers]),
        )

    def _response(self) -> tuple[float, ...]:
        """Output per input along the case axes; effects of the rig act through it."""
        known = dict(zip((p.name for p in self.model.parameters), self.values, strict=True))
        own = self.model.sensor.axis
        return tuple(
            float(known.get("scale_factor" if axis == own else f"cross_axis_{axis}", 0.0))
            for axis in AXES
        )


@dataclass(frozen=True, slots=True)
class Housekeeping:
    """A channel that no input drives: a thermometer, an amplitude, a status.

    Parameters
    ----------
    at_27 : its value at 27 degC
    per_c : change per degC
    level : its noise
    """

    at_27: float
    per_c: float = 0.0
    level: NoiseLevel = _QUIET


@dataclass(frozen=True, slots=True)
class Device:
    """A unit for the rig.

    Parameters
    ----------
    id : name in ``sim://`` addresses
    profile_id : the profile that it speaks
    outputs : its sensors
    housekeeping : other channels, by role or, where they have none, by name
    magnetic : codes of the magnetometers per nT; 0 for none
    bandwidth_hz : of the sensors
    heating_c, heating_tau_s : rise of its own temperature after a cold start, and how fast
    copies : channels, by name, that repeat the output of a role
    identity : its ``serial``, ``model``, ``firmware``
    reply_bytes : length of its answer to an identify command; 0 if it has none
    """

    id: str
    profile_id: str
    outputs: tuple[Output, ...]
    housekeeping: Mapping[str, Housekeeping]
    magnetic: float = 0.0
    bandwidth_hz: float = 20.0
    heating_c: float = 6.0
    heating_tau_s: float = 400.0
    copies: Mapping[str, str] = field(default_factory=dict[str, str])
    identity: Mapping[str, str] = field(default_factory=dict[str, str])
    reply_bytes: int = 0

    @property
    def timed(self) -> bool:
        """Whether some output depends on the time alone."""
        return any(
            effect.timed or "t_s" in effect.needs
            for o in self.outputs
            for effect in o.model.effects
        )

    def with_effect(self, key: str, values: tuple[float, ...]) -> "Device":
        """The same with one more effect, in all outputs or, by ``ROLE/identifier``, in one.

        Raises
        ------
        ValueError
            There is no such output or effect, or the number of values is wrong.
        """
        role, _, effect_id = key.rpartition("/")
        roles = [output.role for output in self.outputs]
        if role and role not in roles:
            raise ValueError(f"no output {role!r}; there are {', '.join(roles)}")
        outputs = tuple(
            output.with_effect(effect_id, values) if role in ("", output.role) else output
            for output in self.outputs
        )
        return replace(self, outputs=outputs)


def make_device(device_id: str, seed: int) -> Device:
    """Return a unit; the seed decides how the outputs of an assembly scatter.

    Raises
    ------
    ValueError
        There is no such device.
    """
    maker = _MAKERS.get(device_id)
    if maker is None:
        raise ValueError(f"no device {device_id!r}; there are {', '.join(_MAKERS)}")
    return maker(np.random.default_rng([seed, 0xDE71CE]))


def _sensor(
    kind: str, axis: str, unit: str, effects: Mapping[str, tuple[float, ...]]
) -> tuple[SensorModel, FloatArray]:
    model = SensorModel(Sensor(kind, axis, unit), tuple(CATALOGUE[name] for name in effects))
    return model, frozen([value for values in effects.values() for value in values])


def _clbacc(rng: np.random.Generator) -> Device:
    """Nine MS9002-like accelerometers along Z; the first is that of Table 1.2."""
    outputs: list[Output] = []
    keeping: dict[str, Housekeeping] = {}
    for number in range(1, 10):
        table = number == 1
        effects = {
            "bias": (59.79,) if table else (rng.normal(0.0, 150.0),),
            "scale_factor": (1328.0691,) if table else (rng.normal(1328.0, 12.0),),
            "cross_axis": (14.2, -56.908344) if table else tuple(rng.normal(0.0, 20.0, 2)),
        }
        outputs.append(
            Output(
                f"adc.{number}",
                *_sensor("accelerometer", "z", "code", effects),
                NoiseLevel(1.6, 0.5, 0.01),
                warm_up=rng.normal(0.0, 3.0),
                limit=32767.0,
            )
        )
        zero = 14798.0 if table else float(rng.normal(14800.0, 120.0))
        keeping[f"temp.adc.{number}"] = Housekeeping(zero, 12.5, NoiseLevel(0.3, 0.2, 0.0))
    return Device(
        "clbacc",
        "adc_board9",
        tuple(outputs),
        keeping,
        identity={"model": "Colibrys", "serial": "0917", "firmware": "1.4"},
    )


def _clbdus(rng: np.random.Generator) -> Device:
    """Nine ADXRS610-like gyros along Z; the first is that of Tables 3.2 and 3.3."""
    outputs: list[Output] = []
    keeping: dict[str, Housekeeping] = {}
    for number in range(1, 10):
        table = number == 1
        effects = {
            "bias": (-438.08364,) if table else (rng.normal(-450.0, 150.0),),
            "scale_factor": (-79.378668,) if table else (rng.normal(-79.4, 0.8),),
            "cross_axis": tuple(rng.normal(0.0, 0.6, 2)),
            "g_sensitivity": (0.42, 1.167105, -0.0091737508)
            if table
            else tuple(rng.normal(0.0, 0.8, 3)),
        }
        outputs.append(
            Output(
                f"adc.{number}",
                *_sensor("gyro", "z", "code", effects),
                NoiseLevel(4.0, 0.6, 0.01),
                warm_up=rng.normal(0.0, 6.0),
                limit=32767.0,
            )
        )
        zero = 24798.0 if table else float(rng.normal(24800.0, 90.0))
        keeping[f"temp.adc.{number}"] = Housekeeping(zero, 28.0, NoiseLevel(0.4, 0.3, 0.0))
    return Device(
        "clbdus",
        "adxrs_board9",
        tuple(outputs),
        keeping,
        identity={"model": "ADXRS610", "serial": "Gyro31", "firmware": "1.2"},
    )


# Table 2.2 by (2.4): rows are the sensors X, Y, Z; codes per m/s^2 and codes.
_POINTER_K = (
    (-1334.9887, -12.821846, -72.560802),
    (35.687929, -1338.8340, 11.711567),
    (1.4428271, 14.394634, 1334.9765),
)
_POINTER_U0 = (-378.7525, -194.9475, -229.76375)
_POINTER_RATE = (61.4, -60.8, 61.9)
_POINTER_RATE_ZERO = (-517.0, -231.0, 148.0)


def _pointer(rng: np.random.Generator) -> Device:
    """The attitude unit PW09 of Tables 2.2 and 2.4."""
    outputs: list[Output] = []
    keeping: dict[str, Housekeeping] = {}
    for index, axis in enumerate("xyz"):
        row = _POINTER_K[index]
        others = tuple(row[other] for other in range(3) if other != index)
        acc = {"bias": (_POINTER_U0[index],), "scale_factor": (row[index],), "cross_axis": others}
        gyro = {
            "bias": (_POINTER_RATE_ZERO[index],),
            "scale_factor": (_POINTER_RATE[index],),
            "cross_axis": tuple(rng.normal(0.0, 0.5, 2)),
            "g_sensitivity": tuple(rng.normal(0.0, 1.0, 3)),
        }
        outputs.append(
            Output(
                f"acc.{axis}",
                *_sensor("accelerometer", axis, "code", acc),
                NoiseLevel(1.6, 0.4, 0.01),
                warm_up=rng.normal(0.0, 3.0),
                limit=32767.0,
            )
        )
        outputs.append(
            Output(
                f"rate.{axis}",
                *_sensor("gyro", axis, "code", gyro),
                NoiseLevel(3.0, 0.8, 0.01),
                warm_up=rng.normal(0.0, 6.0),
                limit=32767.0,
            )
        )
        steady = NoiseLevel(0.2, 0.1, 0.0)
        keeping[f"temp.rate.{axis}"] = Housekeeping(25365.0 + 40.0 * index, 26.0, steady)
        keeping[f"temp.acc.{axis}"] = Housekeeping(7963.0 + 25.0 * index, 11.0, steady)
        keeping[f"temp.mag.{axis}"] = Housekeeping(7872.0 - 15.0 * index, 10.5, steady)
    keeping["supply"] = Housekeeping(12.0, 0.0, NoiseLevel(1e-3, 0.0, 0.0))
    return Device(
        "pointer",
        "pw09_raw",
        tuple(outputs),
        keeping,
        magnetic=0.1,
        identity={"model": "MiniAHRS", "serial": "PW09", "firmware": "MiniAhrs 2.12"},
        reply_bytes=174,
    )


def _cvg25(rng: np.random.Generator) -> Device:
    """The vibratory gyro CVG25 of figures 5.3 and 5.5: volts, 0.024 V per deg/s."""
    volts_per_dps = 0.024
    effects = {
        "bias": (-2.4e-4,),
        "scale_factor": (volts_per_dps * (1.0 + rng.normal(0.0, 2e-3)),),
        "cross_axis": tuple(volts_per_dps * rng.normal(0.0, 3e-3, 2)),
        "g_sensitivity": tuple(volts_per_dps * rng.normal(0.0, 1e-5, 3)),
    }
    # Angle random walk 2e-4 deg/s/sqrt(Hz) two-sided, bias instability 0.05 deg/h.
    level = NoiseLevel(
        2e-4 * np.sqrt(2.0) * volts_per_dps, 1.4e-5 * volts_per_dps, 1e-7 * volts_per_dps
    )
    output = Output("rate.z", *_sensor("gyro", "z", "V", effects), level, warm_up=3e-5, limit=2.4)
    keeping = {
        "temp": Housekeeping(27.0, 1.0, NoiseLevel(0.002, 0.0, 0.0)),
        "AntiNodePeriod": Housekeeping(23.733621597, 6.3e-4, NoiseLevel(1e-7, 0.0, 0.0)),
        "ExcitationDelay": Housekeeping(14.333653450, 2e-3, NoiseLevel(1e-6, 0.0, 0.0)),
        "AntiNodeAmplitude": Housekeeping(1.899955, 1e-6, NoiseLevel(2e-6, 0.0, 0.0)),
        "ExcitationAmpl": Housekeeping(1.0866, 1.2e-3, NoiseLevel(3e-5, 1e-5, 0.0)),
        "QuadratureAmpl": Housekeeping(0.0710, 2e-5, NoiseLevel(4e-5, 1e-5, 0.0)),
        "QuadratureError": Housekeeping(0.0, 0.0, NoiseLevel(1e-5, 0.0, 0.0)),
        "CoriolisError": Housekeeping(0.0, 0.0, NoiseLevel(1e-5, 0.0, 0.0)),
        "NodeAmplitude": Housekeeping(1.2e-3, 1e-6, NoiseLevel(1e-6, 0.0, 0.0)),
    }
    return Device(
        "cvg25",
        "cvgx48",
        (output,),
        keeping,
        bandwidth_hz=40.0,
        heating_c=9.0,
        heating_tau_s=900.0,
        copies={"GyroOut_RAW": "rate.z"},
        identity={"model": "CVG25", "serial": "25-143"},
    )


_MAKERS = {"clbacc": _clbacc, "pointer": _pointer, "clbdus": _clbdus, "cvg25": _cvg25}
