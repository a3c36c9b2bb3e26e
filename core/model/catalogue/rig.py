"""Effects of the dividing head and of mounting; the errors of angle act through the sensor."""

import numpy as np

from core.arrays import FloatArray
from core.model.catalogue.terms import (
    HEAD,
    STATIC,
    column,
    indicators,
    levels,
    numbered,
    per_head_angle,
    setups,
    small_gain,
    small_unit,
)
from core.model.effect import Effect, Kind, Parameter, Sensor
from core.model.stimulus import Stimulus
from core.units import RAD_PER_ARCSEC, RAD_PER_DEG

_WORM = (*range(3, 25), 30, 36, 40, 45, 48, 60, 72, 90, 120, 180)


class _OfMountings(Effect):
    """Something that is another one in some mountings.

    Parameters
    ----------
    mounts : numbers of the mountings
    by_bolting : count every bolting anew, else the same mount is the same however often
    """

    needs = ("mount",)
    kind = Kind.BLOCK
    instant = False
    referred = 1
    """Mountings to which the others are referred, for what all have in common is no effect."""

    def __init__(self, *mounts: int, by_bolting: bool = False) -> None:
        self._mounts, self._anew = mounts or (0,), by_bolting

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which mounting, from 1."""
        return tuple((Parameter("mounting", "", ""), mount + 1.0) for mount in self._mounts)

    def here(self, stimulus: Stimulus) -> FloatArray:
        """Columns (n, k) of ones in each of the mountings."""
        groups = setups(stimulus) if self._anew else stimulus.column("mount")
        return indicators(groups, self._mounts)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """Every mounting, and all together, less those to which the others can be referred."""
        make = type(self)
        mounts = len(levels(stimulus.column("mount")))
        bolted = int(setups(stimulus)[-1]) + 1
        if mounts < 2:
            return ()
        found: list[Effect] = [make(mount) for mount in range(mounts)]
        if mounts - self.referred > 1:
            found.append(make(*range(self.referred, mounts)))
        if bolted > mounts:
            found += [make(bolting, by_bolting=True) for bolting in range(bolted)]
            found.append(make(*range(self.referred, bolted), by_bolting=True))
        return tuple(found)


class MountingAngle(_OfMountings):
    """The unit was bolted on at another angle than stated."""

    id = "mounting_angle"
    name = "Mounting angle"
    plain = "in one mounting the unit stands turned on the shaft by a small angle"
    equation = "psi * dU/d(head angle) in that mounting"
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "the misalignment differs from mounting to mounting"
    remedy = "align the unit on the fixture anew; mount it both ways round to tell it from k_zy"
    confused_with = ("head_ellipticity", "shaft_tilt")
    typical = {"accelerometer": 60.0}  # noqa: RUF012
    # About each axis of the case it is another one: nothing is common to all but that.
    referred = 0

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """The angle, arcsec."""
        return numbered("mounting_angle", "psi", "arcsec", len(self._mounts))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope in that mounting."""
        slope = RAD_PER_ARCSEC * per_head_angle(stimulus, sensor)
        return slope[:, None] * self.here(stimulus)


class ShaftTilt(Effect):
    """The shaft of the head is not level.

    Parameters
    ----------
    mount : number of the mounting in which it acts; -1 for all
    """

    id = "shaft_tilt"
    name = "Shaft tilt"
    plain = "the shaft of the head, or the platform, is not level"
    equation = "eps * g * (response along the shaft)"
    needs = ("mount",)
    kind = Kind.BLOCK
    tests = HEAD
    sensors = ("accelerometer",)
    shared = True
    seen_as = "an offset of each mounting, largest in the sensor along the shaft, turning its sign"
    remedy = "level the shaft; mount the unit both ways round"
    confused_with = ("remount_bias", "run_bias")
    typical = {"accelerometer": 30.0}  # noqa: RUF012

    def __init__(self, mount: int = -1) -> None:
        self._mount = mount

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Which mounting, from 1; 0 for all."""
        return ((Parameter("mounting", "", ""), float(self._mount + 1)),)

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """The elevation of the shaft's free end, arcsec."""
        return (Parameter("shaft_tilt", "eps", "arcsec"),)

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """What gravity along the shaft adds."""
        across = np.cross(stimulus.da_dhead, stimulus.a)
        size = np.linalg.norm(stimulus.a, axis=1)[:, None]
        along = -across / np.where(size > 0, size, 1.0) @ sensor.sensitivity
        here = 1.0 if self._mount < 0 else stimulus.column("mount") == self._mount
        return column(RAD_PER_ARCSEC * along * here)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """In all mountings alike, which is the shaft; in one, which is the platform there."""
        if len(levels(stimulus.column("mount"))) < 2:
            return ()
        return (ShaftTilt(),)


