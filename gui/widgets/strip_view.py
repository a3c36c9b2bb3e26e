"""What part of a record the stacked charts show: a window of time and a range for each channel."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

from gui.widgets.chart_scale import HeldRange
from gui.widgets.history import History

LEAST_SPAN = 1e-6
"""Shortest window, s."""


class Follow(Enum):
    """What moves the window."""

    ALL = "all"
    """Full time scale: from the beginning to now."""
    TAIL = "tail"
    """Auto tracking: the last seconds."""
    NOTHING = "nothing"
    """The operator alone."""


@dataclass(frozen=True, slots=True)
class Interval:
    """A marked stretch of time, s."""

    start: float
    stop: float
    label: str = ""
    selected: bool = False


@dataclass(frozen=True, slots=True)
class Mark:
    """An event at a time, s."""

    at: float
    text: str


class StripView:
    """Window of time with stepped edges, and ranges of values with hysteresis."""

    def __init__(self) -> None:
        self.start = 0.0
        self.stop = 10.0
        self.follow = Follow.ALL
        self.tail_s = 10.0
        self._ranges: list[HeldRange] = []
        self._fixed: dict[int, tuple[float, float]] = {}

    def reset(self, channels: int) -> None:
        """Start anew for so many channels; what follows what stays as it is."""
        self._ranges = [HeldRange() for _ in range(channels)]
        self._fixed.clear()
        if self.follow is not Follow.NOTHING:
            self.start, self.stop = 0.0, self.tail_s

    def fix(self, channel: int, limits: tuple[float, float] | None) -> None:
        """Give a channel a range of the operator's, or None for its own."""
        if limits is None:
            self._fixed.pop(channel, None)
            self._ranges[channel] = HeldRange()
        else:
            self._fixed[channel] = limits

    def limits(self, channel: int) -> tuple[float, float]:
        """Return the range in which a channel is drawn."""
        if channel in self._fixed:
            return self._fixed[channel]
        held = self._ranges[channel]
        return held.low, held.high

    def advance(self, end: float) -> None:
        """Move the window on, in steps, for a record that now ends at `end` seconds."""
        if self.follow is Follow.ALL:
            if end > self.stop or self.start != 0.0 or end < 0.5 * self.stop:
                self.start, self.stop = 0.0, max(1.05 * end, 1.0)
        elif self.follow is Follow.TAIL:
            other_span = abs(self.stop - self.start - self.tail_s) > 1e-6 * self.tail_s
            if end > self.stop or end <= self.start or other_span:
                # Until the record fills the window, it grows into it from the left.
                self.stop = max(self.tail_s, end + 0.1 * self.tail_s)
                self.start = self.stop - self.tail_s

    def fit(self, history: History, channels: Iterable[int]) -> None:
        """Let the ranges follow what the window shows."""
        start, stop = history.number(self.start), history.number(self.stop) + 1
        for channel in channels:
            if channel not in self._fixed:
                self._ranges[channel].fit(*history.extremes(channel, start, stop))

    def look_at(self, start: float, stop: float) -> None:
        """Show a window of the operator's choice."""
        if math.isfinite(start) and math.isfinite(stop) and stop - start >= LEAST_SPAN:
            self.start, self.stop = start, stop
            self.follow = Follow.NOTHING

    def zoom(self, factor: float, about: float) -> None:
        """Stretch the window by `factor` about a time that stays in place."""
        self.look_at(about - (about - self.start) * factor, about + (self.stop - about) * factor)

    def pan(self, seconds: float) -> None:
        """Move the window."""
        self.look_at(self.start + seconds, self.stop + seconds)

    def zoom_values(self, channel: int, factor: float, about: float) -> None:
        """Stretch the range of a channel about a value; it is the operator's from then on."""
        low, high = self.limits(channel)
        self.fix(channel, (about - (about - low) * factor, about + (high - about) * factor))
