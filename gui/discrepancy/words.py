"""Words for what the engine names by keys."""

import math
import re
from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray
from core.discrepancy.result import UNKNOWN, Explanation, Fitted, Step
from core.model.catalogue.listing import CATALOGUE
from gui.widgets.number_text import MINUS, fixed, value_and_uncertainty
from gui.widgets.states import Tone

TONES = {
    "adequate": Tone.GOOD,
    "explained": Tone.ACTION,
    "ambiguous": Tone.DOUBT,
    "unexplained_structure": Tone.DOUBT,
    "excess_noise": Tone.DOUBT,
    "data_fault": Tone.BAD,
    "not_enough_data": Tone.IDLE,
}


_PRINTED = (
    *(("degC", "°C"), ("deg/s", "°/s"), ("^2", "²"), ("^3", "³")),
    *(("sqrt(Hz)", "√Hz"), ("sqrt(h)", "√h"), ("sqrt(s)", "√s")),
)
_MICRO, _DEGREES = re.compile(r"\bus\b"), re.compile(r"(?<=\d) deg\b(?!/)")
_FROM = "from_row"
_SMALL = 1e-3
_RAISED = str.maketrans(f"0123456789{MINUS}", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def phase_words(key: str) -> str:
    """Which part of the work is being done."""
    words = {
        "reading": QCoreApplication.translate("Discrepancy", "Reading the rows …"),
        "plan": QCoreApplication.translate("Discrepancy", "Walking the plan with usual sensors …"),
        "case": QCoreApplication.translate("Discrepancy", "Measuring a sealed case …"),
        "floor": QCoreApplication.translate("Discrepancy", "Estimating the noise floor …"),
        "where": QCoreApplication.translate("Discrepancy", "Looking where the residuals are …"),
        "search": QCoreApplication.translate("Discrepancy", "Trying all effects, also in sets …"),
        "steps": QCoreApplication.translate(
            "Discrepancy", "Fitting what was found, and what could decide …"
        ),
        "add": QCoreApplication.translate("Discrepancy", "Fitting the model with the effect …"),
        "play": QCoreApplication.translate(
            "Discrepancy", "Walking the rows on the simulated rig …"
        ),
    }
    return words[key]


def verdict_words(verdict: str) -> str:
    """The verdict as a headline."""
    words = {
        "adequate": QCoreApplication.translate("Discrepancy", "The model explains the data"),
        "explained": QCoreApplication.translate("Discrepancy", "An effect is missing, and named"),
        "ambiguous": QCoreApplication.translate(
            "Discrepancy", "An effect is missing; several names fit"
        ),
        "unexplained_structure": QCoreApplication.translate(
            "Discrepancy", "Structure that no effect explains"
        ),
        "excess_noise": QCoreApplication.translate("Discrepancy", "More noise than is stated"),
        "data_fault": QCoreApplication.translate("Discrepancy", "The data are at fault"),
        "not_enough_data": QCoreApplication.translate("Discrepancy", "Too few rows to tell"),
    }
    return words[verdict]


def closed_words(verdict: str) -> str:
    """The headline once all that was found is in the model; empty where nothing is closed."""
    words = {
        "explained": QCoreApplication.translate("Discrepancy", "Model and data agree now"),
        "ambiguous": QCoreApplication.translate("Discrepancy", "They agree now; several names fit"),
    }
    return words.get(verdict, "")


def regressor_words(key: str) -> str:
    """A regressor by its name; columns of a record keep theirs."""
    return _regressors().get(key, key)


def _regressors() -> dict[str, str]:
    return {
        "head_deg": QCoreApplication.translate("Discrepancy", "Head angle"),
        "set_rate_dps": QCoreApplication.translate("Discrepancy", "Set rate"),
        "a_x": QCoreApplication.translate("Discrepancy", "a_x along case X"),
        "a_y": QCoreApplication.translate("Discrepancy", "a_y along case Y"),
        "a_z": QCoreApplication.translate("Discrepancy", "a_z along case Z"),
        "order": QCoreApplication.translate("Discrepancy", "Order of measuring"),
        "t_s": QCoreApplication.translate("Discrepancy", "Time"),
        "since_mounting": QCoreApplication.translate("Discrepancy", "Time since the mounting"),
        "temperature_c": QCoreApplication.translate("Discrepancy", "Temperature"),
        "temperature_rate": QCoreApplication.translate("Discrepancy", "Rate of temperature"),
        "position": QCoreApplication.translate("Discrepancy", "Position, number"),
        "mount": QCoreApplication.translate("Discrepancy", "Mounting, number"),
        "run": QCoreApplication.translate("Discrepancy", "Pass of the plan"),
        "direction": QCoreApplication.translate("Discrepancy", "Direction of approach"),
        "previous": QCoreApplication.translate("Discrepancy", "Setting before"),
        "channel": QCoreApplication.translate("Discrepancy", "Output"),
        "frequency_hz": QCoreApplication.translate("Discrepancy", "Frequency"),
    }


def plain_words(text: str) -> str:
    """A sentence of the engine with names for the keys of regressors in it."""
    names = {key: name for key, name in _regressors().items() if "_" in key}
    words = (names[one].lower() if one in names else one for one in text.split(" "))
    text = " ".join(words)
    return text[:1].upper() + text[1:]


def unit_words(unit: str) -> str:
    """A unit as it is printed."""
    text = _MICRO.sub("µs", {"deg": "°", "arcsec": "″"}.get(unit, unit)).replace("*", "·")
    for plain, sign in _PRINTED:
        text = text.replace(plain, sign)
    return text


def printed(text: str) -> str:
    """A sentence with its units as they are printed."""
    return _DEGREES.sub("°", text.replace("degC", "°C"))


def effect_words(identifier: str) -> str:
    """The standard name of an effect."""
    if identifier == UNKNOWN or identifier not in CATALOGUE:
        return QCoreApplication.translate("Discrepancy", "Unexplained structure")
    return CATALOGUE[identifier].name


def fitted_words(each: Fitted) -> str:
    """A number of an effect with its uncertainty."""
    name, unit = each.name.replace("_", " "), unit_words(each.unit)
    if each.u != each.u:
        return f"{name} {each.value:.5g} {unit}".rstrip().replace("-", MINUS)
    if 0.0 < abs(each.value) < _SMALL:
        # One power of ten for both, as in 2.987 ± 0.023: zeros in front tell nothing.
        power = math.floor(math.log10(abs(each.value)))
        value, u = value_and_uncertainty(each.value / 10.0**power, each.u / 10.0**power)
        digits = str(power).replace("-", MINUS).translate(_RAISED)
        return f"{name} = ({value} ± {u})·10{digits} {unit}".rstrip()
    value, u = value_and_uncertainty(each.value, each.u)
    return f"{name} = {value} ± {u} {unit}".rstrip()


def numbers_of(parameters: Sequence[Fitted], seconds: FloatArray) -> tuple[str, ...]:
    """All numbers of an effect in words.

    Parameters
    ----------
    seconds : of the blocks of a record, whose numbers nobody knows; empty for other runs
    """
    return tuple(
        fitted_words(
            Fitted("from", float(seconds[int(each.value) - 1]), each.u, "s")
            if each.name == _FROM and 1 <= each.value <= len(seconds)
            else each
        )
        for each in parameters
    )


def summary_words(told: Explanation) -> str:
    """One or two sentences about an explanation."""
    closing = QCoreApplication.translate(
        "Discrepancy", "The gap goes from {before} to {after} noise floors."
    ).format(before=fixed(told.before.gap, 2), after=fixed(told.after.gap, 2))
    named = "; ".join(_either(step) for step in told.steps)
    words = {
        "adequate": QCoreApplication.translate("Discrepancy", "No effect stands out of the noise."),
        "explained": QCoreApplication.translate("Discrepancy", "{named}. {closing}"),
        "data_fault": QCoreApplication.translate("Discrepancy", "{named}. {closing}"),
        "ambiguous": QCoreApplication.translate("Discrepancy", "{named}. {closing}"),
        "unexplained_structure": QCoreApplication.translate("Discrepancy", "{named}. {closing}"),
    }
    template = words.get(told.verdict)
    return told.summary if template is None else template.format(named=named, closing=closing)


def _either(step: Step) -> str:
    names = [step.name, *(effect_words(each) for each in step.indistinguishable_from)]
    return QCoreApplication.translate("Discrepancy", " or ").join(names)


def p_words(p_value: float) -> str:
    """A probability as it is compared with a level."""
    return "p < 0.001" if p_value < 0.001 else f"p = {p_value:.3f}"
