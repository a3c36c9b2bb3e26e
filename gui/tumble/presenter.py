"""The page Fourier tumble: clicks in, `TumbleState` out."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.errors import FormatError, LabError
from core.procedures.fourier.study import TumbleRequest, TumbleStudy, study_tumble
from core.records.session.find import newest_session
from core.samples.run import Conditions, Run
from gui.jobs import Jobs
from gui.measuring.loading import Choice, load, mounts_asked
from gui.messages import Messages
from gui.tumble.findings import findings_of
from gui.tumble.pictures import bars_of, polar_of
from gui.tumble.state import TumbleChoices, TumbleState
from gui.widgets.analysis_page import AnalysisState
from gui.widgets.states import ActionBarState, ActionItem

SOURCE = "tumble"
_TEST = "dividing_head"


@dataclass(frozen=True, slots=True, eq=False)
class _Found:
    """What a job brings: the run, and what follows from it or why nothing does."""

    run: Run
    path: Path
    choices: TumbleChoices
    study: TumbleStudy | LabError


class TumblePresenter(QObject):
    """Everything the page asks for.

    Parameters
    ----------
    jobs : reads and computes
    messages : where a refused file is told
    root : returns the folder of all sessions
    """

    changed = Signal(object)
    """A new `TumbleState`."""

    def __init__(
        self,
        jobs: Jobs,
        messages: Messages,
        root: Callable[[], Path],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._root = root
        self._choices = TumbleChoices()
        self._found: _Found | None = None
        self._busy = False
        self._waiting = False
        self._loading: Path | None = None
        messages.action.connect(self._on_action)

    @property
    def study(self) -> TumbleStudy | None:
        """What is on the page."""
        found = self._found
        return found.study if found is not None and isinstance(found.study, TumbleStudy) else None

    @property
    def device(self) -> str:
        """Whose run is on the page."""
        return "" if self._found is None else self._found.run.device

    @property
    def state(self) -> TumbleState:
        """The page as it is now."""
        found, study = self._found, self.study
        done = found is not None and study is not None
        return TumbleState(
            choices=self._choices,
            channels=() if found is None else found.run.channels,
            source=self._source(),
            frame=AnalysisState(
                hint="" if done else self._hint(),
                findings=findings_of(study, self._title(), self._source())
                if study is not None
                else None,
                actions=ActionBarState(self._items()),
            ),
            polar=polar_of(study, found.run) if found is not None and study is not None else None,
            bars=bars_of(study, found.run.unit)
            if found is not None and study is not None
            else None,
        )

    # --- what the operator does -------------------------------------------------------------------

    def load(
        self, name: str, device: str | None = None, mounts: Sequence[str] | None = None
    ) -> None:
        """Read a session, a run file or a legacy file; a file may leave device or mounts open."""
        path, choices = Path(name), replace(self._choices, channel="")
        self._loading = path
        self._start(lambda: _read(path, choices, device, mounts))

    def load_newest(self) -> None:
        """Read the newest session of the dividing head."""
        root, choices = self._root(), replace(self._choices, channel="")
        self._loading = None
        self._start(lambda: _read(_newest(root), choices, None, None))

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        if key == "session":
            self.load_newest()

    def decide(self, choices: TumbleChoices) -> None:
        """Take what was decided, and compute anew."""
        if choices == self._choices:
            return
        self._choices = choices
        found = self._found
        if self._busy:
            self._waiting = True
        elif found is not None:
            run, path = found.run, found.path
            self._start(lambda: _studied(run, path, choices))
        self._tell()

    # --- the work ---------------------------------------------------------------------------------

    def _start(self, work: Callable[[], object]) -> None:
        if self._busy:
            return
        self._busy = True
        self._messages.clear(SOURCE)
        self._jobs.start("tumble", work, self._on_done, self._on_failed)
        self._tell()

    def _on_done(self, result: object) -> None:
        self._busy = False
        if isinstance(result, Choice):
            self._waiting = False
            self._messages.show(SOURCE, result.banner())
            self._tell()
            return
        if not isinstance(result, _Found):
            raise TypeError(f"a tumble brought {type(result).__name__}")
        decided = self._choices if self._waiting else result.choices
        self._found, self._choices = result, decided
        if isinstance(result.study, LabError):
            words = QCoreApplication.translate("Tumble", "This run is no tumble that can be used")
            self._messages.tell_error(SOURCE, words, result.study)
        if self._waiting:
            self._waiting = False
            run, path = result.run, result.path
            self._start(lambda: _studied(run, path, decided))
        self._tell()

    def _on_failed(self, error: LabError) -> None:
        self._busy = self._waiting = False
        words = QCoreApplication.translate("Tumble", "The file is refused")
        self._messages.tell_error(SOURCE, words, error, *mounts_asked(error))
        self._tell()

    def _on_action(self, source: str, key: str) -> None:
        """A button of the banner that asked what a file leaves open."""
        if source != SOURCE or self._loading is None:
            return
        kind, _, value = key.partition(" ")
        if kind == "device":
            self.load(str(self._loading), device=value)
        elif kind == "mounts":
            self.load(str(self._loading), mounts=value.split(","))

    # --- what is shown ----------------------------------------------------------------------------

    def _title(self) -> str:
        found, study = self._found, self.study
        if found is None or study is None:
            return ""
        return f"{found.run.device} {study.tumbles[0].channel}".strip()

    def _source(self) -> str:
        found = self._found
        if found is None:
            return ""
        run = found.run
        words = QCoreApplication.translate(
            "Tumble", "{file}: {readings} readings at {angles} angles, {mounts}"
        )
        return words.format(
            file=found.path.name,
            readings=len(run),
            angles=len(np.unique(np.round(run.head_deg, 6))),
            mounts=", ".join(dict.fromkeys(run.mount)),
        )

    def _hint(self) -> str:
        if self._busy:
            return QCoreApplication.translate("Tumble", "The run is being read …")
        if self._found is not None and isinstance(self._found.study, LabError):
            return f"{self._found.study}."
        return QCoreApplication.translate(
            "Tumble",
            "One accelerometer through a full turn of the dividing head.\n\n"
            "Measure the plan fourier_400 (5° to 400° by 5°) or fourier_flip in the tab Dividing"
            " head, then press Measured Session (Space); or Load Data (Ctrl+O): a session, a run"
            " file, a text file of ClbAcc or Pointer.",
        )

    def _items(self) -> tuple[ActionItem, ...]:
        none = QCoreApplication.translate("Tumble", "There is nothing to export yet.")
        ready = not self._busy
        return (
            ActionItem(
                "session",
                QCoreApplication.translate("Tumble", "Measured Session"),
                "Space",
                default=True,
                enabled=ready,
            ),
            ActionItem(
                "load",
                QCoreApplication.translate("ActionBar", "Load Data"),
                "Ctrl+O",
                enabled=ready,
            ),
            ActionItem(
                "export",
                QCoreApplication.translate("ActionBar", "Export"),
                "Ctrl+E",
                enabled=self.study is not None,
                why_not=none,
            ),
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)


def _newest(root: Path) -> Path:
    folder = newest_session(root, _TEST)
    if folder is None:
        raise FormatError(
            root,
            "holds no session of the dividing head yet; measure one in that tab, or load a file",
        )
    return folder


def _read(
    path: Path, choices: TumbleChoices, device: str | None, mounts: Sequence[str] | None
) -> _Found | Choice:
    run = load(path, device, mounts, "accelerometer")
    if isinstance(run, Choice):
        return run
    known = run.conditions
    stated = {
        "g_mps2": known.g_mps2,
        "u_g_mps2": known.u_g_mps2,
        "head_u_arcsec": known.head_u_arcsec,
    }
    finite = {name: float(value) for name, value in stated.items() if np.isfinite(value)}
    return _studied(run, path, replace(choices, **finite))


def _studied(run: Run, path: Path, choices: TumbleChoices) -> _Found:
    channel = run.channels.index(choices.channel) if choices.channel in run.channels else None
    request = TumbleRequest(
        channel, choices.harmonics, choices.remove_drift, choices.gravity_projection
    )
    conditions: Conditions = replace(
        run.conditions,
        g_mps2=choices.g_mps2,
        u_g_mps2=choices.u_g_mps2,
        head_u_arcsec=choices.head_u_arcsec,
    )
    try:
        study = study_tumble(run, conditions, request)
    except LabError as error:
        # The rows were read: the operator may choose another output.
        return _Found(run, path, choices, error)
    chosen = replace(choices, channel=run.channels[study.channel])
    return _Found(run, path, chosen, study)
