"""Means and standard deviations of the last second, for the live table."""

from collections import deque
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from core.samples.block import SampleBlock
from gui.measuring.device import MeasuredDevice
from gui.measuring.state import LiveRow, LiveState
from gui.widgets.number_text import fixed

_WINDOW_S = 1.0
_LARGE = 100.0


class LiveMeans:
    """Keeps the last second of samples.

    Parameters
    ----------
    device : whose sensors the table shows
    rate : samples per second
    """

    def __init__(self, device: MeasuredDevice, rate: float) -> None:
        self._device = device
        self._wanted = max(2, round(rate * _WINDOW_S))
        self._blocks: deque[SampleBlock] = deque()
        self._count = 0

    def feed(self, block: SampleBlock) -> None:
        """Take samples."""
        if self._blocks and self._blocks[-1].channels != block.channels:
            self.clear()
        self._blocks.append(block)
        self._count += len(block.index)
        while self._count - len(self._blocks[0].index) >= self._wanted:
            self._count -= len(self._blocks.popleft().index)

    def clear(self) -> None:
        """Forget everything."""
        self._blocks.clear()
        self._count = 0

    def state(self, std_scale: Mapping[str, float], std_unit: str) -> LiveState:
        """The table now.

        Parameters
        ----------
        std_scale : `std_unit` of one unit of output, by role, as far as it is known
        std_unit : in which standard deviations are told where it is known for all sensors
        """
        device = self._device
        shape = LiveState(
            tuple(LiveRow(row.name) for row in device.rows),
            device.sensor,
            device.unit,
            device.unit,
            device.has_others,
        )
        if self._count < 2:
            return shape
        data = np.concatenate([block.data for block in self._blocks])[-self._wanted :]
        roles = [channel.role for channel in self._blocks[-1].channels]
        mean = dict(zip(roles, data.mean(axis=0), strict=True))
        std = dict(zip(roles, data.std(axis=0, ddof=1), strict=True))
        decimals = 1 if device.unit == "code" else 6
        scaled = all(row.main in std_scale for row in device.rows)
        rows = tuple(
            LiveRow(
                name=row.name,
                mean=_text(mean, row.main, decimals),
                std=_std_text(
                    float(std[row.main]), std_scale[row.main] if scaled else None, decimals + 1
                ),
                temp=_text(mean, row.main_temp, 0),
                other_mean=_text(mean, row.other, 1),
                other_temp=_text(mean, row.other_temp, 0),
            )
            for row in device.rows
        )
        return replace(shape, rows=rows, std_unit=std_unit if scaled else device.unit)


def _std_text(value: float, scale: float | None, decimals: int) -> str:
    """A standard deviation; in its own unit large ones need fewer decimals."""
    if scale is None:
        return fixed(value, decimals)
    return fixed(value * scale, 3 if value * scale < _LARGE else 1)


def _text(values: Mapping[str, float], role: str, decimals: int) -> str:
    return fixed(float(values[role]), decimals) if role in values else ""
