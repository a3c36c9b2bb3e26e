"""Means and standard deviations of the last second, for the live table."""

from collections import deque
from collections.abc import Mapping

import numpy as np

from core.arrays import FloatArray
from core.samples.block import SampleBlock
from core.units import MILLI
from gui.dividing_head.device import HeadDevice
from gui.dividing_head.state import LiveRow, LiveState
from gui.widgets.number_text import fixed

_WINDOW_S = 1.0


class LiveMeans:
    """Keeps the last second of samples.

    Parameters
    ----------
    device : whose sensors the table shows
    rate : samples per second
    """

    def __init__(self, device: HeadDevice, rate: float) -> None:
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

    def state(self, mg_per_unit: Mapping[str, float]) -> LiveState:
        """The table now.

        Parameters
        ----------
        mg_per_unit : milli-g of one unit of output, by role, as far as it is known
        """
        device = self._device
        if self._count < 2:
            return LiveState(
                tuple(LiveRow(row.name) for row in device.rows),
                device.unit,
                device.unit,
                device.has_rates,
            )
        data = np.concatenate([block.data for block in self._blocks])[-self._wanted :]
        roles = [channel.role for channel in self._blocks[-1].channels]
        mean = dict(zip(roles, data.mean(axis=0), strict=True))
        std = dict(zip(roles, data.std(axis=0, ddof=1), strict=True))
        in_mg = all(row.acc in mg_per_unit for row in device.rows)
        rows = tuple(
            LiveRow(
                name=row.name,
                acc_mean=_text(mean, row.acc, 1),
                acc_std=_text(
                    {row.acc: std[row.acc] * (mg_per_unit[row.acc] if in_mg else 1.0)},
                    row.acc,
                    3 if in_mg else 2,
                ),
                acc_temp=_text(mean, row.acc_temp, 0),
                rate_mean=_text(mean, row.rate, 1),
                rate_temp=_text(mean, row.rate_temp, 0),
            )
            for row in device.rows
        )
        return LiveState(rows, device.unit, "mg" if in_mg else device.unit, device.has_rates)


def _text(values: Mapping[str, float], role: str, decimals: int) -> str:
    return fixed(float(values[role]), decimals) if role in values else ""


def mg_per_unit(k: FloatArray, roles: tuple[str, ...], g: float) -> dict[str, float]:
    """Milli-g of one unit of output, by role.

    Parameters
    ----------
    k : (c, 3) output per m/s^2 along each case axis; the steepest counts
    roles : (c,) of the outputs
    g : local gravity, m/s^2
    """
    sensitivity = np.linalg.norm(k, axis=1)
    return {
        role: 1.0 / (float(s) * g * MILLI)
        for role, s in zip(roles, sensitivity, strict=True)
        if s > 0
    }
