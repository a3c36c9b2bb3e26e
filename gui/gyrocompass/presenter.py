"""The page Gyrocompass: clicks in, `CompassState` out."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal

from core.errors import LabError
from gui.gyrocompass.findings import findings_of
from gui.gyrocompass.state import CompassChoices, CompassState, Found, RoseState
from gui.gyrocompass.working import read, work
from gui.jobs import Jobs
from gui.messages import Messages
from gui.record_noise import RecordNoise, noise_of_record
from gui.widgets.analysis_page import AnalysisState
from gui.widgets.states import ActionBarState, ActionItem

SOURCE = "gyrocompass"


class CompassPresenter(QObject):
    """Everything the page asks for.

    Parameters
    ----------
    jobs : reads and computes
    messages : where a refused file is told
    """

    changed = Signal(object)
    """A new `CompassState`."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._found = Found(CompassChoices())
        self._choices = self._found.choices
        self._asked = self._choices
        self._busy = False

    @property
    def found(self) -> Found:
        """What is on the page."""
        return self._found

    @property
    def state(self) -> CompassState:
        """The page as it is now."""
        found = self._found
        findings = findings_of(found)
        return CompassState(
            choices=self._choices,
            channels=() if found.run is None else found.run.channels,
            frame=AnalysisState(
                self._hint() if findings is None else "", findings, ActionBarState(self._items())
            ),
            rose=self._rose(),
            advice=found.advice,
        )

    # --- what the operator does -------------------------------------------------------------------

    def load(self, name: str) -> None:
        """Read a session, a run file or a legacy file."""
        path, choices = Path(name), self._choices
        self._start(lambda: read(path, choices))

    def load_noise(self, name: str) -> None:
        """Take the noise from a record of the gyro at rest."""
        path, factor = Path(name), self._choices.scale_factor
        self._start(lambda: noise_of_record(path, "gyro", factor))

    def set_noise(self, noise: tuple[float, float, float]) -> None:
        """Take noise that was typed."""
        self.decide(replace(self._choices, noise=noise, noise_source=""))

    def decide(self, choices: CompassChoices) -> None:
        """Take what was decided, and compute anew."""
        if choices == self._choices:
            return
        self._choices = choices
        if not self._busy:
            self._again()
        self._tell()

    # --- the work ---------------------------------------------------------------------------------

    def _again(self) -> None:
        run, name, choices = self._found.run, self._found.name, self._choices
        self._start(lambda: work(run, name, choices))

    def _start(self, job: Callable[[], object]) -> None:
        if self._busy:
            return
        self._busy, self._asked = True, self._choices
        self._messages.clear(SOURCE)
        self._jobs.start("gyrocompass", job, self._on_done, self._on_failed)
        self._tell()

    def _on_done(self, result: object) -> None:
        self._busy = False
        match result:
            case Found():
                self._found = result
                if self._choices == self._asked:
                    self._choices = result.choices
                else:
                    self._again()
            case RecordNoise(source, model):
                noise = (model.random_walk, model.bias_instability, model.rate_random_walk)
                self.decide(replace(self._choices, noise=noise, noise_source=source))
            case _:
                raise TypeError(f"a gyrocompass brought {type(result).__name__}")
        self._tell()

    def _on_failed(self, error: LabError) -> None:
        self._busy = False
        words = QCoreApplication.translate("Gyrocompass", "The file is refused")
        self._messages.tell_error(SOURCE, words, error)
        self._tell()

    # --- what is shown ----------------------------------------------------------------------------

    def _rose(self) -> RoseState:
        found = self._found
        readings = self._choices.rows if found.run is None else tuple(found.run.head_deg.tolist())
        if found.compass is None:
            return RoseState(readings_deg=readings)
        heading = found.compass.heading
        azimuths = tuple((heading.value + np.array(readings)).tolist())
        return RoseState(heading.value, heading.low, heading.high, azimuths)

    def _hint(self) -> str:
        if self._busy:
            return QCoreApplication.translate("Gyrocompass", "The run is being read …")
        return QCoreApplication.translate(
            "Gyrocompass",
            "Heading from the rotation of the Earth, by one gyro turned on a level base.\n\n"
            "Load Data (Ctrl+O) reads a run of headings: column head_deg is the reading of the"
            " base, clockwise; tilt_deg the elevation of the input axis by an accelerometer.\n\n"
            "State the noise of the gyro at the left, or take it from a record, to see how long to"
            " average.",
        )

    def _items(self) -> tuple[ActionItem, ...]:
        return (
            ActionItem(
                "load",
                QCoreApplication.translate("ActionBar", "Load Data"),
                "Ctrl+O",
                default=True,
                enabled=not self._busy,
            ),
            ActionItem(
                "export",
                QCoreApplication.translate("ActionBar", "Export"),
                "Ctrl+E",
                enabled=findings_of(self._found) is not None,
                why_not=QCoreApplication.translate(
                    "Gyrocompass", "There is nothing to export yet."
                ),
            ),
        )

    def _tell(self) -> None:
        self.changed.emit(self.state)
