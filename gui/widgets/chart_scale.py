"""Round numbers on axes, and ranges that do not jump at every sample."""

import math

from gui.widgets.number_text import MINUS

_TIME_STEPS = (15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400)


def nice_step(span: float, count: int) -> float:
    """Return the least of 1, 2, 5 times a power of ten that parts `span` into at most `count`."""
    rough = span / max(1, count)
    power = 10.0 ** math.floor(math.log10(rough))
    for factor in (1.0, 2.0, 5.0):
        if factor * power >= rough * (1.0 - 1e-9):
            return factor * power
    return 10.0 * power


def ticks(low: float, high: float, step: float) -> list[float]:
    """Return the multiples of `step` from `low` to `high`."""
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def tick_text(value: float, step: float) -> str:
    """Return the label of a tick, with the digits that tell it from its neighbours."""
    places = max(0, -math.floor(math.log10(step) + 1e-9))
    size = abs(value)
    if places > 8 or size >= 1e8:
        digits = max(0, _decade(max(size, step)) - _decade(step))
        text = f"{value:.{digits}e}"
    else:
        text = f"{value:.{places}f}"
    # A tick at zero may come out as -0.0000.
    return text.lstrip("-") if float(text) == 0.0 else text.replace("-", MINUS)


def _decade(size: float) -> int:
    return math.floor(math.log10(size) + 1e-9)


def time_step(span: float, count: int) -> float:
    """Return a round step of seconds, minutes or hours that parts `span` into at most `count`."""
    step = nice_step(span, count)
    if step <= 10.0:
        return step
    for candidate in _TIME_STEPS:
        if candidate * count >= span:
            return float(candidate)
    return 86400.0 * nice_step(span / 86400.0, count)


def time_text(seconds: float, step: float, longest: float) -> str:
    """Return a time on an axis that reaches to `longest`: ``12.5``, ``3:20``, ``1:03:20``."""
    places = max(0, -math.floor(math.log10(step) + 1e-9)) if step < 1.0 else 0
    if longest < 120.0:
        return tick_text(seconds, step)
    sign = MINUS if seconds < 0.0 else ""
    unit = 10**places
    whole, fraction = divmod(round(abs(seconds) * unit), unit)
    tail = f"{whole % 60:02d}" + (f".{fraction:0{places}d}" if places else "")
    minutes = whole // 60
    if longest < 3600.0:
        return f"{sign}{minutes}:{tail}"
    return f"{sign}{minutes // 60}:{minutes % 60:02d}:{tail}"


class HeldRange:
    """A range of values that is left alone until the data leave it or use less than half of it."""

    def __init__(self) -> None:
        self.low = 0.0
        self.high = 1.0
        self._set = False

    def fit(self, low: float, high: float) -> bool:
        """Take in the extremes of what is shown; tell whether the range has changed.

        NaN, where nothing is shown, leaves the range as it is.
        """
        if not (math.isfinite(low) and math.isfinite(high)):
            return False
        size = max(abs(low), abs(high))
        used = high - low
        if used <= 1e-12 * size:
            used = 1e-3 * size or 1.0
        inside = self.low <= low and high <= self.high
        if self._set and inside and used >= 0.5 * (self.high - self.low):
            return False
        middle = 0.5 * (low + high)
        self.low, self.high = middle - 0.6 * used, middle + 0.6 * used
        self._set = True
        return True
