"""Blocks of samples with counter time."""

from dataclasses import dataclass

from core.arrays import FloatArray, IntArray


@dataclass(frozen=True, slots=True)
class Channel:
    """One column of what a device sends.

    Parameters
    ----------
    name : the device's own name of it
    unit : unit of the numbers; ``"code"`` while no calibration has been applied
    role : what it measures: ``"acc.x"``, ``"rate.z"``, ``"mag.y"``, ``"adc.3"``, ``"temp"`` (case),
        ``"temp.acc.x"``, ``"temp.adc.3"``, ``"angle.pitch"``, ``"counter"``, ``"time"``,
        ``"status"``; empty where nothing needs to know
    """

    name: str
    unit: str = "code"
    role: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class SampleBlock:
    """Samples of one device that were decoded together.

    Parameters
    ----------
    channels : (c,) what the columns are
    index : (n,) int64, strictly increasing sample numbers by the device's counter; a step of more
        than one is a gap of that many lost samples
    data : (n, c) float64, read-only
    rate : samples per second that one step of `index` stands for; 0 while unknown
    """

    channels: tuple[Channel, ...]
    index: IntArray
    data: FloatArray
    rate: float

    def column(self, role: str) -> FloatArray | None:
        """Return the column with this role, or None if the device has none."""
        for position, channel in enumerate(self.channels):
            if channel.role == role:
                return self.data[:, position]
        return None


def chosen_columns(channels: tuple[Channel, ...], role: str) -> list[int]:
    """Places of the channels whose role starts with `role`."""
    return [place for place, channel in enumerate(channels) if channel.role.startswith(role)]
