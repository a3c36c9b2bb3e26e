"""Parameters, steps and what limits them, in words."""

from PySide6.QtCore import QCoreApplication

from core.plans.plan import Plan, Step


def limit_words(key: str) -> str:
    """What limits an uncertainty."""
    words = {
        "white noise": QCoreApplication.translate("Advisor", "white noise"),
        "noise with memory": QCoreApplication.translate("Advisor", "flicker, walk"),
        "settings": QCoreApplication.translate("Advisor", "settings"),
        "local g": QCoreApplication.translate("Advisor", "local g"),
    }
    return words[key]


def unit_words(unit: str) -> str:
    """A unit as it is printed."""
    text = unit.replace("deg/s", "°/s").replace("deg/h", "°/h").replace("degC", "°C")
    return text.replace("deg", "°").replace("m/s^2", "m/s²").replace("^2", "²")


def step_words(step: Step, on_table: bool) -> str:
    """A step as the operator knows it."""
    if on_table:
        return f"{step.rate_dps:+g} °/s".replace("-", "\N{MINUS SIGN}")
    return f"{step.head_deg:g}°".replace("-", "\N{MINUS SIGN}")


def minutes_words(minutes: float) -> str:
    """A length of time."""
    if minutes < 90.0:
        template = QCoreApplication.translate("Advisor", "{minutes} min")
        return template.format(minutes=f"{minutes:.0f}")
    template = QCoreApplication.translate("Advisor", "{hours} h")
    return template.format(hours=f"{minutes / 60.0:.1f}")


def plan_words(plan: Plan) -> str:
    """How often, at how many temperatures."""
    if not plan.temperatures_c:
        return ""
    template = QCoreApplication.translate("Advisor", "{count} temperatures")
    return template.format(count=len(plan.temperatures_c))
