"""What moves on the rig, and what it does to the unit, sample by sample."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray
from core.model.stimulus import Stimulus
from core.plans.orientation import (
    LEVEL,
    BaseOrientation,
    Mount,
    case_from_base,
    earth_rate,
    specific_force,
)
from core.units import ARCMIN_PER_DEG, EARTH_RATE_DPS, RAD_PER_DEG
from drivers.virtual.noise import Lag

_AXES = ("x", "y", "z")
_RING_S = 0.15
_STILL = 1e-3
_REFERENCE_C = 27.0


@dataclass(frozen=True, slots=True)
class Place:
    """Where the rig stands.

    Parameters
    ----------
    g : local gravity, m/s^2
    latitude_deg : geodetic latitude; gyros feel the rate of the Earth by it
    """

    g: float = 9.8106
    latitude_deg: float = 50.45


@dataclass(frozen=True, slots=True)
class Manner:
    """How the rig moves.

    Parameters
    ----------
    head_dps : speed of a hand at the dividing head
    remount_s : time that a re-mounting takes
    table_dps2 : how fast the table gains speed
    chamber_c_per_s : how fast the chamber heats
    case_tau_s : how slowly the unit follows the chamber
    vibration : deviation of the specific force while something moves, m/s^2
    shake_dps : deviation of the rate while something moves, deg/s
    """

    head_dps: float = 45.0
    remount_s: float = 2.0
    table_dps2: float = 50.0
    chamber_c_per_s: float = 0.08
    case_tau_s: float = 300.0
    vibration: float = 0.3
    shake_dps: float = 0.5


class Ramp:
    """A quantity that goes to its target at a constant speed."""

    def __init__(self, value: float, speed: float) -> None:
        self.value = value
        self.target = value
        self._speed = speed

    def path(self, n: int, dt: float) -> FloatArray:
        """Return the next n values and stand at the last."""
        gap = self.target - self.value
        if gap == 0.0:
            return np.full(n, self.value)
        step = math.copysign(self._speed * dt, gap)
        values = self.value + step * np.arange(1, n + 1)
        values = np.minimum(values, self.target) if gap > 0 else np.maximum(values, self.target)
        self.value = float(values[-1])
        return values


class Bench:
    """Head, mount, table and chamber, in the time of the samples.

    Its stimulus holds the columns of a `Run` and ``north_x``, ``north_y``, ``north_z``: true north
    on the case axes.

    Parameters
    ----------
    place : gravity and latitude
    manner : speeds and vibration
    rate_hz : samples per second
    rng : the source of the vibration
    timed : something depends on the time alone, so that no row stands for others
    """

    def __init__(
        self,
        place: Place,
        manner: Manner,
        rate_hz: float,
        rng: np.random.Generator,
        *,
        timed: bool = False,
    ) -> None:
        self._timed = timed
        self.place = place
        self.manner = manner
        self.mount = "X_from"
        self.base: BaseOrientation = LEVEL
        self.axis = ""
        self.head = Ramp(0.0, manner.head_dps)
        self.table = Ramp(0.0, manner.table_dps2)
        self.chamber = Ramp(27.0, manner.chamber_c_per_s)
        self._dt = 1.0 / rate_hz
        self._knocks, self._jolts = rng.spawn(2)
        self._samples = 0
        self._handling = 0
        self._moves = 0
        self._shaking = 0.0
        self._table_deg = 0.0
        self._rest: tuple[tuple[object, ...], Stimulus] | None = None
        self.be_at(27.0)

    def turn(self, head_deg: float) -> None:
        """Start turning the head to an angle, the short way round."""
        way = (head_deg - self.head.value + 180.0) % 360.0 - 180.0
        self.head.value = head_deg - way
        self.head.target = head_deg
        self.axis = ""
        self.table.target = 0.0
        self._moves += 1

    def spin(self, rate_dps: float, axis: str) -> None:
        """Stand on the rate table, a case axis along its vertical axis, and go to a rate.

        The axis points up unless the mount says that it points down; a positive rate is
        counter-clockwise seen from above.
        """
        self.axis = axis
        self.table.target = rate_dps
        self._moves += 1

    def remount(self, mount: str) -> None:
        """Start bolting the unit on another way; `ValueError` for an unknown mount."""
        Mount.parse(mount)
        if mount != self.mount:
            self.mount = mount
            self._handling = round(self.manner.remount_s / self._dt)

    def heat(self, chamber_c: float) -> None:
        """Set the chamber."""
        self.chamber.target = chamber_c

    def tilt_base(self, base: BaseOrientation) -> None:
        """Set the base plate."""
        self.base = base

    def be_at(self, celsius: float) -> None:
        """Stand at a temperature, unit and all, as after hours."""
        self.chamber.value = self.chamber.target = self.case_c = celsius
        self._case = Lag(self.manner.case_tau_s, self._dt, np.array([celsius]))

    @property
    def time_s(self) -> float:
        """Time since the start."""
        return self._samples * self._dt

    @property
    def moving(self) -> bool:
        """Whether head, mount or table are in motion."""
        return (
            self.head.value != self.head.target
            or self.table.value != self.table.target
            or self._handling > 0
        )

    def stimulus(self, n: int) -> Stimulus:
        """Return what acts on the unit in the next n samples; at rest one row stands for all."""
        t = self._dt * (self._samples + np.arange(n, dtype=np.float64))
        self._samples += n
        if self._at_rest() and not self._timed:
            return self._resting(t[:1])
        before = self.head.value
        head, table = self.head.path(n, self._dt), self.table.path(n, self._dt)
        moving = (head != self.head.target) | (table != self.table.target)
        moving |= np.arange(n) < self._handling
        self._handling = max(0, self._handling - n)
        case = self._case.filtered(self.chamber.path(n, self._dt)[:, None])[:, 0]
        self.case_c = float(case[-1])
        smooth = self._acting(t, head, table, case)
        turning = np.diff(head, prepend=before) / self._dt
        w = smooth.w + turning[:, None] * _turning_axis(self.mount)
        envelope = self._envelope(moving)
        shaking = np.flatnonzero(envelope)
        shape = (len(shaking), 3)
        shaken = envelope[shaking, None]
        # Chance is spent on the shaken samples alone, so blocks of any length give the same.
        smooth.a[shaking] += self.manner.vibration * shaken * self._knocks.standard_normal(shape)
        w[shaking] += self.manner.shake_dps * shaken * self._jolts.standard_normal(shape)
        return replace(smooth, w=w)

    def _resting(self, t: FloatArray) -> Stimulus:
        """What acts at rest, worked out once for each rest."""
        key = (self.mount, self.head.value, self.axis, self.base, self.case_c, self._moves)
        if self._rest is None or self._rest[0] != key:
            head, table = np.array([self.head.value]), np.zeros(1)
            self._rest = key, self._acting(t, head, table, np.array([self.case_c]))
        rest = self._rest[1]
        return replace(rest, columns={**rest.columns, "t_s": t})

    def _at_rest(self) -> bool:
        return (
            not self.moving
            and self.table.value == 0.0
            and self._shaking == 0.0
            and self.chamber.value == self.chamber.target
            and abs(self.case_c - self.chamber.value) < _STILL
        )

    def _acting(
        self, t: FloatArray, head: FloatArray, table: FloatArray, case: FloatArray
    ) -> Stimulus:
        """What acts without vibration, in each row.

        The table is a head whose shaft points up, and the unit stands on it by its mount.
        """
        g = self.place.g
        mount, base = (self._standing, self._upright) if self.axis else (self.mount, self.base)
        a, da_dhead = _tumbled(lambda d: specific_force(mount, d, g, base), head)
        seen_at = self._sky(mount, base, head, table)
        w = seen_at(self.place.latitude_deg)
        # On the equator the axis of the Earth lies level and points north.
        north = seen_at(0.0) / EARTH_RATE_DPS
        dw_drate = np.zeros_like(w)
        if self.axis:
            dw_drate[:] = case_from_base(mount, 0.0)[:, 0]
            da_dhead = np.zeros_like(a)
        columns = {
            "head_deg": head,
            "set_rate_dps": table,
            "temperature_c": case,
            "t_s": t,
            "order": np.full(len(t), float(self._moves)),
            "run": np.zeros(len(t)),
            "start_s": np.zeros(len(t)),
            "reference_c": np.full(len(t), _REFERENCE_C),
            **{f"north_{axis}": north[:, k] for k, axis in enumerate(_AXES)},
        }
        w = w + table[:, None] * dw_drate
        return Stimulus(a=a, w=w, da_dhead=da_dhead, dw_drate=dw_drate, columns=columns)

    @property
    def _standing(self) -> str:
        """How the unit stands on the table: by its mount, else with the spun axis up."""
        mount = Mount.parse(self.mount)
        return self.mount if mount.axis.lower() == self.axis else f"{self.axis.upper()}_from"

    @property
    def _upright(self) -> BaseOrientation:
        """The base plate turned so that its shaft points up."""
        upwards = 90.0 * ARCMIN_PER_DEG
        return replace(self.base, alpha_arcmin=self.base.alpha_arcmin + upwards)

    def _sky(
        self, mount: str, base: BaseOrientation, head: FloatArray, table: FloatArray
    ) -> Callable[[float], FloatArray]:
        """Rate of the Earth (n, 3) by latitude; a turning table swings its level part around."""
        if not table.any():
            base = replace(base, psi_deg=base.psi_deg - self._table_deg)
            return lambda latitude: _tumbled(lambda d: earth_rate(mount, d, latitude, base), head)[
                0
            ]
        turned = self._table_deg + np.cumsum(table) * self._dt
        self._table_deg = float(turned[-1]) % 360.0
        angle = float(head[-1])
        return lambda latitude: _tumbled(
            lambda d: earth_rate(mount, angle, latitude, replace(base, psi_deg=d)),
            base.psi_deg - turned,
        )[0]

    def _envelope(self, moving: NDArray[np.bool_]) -> FloatArray:
        """How strongly the unit shakes in each sample: 1 in motion, dying away after it."""
        step = np.arange(len(moving))
        last = np.maximum.accumulate(np.where(moving, step, -1))
        since = np.where(last >= 0, step - last, step + 1) * self._dt
        envelope = np.where(last >= 0, 1.0, self._shaking) * np.exp(-since / _RING_S)
        envelope[envelope < _STILL] = 0.0
        self._shaking = float(envelope[-1])
        return envelope


def _tumbled(at: Callable[[float], FloatArray], head: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values (n, 3) at head angles (n,), and their derivatives per radian.

    What a turning head does to a fixed vector is a constant and a first harmonic, so four angles
    tell all of it.
    """
    if np.all(head == head[0]):
        base, quarters = float(head[0]), np.zeros(len(head))
    else:
        base, quarters = 0.0, head * RAD_PER_DEG
    here, ahead, behind, across = (at(base + d) for d in (0.0, 90.0, -90.0, 180.0))
    mean, cosine, sine = (here + across) / 2, (here - across) / 2, (ahead - behind) / 2
    c, s = np.cos(quarters)[:, None], np.sin(quarters)[:, None]
    return mean + c * cosine + s * sine, c * sine - s * cosine


def _turning_axis(mount: str) -> FloatArray:
    """Rate (3,) on the case axes while the head turns by 1 deg/s."""
    change = (case_from_base(mount, 90.0) - case_from_base(mount, -90.0)) / 2
    cross = -change @ case_from_base(mount, 0.0).T
    return np.array([cross[2, 1], cross[0, 2], cross[1, 0]])