class RemountBias(_OfMountings):
    """The stress of the package changes when the unit is bolted on anew."""

    id = "remount_bias"
    name = "Re-mount bias"
    plain = "bolting on shifted the bias"
    equation = "b in that mounting"
    tests = STATIC
    seen_as = "an offset of one mounting, whichever way round"
    remedy = "return to the first mounting at the end; torque the screws alike"
    confused_with = ("shaft_tilt", "bias_drift", "run_bias", "bias_jump")
    typical = {"accelerometer": 0.5, "gyro": 0.02}  # noqa: RUF012

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """The shift, mg or deg/s."""
        return numbered("remount_bias", "b", small_unit(sensor), len(self._mounts))

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """Ones in that mounting."""
        return small_gain(sensor) * self.here(stimulus)


class HeadHarmonic(Effect):
    """An error of the dial that repeats so many times a turn; `order` is that number."""

    kind = Kind.BLOCK
    tests = HEAD
    needs = ("head_deg",)
    sensors = ("accelerometer",)
    shared = True
    remedy = "certify the head; re-index the unit by 90 degrees on the dial and repeat"

    def __init__(self, order: int) -> None:
        self._order = order

    def parameters(self, sensor: Sensor) -> tuple[Parameter, ...]:
        """Sine and cosine part of the error of the angle, arcsec."""
        return (
            Parameter("head_sine", "e_s", "arcsec"),
            Parameter("head_cosine", "e_c", "arcsec"),
        )

    def columns(self, stimulus: Stimulus, sensor: Sensor) -> FloatArray:
        """The slope times the harmonics of the dial."""
        angle = self._order * RAD_PER_DEG * stimulus.column("head_deg")
        slope = RAD_PER_ARCSEC * per_head_angle(stimulus, sensor)
        return column(slope * np.sin(angle), slope * np.cos(angle))


class HeadEccentricity(HeadHarmonic):
    """The axis of the dial lies beside that of the shaft."""

    id = "head_eccentricity"
    name = "Head eccentricity"
    plain = "the dial sits off centre, so the angle is wrong once a turn"
    equation = "dU/d(head angle) * e * sin(head angle - phase)"
    seen_as = "second harmonic of the head angle and a constant"
    confused_with = ("second_order_nonlinearity", "cross_coupling", "scale_factor_asymmetry")
    typical = {"accelerometer": 10.0}  # noqa: RUF012

    def __init__(self) -> None:
        super().__init__(1)


class HeadEllipticity(HeadHarmonic):
    """The dial is out of round."""

    id = "head_ellipticity"
    name = "Head ellipticity"
    plain = "the dial is out of round, so the angle is wrong twice a turn"
    equation = "dU/d(head angle) * e * sin(2 head angle - phase)"
    seen_as = "first and third harmonic of the head angle"
    confused_with = ("third_order_nonlinearity", "mounting_angle")
    typical = {"accelerometer": 5.0}  # noqa: RUF012

    def __init__(self) -> None:
        super().__init__(2)


class HeadPeriodicError(HeadHarmonic):
    """Error of the worm or of the division."""

    id = "head_periodic_error"
    name = "Head periodic error"
    plain = "worm or division make the angle wrong many times a turn"
    equation = "dU/d(head angle) * e * sin(N head angle + phase)"
    seen_as = "a fast harmonic of the head angle that repeats in every run"
    confused_with = ("pickup",)
    typical = {"accelerometer": 5.0}  # noqa: RUF012

    def __init__(self, order: int = 36) -> None:
        super().__init__(order)

    @property
    def shape(self) -> tuple[tuple[Parameter, float], ...]:
        """Periods in a turn."""
        return ((Parameter("periods", "N", ""), float(self._order)),)

    def instances(self, stimulus: Stimulus, sensor: Sensor) -> tuple[Effect, ...]:
        """The usual numbers of periods that the dialled angles tell apart."""
        head = RAD_PER_DEG * stimulus.column("head_deg")
        seen: set[bytes] = set()
        found: list[Effect] = []
        for order in (0, 1, 2, *_WORM):
            key = np.round(np.cos(order * head), 6) + 0.0
            # On equal steps a fast error folds down; to eccentricity and ellipticity at the latest.
            if order > 2 and key.tobytes() not in seen:
                found.append(HeadPeriodicError(order))
            seen.add(key.tobytes())
        return tuple(found)
