"""Words and buttons of the Live tab for each phase."""

from PySide6.QtCore import QCoreApplication

from core.errors import Severity
from gui.live.state import Phase
from gui.widgets.states import ActionBarState, ActionItem, BannerAction, BannerState, Tone

RESUME, DISCARD = "resume", "discard"


def _say(text: str) -> str:
    return QCoreApplication.translate("LiveScene", text)


def headline(phase: Phase, name: str) -> tuple[str, Tone]:
    """What the tab does, in words, and how urgent that is."""
    words = {
        Phase.OFFLINE: (_say("No samples: choose a device, or load a record"), Tone.IDLE),
        Phase.WATCHING: (_say("Watching, not recorded"), Tone.IDLE),
        Phase.RECORDING: (_say("Recording {name}").format(name=name), Tone.GOOD),
        Phase.STOPPED: (_say("Stopped: {name}").format(name=name), Tone.DOUBT),
        Phase.LOADED: (_say("Record {name}").format(name=name), Tone.IDLE),
    }
    return words[phase]


def actions(phase: Phase, *, linked: bool, resumable: bool, samples: bool) -> ActionBarState:
    """The row of buttons.

    Parameters
    ----------
    phase : what the tab does
    linked : whether a device sends samples whose rate is known
    resumable : whether the stopped record can go on
    samples : whether anything is on the screen
    """
    no_device = _say("No device sends samples, or their rate is not known yet")
    start = ActionItem(
        "start",
        _say("START sampling process"),
        "Space",
        default=True,
        enabled=linked,
        why_not=no_device,
    )
    stop = ActionItem("stop", _say("STOP sampling process"), "Esc")
    busy = _say("A record is running") if phase is Phase.RECORDING else ""
    stopped = phase is Phase.STOPPED and resumable
    none_stopped = busy or _say("No record is stopped")
    return ActionBarState(
        (
            stop if phase is Phase.RECORDING else start,
            ActionItem(RESUME, _say("Resume"), "Ctrl+R", enabled=stopped, why_not=none_stopped),
            ActionItem(DISCARD, _say("Discard"), "Delete", enabled=stopped, why_not=none_stopped),
            ActionItem(
                "watch",
                _say("Live view"),
                "F6",
                enabled=phase in (Phase.STOPPED, Phase.LOADED),
                why_not=busy or _say("The live view is on the screen"),
            ),
            ActionItem("load", _say("Load record"), "Ctrl+O", enabled=not busy, why_not=busy),
            ActionItem(
                "export",
                _say("Export"),
                "Ctrl+E",
                enabled=samples,
                why_not=_say("Nothing is on the screen"),
            ),
        )
    )


def stopped_banner(name: str, count: int, seconds: float) -> BannerState:
    """The record has stopped: what is there, and that it can go on or be put aside."""
    return BannerState(
        Severity.INFO,
        _say("Record stopped"),
        _say("{name}: {count} samples, {seconds} s, safe on the disk.").format(
            name=name, count=count, seconds=f"{seconds:.1f}"
        ),
        _say("START begins another one."),
        (BannerAction(RESUME, _say("Resume")), BannerAction(DISCARD, _say("Discard"))),
    )
