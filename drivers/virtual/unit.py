"""A unit on the rig: from what acts on it to the numbers that it sends."""

import math
from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray
from core.model.stimulus import Stimulus
from core.samples.block import Channel
from drivers.virtual.compass import ANGLE_ROLES, MAG_ROLES, magnetic_field, own_angles
from drivers.virtual.devices import Device, Output
from drivers.virtual.noise import Lag, Noise

_WARM_C = 27.0
_SETTLED = 1e-8


class Unit:
    """Sensors, thermometers and electronics of one device.

    Parameters
    ----------
    device : what it is
    channels : (c,) what it sends, in the order of its profile
    rate_hz : samples per second
    rng : the source of its noise
    noise : multiplies all noise; 0 leaves the steps of the ADC
    cold : it has just been switched on
    """

    def __init__(
        self,
        device: Device,
        channels: Sequence[Channel],
        rate_hz: float,
        rng: np.random.Generator,
        *,
        noise: float = 1.0,
        cold: bool = False,
    ) -> None:
        self._device = device
        self._noise_factor = noise
        self._heating_c = device.heating_c if cold else 0.0
        self._width = len(channels)
        self._codes = [at for at, channel in enumerate(channels) if channel.unit == "code"]
        self._sensors = _Columns(channels, [output.role for output in device.outputs])
        self._copies = _Columns(channels, list(device.copies))
        self._copied = [self._row(role) for role in device.copies.values()]
        self._kept = _Columns(channels, list(device.housekeeping))
        self._mags = _Columns(channels, MAG_ROLES if device.magnetic else ())
        self._angles = _Columns(channels, ANGLE_ROLES if device.magnetic else ())
        self._noise = Noise(tuple(output.level for output in device.outputs), rate_hz, rng)
        keeping = tuple(device.housekeeping.values())
        self._keeping_noise = Noise(tuple(kept.level for kept in keeping), rate_hz, rng)
        self._response = _Response(device.outputs, 1.0 / rate_hz, device.bandwidth_hz)

    def sends(self, stimulus: Stimulus, n: int) -> FloatArray:
        """Return the next n rows (n, c); a stimulus of one row stands for all of them."""
        device = self._device
        late = self._heating_c * np.exp(-stimulus.column("t_s") / device.heating_tau_s)
        warmth = stimulus.column("temperature_c") - late
        data = np.zeros((n, self._width))
        outputs = self._response.to(stimulus, n)
        outputs = outputs - late[:, None] * [output.warm_up for output in device.outputs]
        outputs = outputs + self._noise_factor * self._noise.next(n)
        limit = [output.limit for output in device.outputs]
        outputs = np.clip(outputs, np.negative(limit), limit)
        self._sensors.fill(data, outputs)
        self._copies.fill(data, outputs[:, self._copied])
        self._kept.fill(data, self._housekeeping(warmth, n))
        if device.magnetic:
            self._mags.fill(data, device.magnetic * magnetic_field(stimulus))
            self._angles.fill(data, own_angles(stimulus))
        data[:, self._codes] = np.rint(data[:, self._codes])
        return data

    @property
    def drift(self) -> FloatArray:
        """Mean drift of each sensor's output so far."""
        return self._noise_factor * self._noise.drift

    def _row(self, role: str) -> int:
        return [output.role for output in self._device.outputs].index(role)

    def _housekeeping(self, warmth: FloatArray, n: int) -> FloatArray:
        keeping = tuple(self._device.housekeeping.values())
        at_27 = np.array([kept.at_27 for kept in keeping])
        per_c = np.array([kept.per_c for kept in keeping])
        noise = self._noise_factor * self._keeping_noise.next(n)
        return at_27 + per_c * (warmth[:, None] - _WARM_C) + noise


class _Columns:
    """Which channels carry which quantities, by role or by name."""

    def __init__(self, channels: Sequence[Channel], keys: Sequence[str]) -> None:
        place = {channel.name: at for at, channel in enumerate(channels)}
        place |= {channel.role: at for at, channel in enumerate(channels) if channel.role}
        found = [(place[key], row) for row, key in enumerate(keys) if key in place]
        self._places = [at for at, _ in found]
        self._rows = [row for _, row in found]

    def fill(self, data: FloatArray, values: FloatArray) -> None:
        """Put the quantities (n or 1, q) into the channels of the data (n, c) that carry them."""
        data[:, self._places] = values[:, self._rows]


class _Response:
    """What the sensors put out without noise: their models, behind their bandwidth."""

    def __init__(self, outputs: Sequence[Output], dt: float, bandwidth_hz: float) -> None:
        self._outputs = outputs
        self._dt = dt
        self._tau = 1.0 / (2.0 * math.pi * bandwidth_hz)
        self._near = _SETTLED * np.array([output.limit for output in outputs])
        self._lag: Lag | None = None

    def to(self, stimulus: Stimulus, n: int) -> FloatArray:
        """Return the outputs (n, o), or (1, o) for all n where nothing changes."""
        ideal = np.column_stack([o.model.predict(stimulus, o.values) for o in self._outputs])
        if self._lag is None:
            self._lag = Lag(self._tau, self._dt, ideal[0])
        if len(ideal) == 1 and np.all(np.abs(self._lag.output - ideal[0]) < self._near):
            return ideal
        return self._lag.filtered(np.broadcast_to(ideal, (n, ideal.shape[1])))
