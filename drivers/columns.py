"""The columns of a stream whose frames do not all hold the same values."""

from collections.abc import Iterable

import numpy as np

from core.arrays import IntArray
from core.samples.block import Channel


class Columns:
    """All channels met so far, in the order in which they came.

    Parameters
    ----------
    expected : what stands for them until the first frame tells
    """

    def __init__(self, expected: Iterable[Channel] = ()) -> None:
        self.channels = tuple(expected)
        self._places: dict[str, int] = {}

    def lack(self, channels: Iterable[Channel]) -> bool:
        """Return whether one of these has no column yet."""
        return any(channel.name not in self._places for channel in channels)

    def take(self, channels: tuple[Channel, ...]) -> None:
        """Give each of these a column; one of the same name but another unit replaces the old."""
        if self._places and channels is self.channels:
            return
        known = list(self.channels) if self._places else []
        for channel in channels:
            place = self._places.setdefault(channel.name, len(known))
            known[place : place + 1] = [channel]
        if known:
            merged = tuple(known)
            self.channels = channels if merged == channels else merged

    def places(self, channels: Iterable[Channel]) -> IntArray:
        """Return the columns of these channels."""
        return np.array([self._places[channel.name] for channel in channels], dtype=np.int64)
