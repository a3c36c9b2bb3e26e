"""Words and units of the Drift tab."""

from PySide6.QtCore import QCoreApplication

from gui.widgets.number_text import MINUS

_SHOWN = {"deg/s": ("°/h", 3600.0), "deg/h": ("°/h", 1.0), "m/s^2": ("mg", 1e3 / 9.80665)}


def shown_unit(unit: str) -> tuple[str, float]:
    """The unit in which a drift is shown, and the factor to it: drifts are small."""
    return _SHOWN.get(unit, (unit, 1.0))


def degrees(value: float, decimals: int = 1) -> str:
    """A temperature in words."""
    return f"{value:.{decimals}f} °C".replace("-", MINUS)


def method_words() -> dict[str, str]:
    """What each method is called."""
    return {
        "none": QCoreApplication.translate("Drift", "no correction"),
        "cubic": QCoreApplication.translate("Drift", "cubic in time"),
        "quartic": QCoreApplication.translate("Drift", "quartic in time"),
        "angles": QCoreApplication.translate("Drift", "sharpest angles (003)"),
        "table": QCoreApplication.translate("Drift", "this table"),
        "mean": QCoreApplication.translate("Drift", "mean curve (floor)"),
    }
