"""Words of the Accuracy tab that several parts use."""

from PySide6.QtCore import QCoreApplication

from core.procedures.accuracy import TITLES
from core.procedures.angle_errors import PITCH
from core.procedures.conformity import Verdict
from gui.widgets.states import Tone

VERDICT_TONE = {Verdict.PASS: Tone.GOOD, Verdict.FAIL: Tone.BAD, Verdict.UNDECIDED: Tone.DOUBT}


def say(text: str) -> str:
    """The words in the language of the window."""
    return QCoreApplication.translate("Accuracy", text)


def kind_word(kind: str) -> str:
    """Pitch or Roll, as the screens call it."""
    return say("Pitch") if kind == PITCH else say("Roll")


def other_word(kind: str) -> str:
    """The angle that stays level while `kind` is set."""
    return say("Roll") if kind == PITCH else say("Pitch")


def trace_word(source: str) -> str:
    """Name of a trace as Pointer calls it."""
    return QCoreApplication.translate("Accuracy", TITLES[source])


def verdict_word(verdict: Verdict) -> str:
    """The verdict in capitals."""
    return {
        Verdict.PASS: say("PASS"),
        Verdict.FAIL: say("FAIL"),
        Verdict.UNDECIDED: say("UNDECIDED"),
    }[verdict]


def page_names(kind: str) -> tuple[tuple[str, str], ...]:
    """Keys and names of the pages of the graph, as Pointer calls them."""
    main, other = kind_word(kind), other_word(kind)
    return (
        ("error", say("{angle} Error").format(angle=main)),
        ("cross", other),
        ("heading", say("Heading")),
        ("current", say("Current {angle}").format(angle=main)),
        ("temperature", say("Temperature")),
    )
