"""Load Data and Process Data of accuracy checks; also after every accepted angle."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject

from core.archive.nearest import Usable
from core.certificates.measured import Measured
from core.errors import Note, Severity, StorageError
from core.procedures.accuracy_plan import angles_of_text
from core.records.session.record import SessionRecord
from gui.accuracy.certified import measured_of_check
from gui.accuracy.checking import Checked, CheckRequest, check_file, check_run
from gui.accuracy.page import AccuracyPage, page_of
from gui.accuracy.settings import AccuracySettings
from gui.accuracy.state import PAGES
from gui.accuracy.texts import say
from gui.accuracy.written import KEPT, write_csv
from gui.jobs import Jobs, Work
from gui.measuring.results import Results
from gui.messages import Messages
from gui.services import Nearest

_STEP_DEG = 0.01


class AccuracyResults(Results):
    """Accuracy checks.

    Parameters
    ----------
    key : of the tab's guide
    jobs : where the work is done
    messages : where it is told
    root : returns the folder of all sessions, where calibrations are looked for
    near : returns the nearest calibrations of the archive; None to look into the folders alone
    """

    def __init__(
        self,
        key: str,
        jobs: Jobs,
        messages: Messages,
        root: Callable[[], Path],
        near: Nearest | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(key, jobs, messages, parent)
        self._root = root
        self._near = None if near is None else _Asked(near)
        self._loaded: Checked | None = None
        self._hidden: set[str] = set()
        self._shown = PAGES[0]
        self._level = float("nan")
        self._told: set[Note] = set()
        self._waiting: Work | None = None
        self.state: Checked | None = None

    @property
    def can_process_again(self) -> bool:
        """Whether a loaded run is there."""
        return self._loaded is not None

    @property
    def measured(self) -> Measured | None:
        """The check on the page; None while there is nothing."""
        return None if self.state is None else measured_of_check(self.state)

    def clear(self) -> None:
        """Close the page."""
        self._forget()
        self.state, self._loaded = None, None
        self._told.clear()
        super().clear()

    def process_session(
        self,
        record: SessionRecord,
        settings: AccuracySettings,
        rows: Sequence[int] | None,
    ) -> None:
        """Judge a session, or some of its rows."""
        request = self._request(settings)
        work: Work = lambda: _of_session(record, rows, request)  # noqa: E731
        if self.busy:
            self._waiting = work
        else:
            self.start(work)

    def process_again(self, settings: AccuracySettings) -> None:
        """Judge the loaded run anew, with what is on the screen now."""
        if self._loaded is not None:
            old = self._loaded
            request = replace(
                self._request(settings), angles_deg=old.request.angles_deg, kind=old.request.kind
            )
            self.start(lambda: check_run(old.run, old.source, request))

    def load(self, path: Path, settings: AccuracySettings) -> None:
        """Read a session's folder, a run file or an Accuracy file, and judge it."""
        self._forget()
        request = self._request(settings)

        def work_of(device: str | None, mounts: Sequence[str] | None) -> Work:  # noqa: ARG001
            return lambda: check_file(path, device, request)

        self.start_loading(path, work_of)

    def take_angles(self, text: str, kind: str, settings: AccuracySettings) -> str:
        """Judge the loaded run by another list of set angles; return why not, empty if so.

        Raises
        ------
        FormatError
            The text is no list of angles.
        """
        angles = angles_of_text(text)
        old = self._loaded
        if old is None:
            return say("No file is loaded.")
        if len(angles) != len(old.run):
            return say("The file has {rows} rows, the list {angles} angles.").format(
                rows=len(old.run), angles=len(angles)
            )
        request = replace(self._request(settings), angles_deg=angles, kind=kind)
        self.start(lambda: check_run(old.run, old.source, request))
        return ""

    def take(self, result: object, loaded: bool) -> None:
        """Keep a judged check."""
        if not isinstance(result, Checked):
            raise TypeError(f"processing brought {type(result).__name__}")
        self.state = result
        if loaded or self._loaded is not None:
            self._loaded = result
        if loaded:
            self._told.clear()
            self.conditions_found.emit(result.request.conditions)
        self._remake(result)
        self._told.update(result.found.notes)
        if self._waiting is not None:
            work, self._waiting = self._waiting, None
            self.start(work)

    def show_page(self, key: str) -> None:
        """Show another page of the graph."""
        self._shown = key
        self._again_drawn()

    def show_trace(self, key: str, on: bool) -> None:
        """Show a trace, or hide it."""
        if on:
            self._hidden.discard(key)
        else:
            self._hidden.add(key)
        self._again_drawn()

    def set_level(self, level: float) -> None:
        """The angle that the unit tells now, deg; NaN for none."""
        if abs(level - self._level) < _STEP_DEG or (level != level and self._level != self._level):
            return
        self._level = level
        if self._shown == "current":
            self._again_drawn()

    def _again_drawn(self) -> None:
        if self.state is not None and self.page is not None:
            self._remake(self.state)
            self.changed.emit()

    def _remake(self, checked: Checked) -> None:
        page: AccuracyPage = page_of(checked, self._shown, self._hidden, self._level)
        fresh = tuple(note for note in checked.found.notes if note not in self._told)
        self.page = replace(page, fresh=fresh)

    def _forget(self) -> None:
        """Ask the archive anew for the next check."""
        if self._near is not None:
            self._near = _Asked(self._near.near)

    def _request(self, settings: AccuracySettings) -> CheckRequest:
        return CheckRequest(
            settings.conditions(),
            settings.calibration,
            self._root(),
            settings.limit,
            near=self._near,
        )


class _Asked:
    """Asks the archive once for a check: it is judged anew after every angle.

    Parameters
    ----------
    near : the archive
    """

    def __init__(self, near: Nearest) -> None:
        self.near = near
        self._told: dict[str, tuple[Usable, ...]] = {}

    def __call__(
        self, device: str, when: datetime, warmth: float, sensor: str
    ) -> tuple[Usable, ...]:
        if device not in self._told:
            self._told[device] = self.near(device, when, warmth, sensor)
        return self._told[device]


def _of_session(
    record: SessionRecord, rows: Sequence[int] | None, request: CheckRequest
) -> Checked:
    """Judge a session; the verdict is kept in its folder."""
    run = record.run()
    if rows is not None:
        run = run.rows(rows)
    checked = check_run(run, record.folder.name, request)
    try:
        write_csv(checked, record.folder / KEPT)
    except StorageError as error:
        note = Note(Severity.WARNING, "not_kept", f"the verdict was not kept: {error}")
        found = replace(checked.found, notes=(*checked.found.notes, note))
        return replace(checked, found=found)
    return checked
