"""Axes for pyqtgraph plots whose grid costs next to nothing, and whose decades read as decades."""

import math

import pyqtgraph as pg
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from gui.languages.shown import shown_number
from gui.widgets.chart_scale import nice_step, tick_text
from gui.widgets.chart_scale import ticks as round_ticks
from gui.widgets.colours import Theme, blend

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class FastAxis(pg.AxisItem):
    """Ticks as opaque grid lines.

    pyqtgraph draws its grid with translucent pens, pixel by pixel: 40 to 100 ms a frame for seven
    charts, where opaque ones take 3.
    """

    def __init__(self, orientation: str, theme: Theme) -> None:
        super().__init__(orientation)
        self.setGrid(255)
        self.setStyle(tickLength=0, autoReduceTextSpace=False)
        self.enableAutoSIPrefix(False)
        self.wear(theme)

    def wear(self, theme: Theme) -> None:
        """Take the colours of a look."""
        self.setPen(pg.mkPen(theme.line))
        self.setTextPen(pg.mkPen(theme.muted))
        self.setTickPen(pg.mkPen(theme.grid))
        self._major = QPen(QColor(theme.grid), 1)
        self._minor = QPen(blend(theme.grid, theme.base, 0.5), 1)

    def drawPicture(self, p: QPainter, axis: tuple, ticks: list[tuple], texts: list[tuple]) -> None:
        # The levels below the first come with less than half of the opacity; that tells them apart.
        pens = (self._minor, self._major)
        lines = [(pens[pen.color().alpha() > 127], start, stop) for pen, start, stop in ticks]
        super().drawPicture(p, axis, lines, texts)

    def tickValues(
        self, low: float, high: float, size: float
    ) -> list[tuple[float | None, list[float]]]:
        low, high = sorted((low, high))
        if self.logMode:
            decades = [float(power) for power in range(math.ceil(low), math.floor(high) + 1)]
            return [(1.0, decades), (None, minor_decades(low, high))]
        room = 6.0 if self.orientation in ("left", "right") else 12.0
        count = max(2, int(size / (room * self.fontMetrics().averageCharWidth())))
        step = nice_step(high - low, count)
        return [(step, round_ticks(low, high, step))]

    def fontMetrics(self) -> QFontMetricsF:
        """Return the measures of the tick labels."""
        return QFontMetricsF(self.font())

    def tickStrings(self, values: list[float], scale: float, spacing: float | None) -> list[str]:
        if not self.logMode:
            step = (spacing or 1.0) * scale
            return [shown_number(tick_text(value * scale, step)) for value in values]
        if spacing is not None:
            return [shown_number(decade_text(value)) for value in values]
        # Between the decades only where few of them are seen.
        few = self.range[1] - self.range[0] < FEW_DECADES
        return [shown_number(_digit_text(value)) if few else "" for value in values]


FEW_DECADES = 1.5


def decade_text(power: float) -> str:
    """Return a power of ten: 0.01 to 100 in plain digits, ``10⁻³`` and so on beyond."""
    whole = round(power)
    if -2 <= whole <= 2:
        return f"{10.0**whole:.{max(0, -whole)}f}"
    return "10" + str(whole).translate(_RAISED)


def _digit_text(value: float) -> str:
    """Label of 2 and 5 times a power of ten; nothing for the others."""
    power = math.floor(value)
    digit = round(10.0 ** (value - power))
    if digit not in (2, 5):
        return ""
    if -3 <= power <= 2:
        return f"{digit * 10.0**power:.{max(0, -power)}f}"
    return f"{digit}·{decade_text(power)}"


def minor_decades(low: float, high: float) -> list[float]:
    """Logarithms of 2, 3 ... 9 times each power of ten in a range of logarithms."""
    found = [
        power + math.log10(digit)
        for power in range(math.floor(low), math.ceil(high) + 1)
        for digit in range(2, 10)
    ]
    return [value for value in found if low <= value <= high]
