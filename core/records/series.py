"""A record of samples at a fixed rate, wherever it came from.

A record is hours of samples of one device at rest; a `Run` is a few rows of means. Every reader of
records gives a `Series`, and `Series.sampled` gives the analysis one channel of it.
"""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.allan.record import sample_index
from core.arrays import FloatArray, IntArray
from core.errors import FitError, FormatError, Note
from core.samples.block import Channel

_UNITS = {
    "dps": "deg/s",
    "deg/s": "deg/s",
    "degps": "deg/s",
    "°/s": "deg/s",
    "град/с": "deg/s",
    "°/с": "deg/s",
    "mps2": "m/s^2",
    "m/s2": "m/s^2",
    "m/s^2": "m/s^2",
    "m/s²": "m/s^2",
    "м/с2": "m/s^2",
    "degc": "degC",
    "c": "degC",
    "°c": "degC",
    "°с": "degC",
    "v": "V",
    "code": "code",
}
"""Spellings of units in the heads of columns, in small letters."""
_WITH_UNIT = re.compile(r"^(?P<name>.*?)\s*(?:\[(?P<a>[^\]]*)\]|\((?P<b>[^)]*)\)|,\s*(?P<c>\S+))$")
_ROLES = (
    (re.compile(r"^(temp|temperature|температура)", re.IGNORECASE), "temp"),
    (re.compile(r"^(gyro|rate|omega|w_?[xyz]$|g[xyz]$)", re.IGNORECASE), "rate."),
    (re.compile(r"^(acc|a_?[xyz]$)", re.IGNORECASE), "acc."),
)


@dataclass(frozen=True, slots=True)
class Sampled:
    """One channel of a record.

    Parameters
    ----------
    name, unit : of the channel
    values : (n,) samples; one that is not finite is lost
    rate : samples per second
    index : (n,) sample numbers by counter or time stamps; None where every sample is there
    scale_factor : by which they were divided
    """

    name: str
    unit: str
    values: FloatArray
    rate: float
    index: IntArray | None
    scale_factor: float


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """A record.

    Parameters
    ----------
    path : its file
    device : name of the device; of the file where it holds none
    channels : (c,) what the columns are
    columns : (c,) arrays (n,); those of long records are read when they are asked for
    n : samples
    rate : samples per second; 0 where the file does not say
    index : (n,) sample numbers by the device's counter, None without one
    time : (n,) time stamps, s, None without any
    scale_factor : output of the gyro for 1 deg/s that the file states; NaN where it states none
    notes : doubts about the file
    """

    path: str
    device: str
    channels: tuple[Channel, ...]
    columns: Sequence[FloatArray]
    n: int
    rate: float = 0.0
    index: IntArray | None = None
    time: FloatArray | None = None
    scale_factor: float = math.nan
    notes: tuple[Note, ...] = ()

    def place(self, name: str) -> int:
        """Return the place of a channel by its name, its role, or its number from 1.

        Raises
        ------
        FormatError
            There is no such channel.
        """
        for place, channel in enumerate(self.channels):
            if name in (channel.name, channel.role) and name:
                return place
        if name.isdigit() and 1 <= int(name) <= len(self.channels):
            return int(name) - 1
        names = ", ".join(channel.name for channel in self.channels)
        raise FormatError(self.path, f"holds no channel {name!r}; there are: {names}")

    @property
    def main(self) -> int:
        """Place of the channel that a noise analysis is likely meant for."""
        for role in ("rate.", "acc."):
            for place, channel in enumerate(self.channels):
                if channel.role.startswith(role):
                    return place
        for place, channel in enumerate(self.channels):
            if not channel.role.startswith(("temp", "counter", "time", "status")):
                return place
        return 0

    def sampled(self, place: int, rate: float = 0.0, scale_factor: float = 0.0) -> Sampled:
        """Return one channel with its rate.

        Parameters
        ----------
        place : which channel
        rate : samples per second that the operator states; 0 to take it from the file
        scale_factor : output for 1 deg/s, by which the samples are divided; 0 for the one that the
            file states for its gyro, if any

        Raises
        ------
        FitError
            The rate is neither stated nor in the file, or its time stamps are not uniform.
        """
        index, own = self.index, self.rate
        if rate <= 0.0 and own <= 0.0:
            if self.time is None:
                raise FitError(
                    f"{self.path} does not tell its sampling rate: state the samples per second"
                )
            index, own = sample_index(self.time)
        if index is not None and len(index) and int(index[-1] - index[0]) == len(index) - 1:
            index = None
        channel = self.channels[place]
        values, unit = self.columns[place], channel.unit
        factor = scale_factor or self._own_factor(channel)
        if factor != 1.0:
            values = np.asarray(values, dtype=np.float64) / factor
            unit = "m/s^2" if channel.role.startswith("acc.") else "deg/s"
        return Sampled(channel.name, unit, values, rate if rate > 0.0 else own, index, factor)

    def _own_factor(self, channel: Channel) -> float:
        """The scale factor that the file states; a factor of 1 states none."""
        stated = math.isfinite(self.scale_factor) and self.scale_factor != 0.0
        return self.scale_factor if stated and channel.role.startswith("rate.") else 1.0


def named_channel(title: str) -> Channel:
    """Return the channel that the head of a column names: ``Gyro Z [deg/s]``, ``gyro_z_dps``."""
    title = title.strip().strip('"')
    name, unit = title, ""
    match = _WITH_UNIT.match(title)
    if match is not None:
        stated = next(text for text in match.group("a", "b", "c") if text is not None).strip()
        name, unit = match["name"].strip(), _UNITS.get(stated.lower(), stated)
    elif "_" in title:
        stem, _, tail = title.rpartition("_")
        if tail.lower() in _UNITS and stem:
            name, unit = stem, _UNITS[tail.lower()]
    role = next((role for pattern, role in _ROLES if pattern.search(name)), "")
    if role.endswith("."):
        role += name[-1].lower() if name[-1:].lower() in ("x", "y", "z") else "z"
    return Channel(name or title, unit or "code", role)


def distinct(channels: tuple[Channel, ...]) -> tuple[Channel, ...]:
    """Number channels that have the same name."""
    seen: dict[str, int] = {}
    result: list[Channel] = []
    for channel in channels:
        count = seen[channel.name] = seen.get(channel.name, 0) + 1
        again = count > 1
        result.append(replace(channel, name=f"{channel.name} {count}") if again else channel)
    return tuple(result)
