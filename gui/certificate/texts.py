"""Words of the tab Certificates."""

from PySide6.QtCore import QCoreApplication

from core.certificates.register import Issued
from core.procedures.conformity import RULES, Verdict
from gui.certificate.html import verdict_words
from gui.languages.shown import shown
from gui.measuring.page import CurveState, LogCurveState, Part
from gui.widgets.states import ActionItem, ResidualState, TableState


def say(text: str) -> str:
    """The words in the language of the window."""
    return QCoreApplication.translate("CertificateTab", text)


def missing_words(missing: tuple[str, ...]) -> tuple[str, ...]:
    """What `Certificate.missing` tells, in the language of the window."""
    known = {
        "name of the laboratory": say("name of the laboratory"),
        "address of the laboratory": say("address of the laboratory"),
        "person who authorises": say("person who authorises"),
        "standards and their traceability": say("standards and their traceability"),
        "customer": say("customer"),
        "contact of the customer": say("contact of the customer"),
        "item": say("item"),
        "serial number of the item": say("serial number of the item"),
        "condition of the item": say("condition of the item"),
        "date of calibration": say("date of calibration"),
        "date of issue": say("date of issue"),
        "ambient temperature": say("ambient temperature"),
        "results": say("results"),
        "uncertainty of the results": say("uncertainty of the results"),
        "what was changed, and why": say("what was changed, and why"),
    }
    return tuple(known[words] for words in missing)


def rule_titles() -> dict[str, str]:
    """The decision rules in a few words."""
    titles = {
        "guarded": say("guard band U (JCGM 106)"),
        "simple": say("simple acceptance (ILAC-G8)"),
    }
    return {key: titles[key] for key in RULES}


def title_of(part: Part) -> str:
    """A part of the results in a few words."""
    if isinstance(part, TableState):
        return shown(part.title)
    if isinstance(part, ResidualState):
        return say("Residuals by position")
    if isinstance(part, CurveState | LogCurveState):
        return shown(part.title)
    if isinstance(part, tuple):
        return say("Matrices {names}").format(
            names=", ".join(one.symbol.split("=")[0].strip() for one in part)
        )
    return shown(part.text)


def remedy_of(trouble: str) -> str:
    """What to do about a trouble.

    Parameters
    ----------
    trouble : ``"results"``, ``"laboratory"``, ``"twin"``, ``"withdrawal"`` or ``"work"``
    """
    remedies = {
        "results": say("Process them again in their tab, then press Certificate there."),
        "laboratory": say(
            "Correct the place that is named, or move the file away and fill in the page Laboratory"
            " anew; until then nothing is written over it."
        ),
        "twin": say("Its PDF and HTML still hold; take its JSON from a copy of the folder."),
        "withdrawal": say("Type why it holds no longer, then press Withdraw again."),
        "work": say("Nothing was issued. Put right what is named, then do the same again."),
    }
    return remedies[trouble]


def status_words(one: Issued) -> str:
    """Whether an issued certificate holds."""
    if one.damage:
        return say("damaged")
    if one.withdrawn:
        return say("withdrawn")
    if one.replaced_by:
        return say("replaced by {number}").format(number=one.replaced_by)
    return say("valid")


def verdict_of(one: Issued) -> str:
    """The verdict of an issued certificate; empty without one."""
    return verdict_words(Verdict(one.verdict)) if one.verdict else ""


def draft_actions(*, ready: bool, why_not: str) -> tuple[ActionItem, ...]:
    """What can be done with a draft."""
    return (
        ActionItem(
            "issue",
            say("Issue"),
            "Ctrl+Return",
            default=True,
            enabled=ready,
            why_not=why_not,
        ),
        ActionItem("load", say("Load Data"), "Ctrl+O"),
    )


def issued_actions(*, holds: bool, has_files: bool, has_draft: bool) -> tuple[ActionItem, ...]:
    """What can be done with a certificate that was issued."""
    return (
        ActionItem("draft", say("Back to the draft"), "Esc", default=True, enabled=has_draft),
        ActionItem(
            "replace",
            say("Replace"),
            enabled=holds,
            why_not=say("It was replaced or withdrawn before"),
        ),
        ActionItem(
            "files",
            say("Write PDF and HTML"),
            enabled=not has_files,
            why_not=say("They are there; nothing is overwritten"),
        ),
        ActionItem("load", say("Load Data"), "Ctrl+O"),
    )
