"""Load Data and Process Data, and what the results page shows."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError, Severity
from core.records.session.record import SessionRecord
from core.samples.run import Run
from gui.dividing_head.loading import Choice, mounts_asked
from gui.dividing_head.processing import ResultsState, of_file, of_run, of_session
from gui.dividing_head.settings import HeadSettings
from gui.jobs import Jobs, Work
from gui.messages import Messages
from gui.widgets.states import BannerAction, BannerState, TableState

SOURCE = "results"


class ResultsPresenter(QObject):
    """Processes and loads.

    Parameters
    ----------
    jobs : where the work is done
    messages : where it is told
    """

    changed = Signal()
    conditions_found = Signal(object)
    """`Conditions` that a loaded file states."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._settings = HeadSettings()
        self._loading: Path | None = None
        self._loaded: tuple[Run, str] | None = None
        self.state: ResultsState | None = None
        self.busy = False
        self.mg_per_unit: Mapping[str, float] = {}
        """Milli-g of one unit of output, by role, as far as it is known."""
        messages.action.connect(self._on_action)

    @property
    def can_process_again(self) -> bool:
        """Whether a loaded run is there."""
        return self._loaded is not None

    def clear(self) -> None:
        """Close the page."""
        self.state, self._loaded = None, None
        self._messages.clear(SOURCE)
        self.changed.emit()

    def process_session(
        self, record: SessionRecord, settings: HeadSettings, rows: Sequence[int] | None
    ) -> None:
        """Calibrate a session, or some of its rows; with the g that is on the screen."""
        if any(settings.tilter.angles_deg):
            self._messages.show(
                SOURCE,
                BannerState(
                    Severity.WARNING,
                    "Positions on a tilted plate cannot be processed",
                    "The angles of the tilter are stored with the session; the calibration knows"
                    " the mounts and the head alone.",
                    "Measure with the tilter at zero.",
                ),
            )
            return
        self._loading = None
        self._start(lambda: of_session(record, settings, rows))

    def process_again(self, settings: HeadSettings) -> None:
        """Calibrate the loaded run anew, with what is on the screen now."""
        if self._loaded is not None:
            run, source = self._loaded
            self._loading = None
            self._start(lambda: of_run(run, source, settings))

    def load(
        self,
        path: Path,
        settings: HeadSettings,
        device: str | None = None,
        mounts: Sequence[str] | None = None,
    ) -> None:
        """Read a session's folder, a run file or a legacy file, and calibrate it."""
        self._loading, self._settings = path, settings
        calibration = None if self.state is None else self.state.calibration
        self._start(lambda: of_file(path, settings, device, mounts, calibration))

    def _start(self, work: Work) -> None:
        if self.busy:
            return
        self.busy = True
        self._messages.clear(SOURCE)
        self._jobs.start("processing", work, self._on_done, self._on_failed)
        self.changed.emit()

    def _on_done(self, result: object) -> None:
        self.busy = False
        match result:
            case ResultsState():
                self._show(result)
            case Choice():
                self._messages.show(SOURCE, result.banner())
            case TableState() if self.state is not None:
                kept = tuple(t for t in self.state.tables if t.title != result.title)
                self.state = replace(self.state, tables=(*kept, result))
            case _:
                raise TypeError(f"processing brought {type(result).__name__}")
        self.changed.emit()

    def _show(self, state: ResultsState) -> None:
        self.state = state
        calibration = state.calibration
        if self._loading is not None:
            self._loaded = (state.run, state.source)
            self._loading = None
            self.conditions_found.emit(calibration.conditions)
        self.mg_per_unit = state.mg_per_unit
        for note in state.notes:
            self._messages.log(note.severity, note.text, SOURCE)

    def _on_failed(self, error: LabError) -> None:
        self.busy = False
        what = "The data cannot be processed" if self._loading is None else "The file is refused"
        actions: tuple[BannerAction, ...] = ()
        if self._loading is not None:
            actions = mounts_asked(error)
        self._messages.tell_error(SOURCE, what, error, *actions)
        self.changed.emit()

    def _on_action(self, source: str, key: str) -> None:
        if source != SOURCE or self._loading is None:
            return
        kind, _, value = key.partition(" ")
        if kind == "device":
            self.load(self._loading, self._settings, device=value)
        elif kind == "mounts":
            self.load(self._loading, self._settings, mounts=value.split(","))
