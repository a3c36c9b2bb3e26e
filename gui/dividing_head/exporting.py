"""Export: a proposed file name, and the writing of every format."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from core.records.exports import EXPORTS, export, proposed_name
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.writer import write_legacy
from core.records.names import stamp
from core.records.run_file import write_run
from gui.dividing_head.processing import ResultsState
from gui.dividing_head.results import ResultsPresenter
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.states import BannerState

SOURCE = "export"
_RUN = "run"
_LEGACY = "legacy "


class Exporting(QObject):
    """Writes what is on the results page.

    Parameters
    ----------
    results : what is on the page
    folder : returns the folder where files go that are named without one
    jobs : writes the files; MATLAB's format is slow to load
    messages : where it is told
    """

    def __init__(
        self,
        results: ResultsPresenter,
        folder: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._results = results
        self._folder = folder
        self._jobs = jobs
        self._messages = messages
        self.chosen = "json"

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles: calibrations, the legacy texts, the run file."""
        of_head = [x for x in LEGACY_FORMATS.values() if x.id in ("clbacc", "pointer")]
        return (
            *((key, one.title) for key, one in EXPORTS.items()),
            *((f"{_LEGACY}{layout.id}", layout.title) for layout in of_head),
            (_RUN, "Run file of the positions"),
        )

    def propose(self, key: str) -> str:
        """File name for a format, with its folder; empty while there are no results."""
        self.chosen = key
        state = self._results.state
        if state is None:
            return ""
        return str(self._folder() / _name(state, key))

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the session's."""
        state = self._results.state
        if state is None or not name.strip():
            return
        path = self._folder() / Path(name.strip()).expanduser()
        self._jobs.start("export", lambda: _write(state, key, path), self._on_done, self._on_failed)

    def _on_done(self, path: object) -> None:
        self._messages.show(SOURCE, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(SOURCE, "Not exported", error)


def _name(state: ResultsState, key: str) -> str:
    if key in EXPORTS:
        return proposed_name(state.calibration, key)
    stem = proposed_name(state.calibration, "json").removesuffix(EXPORTS["json"].suffix)
    if key == _RUN:
        return f"{stem}.run.csv"
    layout = LEGACY_FORMATS[key.removeprefix(_LEGACY)]
    return f"{layout.stem}_{_stamp(state)}.txt"


def _stamp(state: ResultsState) -> str:
    """Local time of the test's start, of the processing where that is not known."""
    measured = state.run.meta.get("measured_utc") or state.calibration.provenance.computed_utc
    return stamp(datetime.fromisoformat(str(measured)).astimezone())


def _write(state: ResultsState, key: str, path: Path) -> Path:
    if key in EXPORTS:
        export(state.calibration, key, path)
    elif key == _RUN:
        write_run(state.run, path)
    else:
        write_legacy(state.run, LEGACY_FORMATS[key.removeprefix(_LEGACY)], path)
    return path
