"""How sure the name of a step is: its sign, and words."""

from PySide6.QtCore import QCoreApplication

from core.discrepancy.result import UNKNOWN, Step
from gui.discrepancy.words import effect_words
from gui.discrepancy.working import is_fact, is_noise
from gui.widgets.states import Tone

_SHOWN = 3
"""So many other names stand beside a step; more are counted."""


def tone_of(step: Step) -> Tone:
    """The sign: named alone, doubtful, nothing that is known, or noise that accuses nobody."""
    if step.effect == UNKNOWN or is_fact(step):
        return Tone.BAD
    if step.indistinguishable_from:
        return Tone.DOUBT
    return Tone.IDLE if is_noise(step) else Tone.GOOD


def certainty_words(step: Step) -> str:
    """The same in words, with the other names that fit."""
    if is_fact(step):
        return QCoreApplication.translate("Discrepancy", "a fault of the data, counted in them")
    names = [each for each in step.indistinguishable_from if each != UNKNOWN]
    if step.effect == UNKNOWN:
        if not names:
            return QCoreApplication.translate("Discrepancy", "no effect of the catalogue fits")
        template = QCoreApplication.translate("Discrepancy", "at the best roughly: {names}")
        return template.format(names=_listed(names))
    if not step.indistinguishable_from:
        if is_noise(step):
            return QCoreApplication.translate("Discrepancy", "a term of the noise, no fault")
        return QCoreApplication.translate("Discrepancy", "no other name fits")
    if not names:
        return QCoreApplication.translate(
            "Discrepancy", "but could also be something outside the catalogue"
        )
    if UNKNOWN in step.indistinguishable_from:
        template = QCoreApplication.translate(
            "Discrepancy", "but could also be {names}, or something outside the catalogue"
        )
        return template.format(names=_listed(names))
    template = QCoreApplication.translate("Discrepancy", "but could also be {names}")
    return template.format(names=_listed(names))


def _listed(names: list[str]) -> str:
    listed = ", ".join(effect_words(each) for each in names[:_SHOWN])
    if len(names) <= _SHOWN:
        return listed
    template = QCoreApplication.translate("Discrepancy", "{names} and {count} further names")
    return template.format(names=listed, count=len(names) - _SHOWN)
