"""Load Data and Process Data of gyros."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject

from core.certificates.measured import Measured, measured_of
from core.errors import Severity
from core.records.session.record import SessionRecord
from gui.jobs import Jobs
from gui.jobs import Work as JobWork
from gui.measuring.bending import BendingResults, source_of
from gui.measuring.printed import printed_of
from gui.messages import Messages
from gui.rate_table.processing import Measured as MeasuredRun
from gui.rate_table.processing import RateResult, Work, of_file, of_session
from gui.rate_table.settings import RateSettings
from gui.services import Addition
from gui.widgets.states import BannerAction, BannerState

SAME = BannerAction("same unit", "They are one unit")
FORGET = BannerAction("forget", "Leave the other one out")


class RateResults(BendingResults):
    """Table runs and head runs; one of each is remembered, so that both can be used together.

    Parameters
    ----------
    key : of the tab's guide
    jobs : where the work is done
    messages : where it is told
    """

    def __init__(
        self, key: str, jobs: Jobs, messages: Messages, parent: QObject | None = None
    ) -> None:
        super().__init__(key, jobs, messages, parent)
        self._table: MeasuredRun | None = None
        self._head: MeasuredRun | None = None
        self._settings = RateSettings()
        self._asking = f"{key} two files"
        self.state: RateResult | None = None
        self.live_unit = "deg/h"
        messages.action.connect(self._on_answer)

    @property
    def can_process_again(self) -> bool:
        """Whether a run is there."""
        return self.state is not None

    @property
    def measured(self) -> Measured | None:
        """The calibration on the page; None while there is nothing."""
        if self.state is None:
            return None
        return measured_of(self.state.calibration, printed_of(self.state.page.parts))

    def clear(self) -> None:
        """Close the page; the runs stay, to be used with the next one."""
        self.state = self.addition = None
        self._messages.clear(self._asking)
        super().clear()

    def process_session(
        self, record: SessionRecord, settings: RateSettings, rows: Sequence[int] | None
    ) -> None:
        """Process a session, or some of its rows, with what is on the screen."""
        self._settings = settings

        def work() -> RateResult:
            run = record.run()
            run = run if rows is None else run.rows(rows)
            latest = MeasuredRun(run, record.folder.name)
            return of_session(record.folder, self._of(latest, settings))

        self.addition = None
        self.start(work)

    def process_again(self, settings: RateSettings) -> None:
        """Process the runs anew, with what is on the screen now."""
        if self.state is not None:
            self._settings = settings
            work = self._of(self.state.latest, settings)
            if self.addition is not None:
                work = replace(work, added=self.addition.added)
            self.start(work.result)

    def work_with(self, addition: Addition, settings: RateSettings, kept: Path | None) -> JobWork:
        """The work that calibrates a run with further effects."""
        self._settings = settings
        latest = MeasuredRun(addition.run, source_of(addition.paths))
        work = replace(self._of(latest, settings), added=addition.added)
        return work.result if kept is None else lambda: of_session(kept, work)

    def load(self, path: Path, settings: RateSettings) -> None:
        """Read a session's folder, a run file or a legacy file, and process it."""
        table, head = self._table, self._head
        self._settings = settings

        def work_of(device: str | None, mounts: Sequence[str] | None) -> JobWork:
            return lambda: of_file(path, device, mounts, table, head, settings)

        self.start_loading(path, work_of)

    def take(self, result: object, loaded: bool) -> None:
        """Keep results, and ask where two files are of two units."""
        if not isinstance(result, RateResult):
            raise TypeError(f"processing brought {type(result).__name__}")
        self.state, self.page = result, result.page
        self._table, self._head = result.table, result.head
        self.live_scale = result.dph_per_unit or self.live_scale
        if loaded:
            self.addition = None
            self.conditions_found.emit(result.latest.run.conditions)
        if result.refused:
            self._messages.show(
                self._asking,
                BannerState(
                    Severity.WARNING,
                    "Table and head run are of two units",
                    f"{result.refused} Each was processed by itself.",
                    "",
                    (SAME, FORGET),
                ),
            )
        else:
            self._messages.clear(self._asking)

    def _of(self, latest: MeasuredRun, settings: RateSettings) -> Work:
        return Work(latest, self._table, self._head, settings)

    def _on_answer(self, source: str, key: str) -> None:
        state = self.state
        if source != self._asking or state is None:
            return
        self._messages.clear(self._asking)
        work = self._of(state.latest, self._settings)
        if key == SAME.key:
            self.start(replace(work, same_unit=True).result)
        elif key == FORGET.key:
            self.start(replace(work, table=None, head=None).result)
