"""Load Data and Process Data of any test, and what the results page shows."""

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from core.certificates.measured import Measured
from core.errors import LabError
from core.records.session.record import SessionRecord
from gui.jobs import Jobs, Work
from gui.measuring.loading import Choice, mounts_asked
from gui.measuring.page import ResultsPage
from gui.messages import Messages
from gui.widgets.states import BannerAction


class Results(QObject):
    """Processes and loads in a worker; a tab derives its own and says with what.

    Parameters
    ----------
    key : of the tab's guide; banners of the results come from ``"KEY results"``
    jobs : where the work is done
    messages : where it is told
    """

    changed = Signal()
    conditions_found = Signal(object)
    """`Conditions` that a loaded file states."""

    def __init__(
        self, key: str, jobs: Jobs, messages: Messages, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.source = f"{key} results"
        self._jobs = jobs
        self._messages = messages
        self._loading: Path | None = None
        self._again: Callable[[str | None, Sequence[str] | None], Work] | None = None
        self.page: ResultsPage | None = None
        """What the page shows; None while there is nothing."""
        self.source_path: Path | None = None
        """File that the page is made of; None where it is the session on the bench."""
        self.busy = False
        self.live_scale: Mapping[str, float] = {}
        """`live_unit` of one unit of output, by role, as far as it is known."""
        self.live_unit = ""
        messages.action.connect(self._on_action)

    @property
    @abstractmethod
    def can_process_again(self) -> bool:
        """Whether a loaded run is there."""

    @property
    @abstractmethod
    def measured(self) -> Measured | None:
        """What a certificate is made of; None while there is nothing."""

    @abstractmethod
    def process_session(
        self, record: SessionRecord, settings: Any, rows: Sequence[int] | None
    ) -> None:
        """Process a session, or some of its rows, with what is on the screen."""

    @abstractmethod
    def process_again(self, settings: Any) -> None:
        """Process the loaded run anew, with what is on the screen now."""

    @abstractmethod
    def load(self, path: Path, settings: Any) -> None:
        """Read a session's folder, a run file or a legacy file, and process it."""

    @abstractmethod
    def take(self, result: object, loaded: bool) -> None:
        """Keep what a work brought, and set `page`.

        Parameters
        ----------
        result : what it returned, but a `Choice`
        loaded : whether it came from a file
        """

    def clear(self) -> None:
        """Close the page."""
        self.page = self.source_path = None
        self._messages.clear(self.source)
        self.changed.emit()

    def start(self, work: Work) -> None:
        """Do a work on what is there already; `take` gets what it returns."""
        self._loading = None
        self._begin(work)

    def start_loading(
        self, path: Path, work_of: Callable[[str | None, Sequence[str] | None], Work]
    ) -> None:
        """Do a work on a file; where the file leaves a choice the operator is asked.

        Parameters
        ----------
        path : the file
        work_of : makes the work from the chosen device and mounts, None where not chosen
        """
        self._loading, self._again = path, work_of
        self._begin(work_of(None, None))

    def _begin(self, work: Work) -> None:
        if self.busy:
            return
        self.busy = True
        self._messages.clear(self.source)
        self._jobs.start("processing", work, self._on_done, self._on_failed)
        self.changed.emit()

    def _on_done(self, result: object) -> None:
        self.busy = False
        if isinstance(result, Choice):
            self._messages.show(self.source, result.banner())
        else:
            path, self._loading = self._loading, None
            loaded = path is not None
            if loaded:
                self.source_path = path
            before = self.page
            self.take(result, loaded)
            if self.page is not None and self.page is not before:
                for note in self.page.notes:
                    self._messages.log(note.severity, note.text, self.source)
        self.changed.emit()

    def _on_failed(self, error: LabError) -> None:
        self.busy = False
        what = "The data cannot be processed" if self._loading is None else "The file is refused"
        actions: tuple[BannerAction, ...] = ()
        if self._loading is not None:
            actions = mounts_asked(error)
        self._messages.tell_error(self.source, what, error, *actions)
        self.changed.emit()

    def _on_action(self, source: str, key: str) -> None:
        if source != self.source or self._loading is None or self._again is None:
            return
        kind, _, value = key.partition(" ")
        if kind == "device":
            self._begin(self._again(value, None))
        elif kind == "mounts":
            self._begin(self._again(None, value.split(",")))
