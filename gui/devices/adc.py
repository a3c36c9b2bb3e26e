"""View ADC Data: live codes of every channel of the current device, with mean and STD."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.archive.nearest import Usable
from core.arrays import FloatArray
from core.errors import FormatError, LabError
from core.procedures.physical import Physical, physical_of
from core.records.calibration_json import read_calibration
from core.samples.block import Channel, SampleBlock
from core.samples.running import LatestMoments, Moments, RunningMoments
from gui.devices.connection import Connection
from gui.jobs import Jobs
from gui.widgets.number_text import decimals_of, fixed, grouped, significant
from gui.widgets.states import TableState

_LATEST_S = 1.0
_DIGITS = 3
_PHYSICAL_DIGITS = 7


@dataclass(frozen=True, slots=True)
class AdcState:
    """The panel.

    Parameters
    ----------
    device : its name; empty without one
    table : one row a channel
    samples : since the panel was cleared
    calibration : where the physical units come from; empty for none
    hint : what to say while there are no samples
    """

    device: str
    table: TableState
    samples: str
    calibration: str
    hint: str


class AdcPresenter(QObject):
    """Keeps the statistics while the panel is open.

    Parameters
    ----------
    connection : whose current device is watched
    jobs : look for a calibration
    nearest : returns the calibrations of a device nearest to a moment and a temperature
    """

    changed = Signal()
    """Another device, or another calibration; numbers are asked for by the view's own timer."""

    def __init__(
        self,
        connection: Connection,
        jobs: Jobs,
        nearest: Callable[[str, datetime, float, str], tuple[Usable, ...]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._jobs = jobs
        self._nearest = nearest
        self._open = False
        self._channels: tuple[Channel, ...] = ()
        self._rate = 0.0
        self._physical: Physical | None = None
        self._calibration = ""
        self._asked = ""
        self._warmth = math.nan
        connection.blocks.connect(self._on_block)
        connection.changed.connect(self._on_changed)
        self.clear()

    def set_open(self, on: bool) -> None:
        """The panel is shown, or hidden: then nothing is computed."""
        if on and not self._open:
            self._open = True
            self.clear()
            self._on_changed()
        self._open = on

    def clear(self) -> None:
        """Begin the statistics anew."""
        columns = len(self._channels)
        latest = round(self._rate * _LATEST_S)
        k = 0 if self._physical is None else len(self._physical.places)
        self._all, self._latest = RunningMoments(columns), LatestMoments(latest, columns)
        self._physical_latest = LatestMoments(latest, k)

    def use(self, path: Path) -> None:
        """Show physical units by a calibration file; raises `LabError`."""
        self._take((self._name, read_calibration(path), path.name))

    def state(self) -> AdcState:
        """What the panel shows now."""
        shown = [i for i, channel in enumerate(self._channels) if channel.role != "counter"]
        every, latest = self._all.moments, self._latest.moments
        table = _table(self._channels, shown, every, latest, self._physical_rows())
        return AdcState(
            self._name,
            table,
            grouped(every.n),
            self._calibration,
            "" if every.n else _say("The numbers come with the first sample of a device."),
        )

    @property
    def _name(self) -> str:
        link = self._connection.link
        return "" if link is None else link.setup.name

    def _physical_rows(self) -> dict[int, tuple[str, str, str]]:
        physical = self._physical
        if physical is None:
            return {}
        found = self._physical_latest.moments
        return {
            place: (_level(found.mean[i], found.std[i]), _number(found.std[i]), physical.unit)
            for i, place in enumerate(physical.places)
        }

    def _on_block(self, block: SampleBlock) -> None:
        if not self._open:
            return
        link = self._connection.link
        rate = block.rate or (0.0 if link is None else link.rate_hz)
        if block.channels != self._channels or (self._rate <= 0 < rate):
            self._channels, self._rate, self._physical = block.channels, rate, None
            self._calibration = ""
            self._warmth = _temperature_in(block)
            self.clear()
            self._look_for_calibration()
        data: FloatArray = block.data
        self._all.feed(data)
        self._latest.feed(data)
        if self._physical is not None:
            self._physical_latest.feed(self._physical.of(data))

    def _on_changed(self) -> None:
        self._channels, self._rate, self._physical, self._calibration = (), 0.0, None, ""
        self._asked = ""
        self.clear()
        self.changed.emit()

    def _look_for_calibration(self) -> None:
        name = self._name
        if not name or name == self._asked:
            return
        self._asked = name
        near, warmth = self._nearest, self._warmth
        self._jobs.start(
            "calibration", lambda: _find(near, name, warmth), self._take, self._on_failed
        )

    def _take(self, found: object) -> None:
        match found:
            case (str(name), calibration, str(source)) if name == self._name and calibration:
                self._physical = physical_of(calibration, self._channels)
                self._calibration = source if self._physical is not None else ""
                self.clear()
                self.changed.emit()
            case _:
                pass

    def _on_failed(self, error: LabError) -> None:
        """Physical units are welcome, not needed."""


def _find(
    near: Callable[[str, datetime, float, str], tuple[Usable, ...]], name: str, warmth: float
) -> object:
    """The nearest calibration of the archive that can be read, and where it is from."""
    for one in near(name, datetime.now(UTC), warmth, ""):
        try:
            return name, read_calibration(one.path), one.words
        except FormatError:
            continue
    return name, None, ""


def _temperature_in(block: SampleBlock) -> float:
    """What the unit's thermometer says, degC; NaN without one."""
    for place, channel in enumerate(block.channels):
        if channel.role == "temp" and channel.unit == "degC":
            return float(block.data[:, place].mean())
    return math.nan


def _table(
    channels: tuple[Channel, ...],
    shown: list[int],
    every: Moments,
    latest: Moments,
    physical: dict[int, tuple[str, str, str]],
) -> TableState:
    header = [_say("Channel"), _say("Unit"), _say("Now"), _say("Mean, 1 s"), _say("STD, 1 s"),
              _say("Mean"), "STD", "Min", "Max"]  # fmt: skip
    if physical:
        header += [_say("Calibrated, 1 s"), "STD", _say("Unit")]
    rows: list[tuple[str, ...]] = []
    for i in shown:
        std = float(every.std[i])
        cells = [
            channels[i].name,
            channels[i].unit,
            _level(every.last[i], std),
            _level(latest.mean[i], latest.std[i]),
            _number(latest.std[i]),
            _level(every.mean[i], std),
            _number(std),
            _level(every.low[i], std),
            _level(every.high[i], std),
        ]
        if physical:
            cells += physical.get(i, ("", "", ""))
        rows.append(tuple(cells))
    return TableState("", "", tuple(header), tuple(rows), 2)


def _level(value: float, std: float) -> str:
    if not np.isfinite(value):
        return "\N{EM DASH}"
    if np.isfinite(std) and std > 0.0:
        return fixed(float(value), max(0, min(9, decimals_of(float(std), _DIGITS))))
    return significant(float(value), _PHYSICAL_DIGITS)


def _number(value: float) -> str:
    return significant(float(value), _DIGITS) if np.isfinite(value) else "\N{EM DASH}"


def _say(text: str) -> str:
    return QCoreApplication.translate("AdcData", text)
