"""Load Data and Process Data of accelerometers on the head."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject

from core.certificates.measured import Measured, measured_of
from core.records.session.record import SessionRecord
from core.samples.run import Run
from gui.dividing_head.processing import HeadResult, of_addition, of_file, of_run, of_session
from gui.dividing_head.settings import HeadSettings
from gui.jobs import Jobs, Work
from gui.measuring.bending import BendingResults, source_of
from gui.measuring.printed import printed_of
from gui.messages import Messages
from gui.services import Addition
from gui.widgets.states import TableState


class HeadResults(BendingResults):
    """Calibrations of accelerometers.

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
        self._loaded: tuple[Run, str] | None = None
        self.state: HeadResult | None = None
        self.live_unit = "mg"

    @property
    def can_process_again(self) -> bool:
        """Whether a loaded run is there."""
        return self._loaded is not None

    @property
    def measured(self) -> Measured | None:
        """The calibration on the page; None while there is nothing."""
        if self.state is None:
            return None
        return measured_of(self.state.calibration, printed_of(self.state.page.parts))

    def clear(self) -> None:
        """Close the page."""
        self.state = self._loaded = self.addition = None
        super().clear()

    def process_session(
        self, record: SessionRecord, settings: HeadSettings, rows: Sequence[int] | None
    ) -> None:
        """Calibrate a session, or some of its rows; with the g that is on the screen."""
        self.addition = None
        self.start(lambda: of_session(record, settings, rows))

    def process_again(self, settings: HeadSettings) -> None:
        """Calibrate the loaded run anew, with what is on the screen now."""
        if self.addition is not None:
            self.start(self.work_with(self.addition, settings, None))
        elif self._loaded is not None:
            run, source = self._loaded
            self.start(lambda: of_run(run, source, settings))

    def work_with(self, addition: Addition, settings: HeadSettings, kept: Path | None) -> Work:
        """The work that calibrates a run with further effects."""
        if kept is None:
            self._loaded = addition.run, source_of(addition.paths)
        return lambda: of_addition(addition, settings, kept)

    def load(self, path: Path, settings: HeadSettings) -> None:
        """Read a session's folder, a run file or a legacy file, and calibrate it."""
        calibration = None if self.state is None else self.state.calibration

        def work_of(device: str | None, mounts: Sequence[str] | None) -> Work:
            return lambda: of_file(path, settings, device, mounts, calibration)

        self.start_loading(path, work_of)

    def take(self, result: object, loaded: bool) -> None:
        """Keep a calibration, or a table beside the one that is there."""
        match result:
            case HeadResult():
                self.state = result
                self.live_scale = result.mg_per_unit
                if loaded:
                    self.addition = None
                    self._loaded = (result.run, result.page.source)
                    self.conditions_found.emit(result.calibration.conditions)
            case TableState() if self.state is not None:
                self.state = self.state.with_part(result)
            case _:
                raise TypeError(f"processing brought {type(result).__name__}")
        self.page = self.state.page
