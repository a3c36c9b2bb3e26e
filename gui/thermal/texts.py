"""Words of the Thermal tab."""

import math

from PySide6.QtCore import QCoreApplication

from core.fit.estimate import Estimate
from gui.widgets.number_text import MINUS, value_and_uncertainty

WAYS = {1: "↑", -1: "↓", 0: ""}
"""Reached by heating, by cooling, the first."""


def degrees(value: float, decimals: int = 0) -> str:
    """A temperature in words; a dash where it was not measured."""
    if math.isnan(value):
        return "\N{EM DASH}"
    return f"{value:.{decimals}f} °C".replace("-", MINUS)


def with_half(one: Estimate) -> str:
    """Value and half width of its 95 % interval."""
    value, half = value_and_uncertainty(one.value, one.expanded())
    return f"{value} ± {half}"


def plain_unit(unit: str) -> str:
    """A unit as it is printed."""
    text = unit.replace("degC", "°C").replace("deg/", "°/").replace("m/s^2", "m/s²")
    return text.replace("^2", "²").replace("^3", "³").replace("^4", "⁴").replace("^5", "⁵")


def quantity_words() -> tuple[str, ...]:
    """What can be plotted of a cycle."""
    return (
        QCoreApplication.translate("Thermal", "Bias"),
        QCoreApplication.translate("Thermal", "Scale factor"),
        QCoreApplication.translate("Thermal", "Errors of roll and pitch"),
    )
