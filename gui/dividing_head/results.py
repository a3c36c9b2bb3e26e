"""Load Data and Process Data: a run becomes a calibration and its tables, in a worker."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from core.arrays import FloatArray
from core.errors import FitError, LabError, Note, Severity, StorageError
from core.plans.orientation import BaseOrientation
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.session.record import SessionRecord
from core.samples.run import Conditions, Run
from gui.dividing_head.live import mg_per_unit
from gui.dividing_head.loading import Choice, load, mounts_asked
from gui.dividing_head.nominal import FILE
from gui.dividing_head.settings import HeadSettings
from gui.dividing_head.tables import (
    accuracy_table,
    attitude_table,
    derived_table,
    matrices,
    measured_table,
    parameter_table,
    residuals,
)
from gui.jobs import Jobs, Work
from gui.messages import Messages
from gui.widgets.states import (
    BannerAction,
    BannerState,
    MatrixState,
    ResidualState,
    TableState,
)

SOURCE = "results"


@dataclass(frozen=True, slots=True, eq=False)
class ResultsState:
    """The results page.

    Parameters
    ----------
    title : device and number of positions
    source : session or file
    parameters : of every sensor
    matrices : K with U0, and Q, of a triad
    residuals : by position
    tables : what else there is, in the order of reading
    notes : every doubt
    calibration, run, base : what the tables and the exports are made of
    """

    title: str
    source: str
    parameters: TableState
    matrices: tuple[tuple[MatrixState, ...], ...]
    residuals: ResidualState
    tables: tuple[TableState, ...]
    notes: tuple[Note, ...]
    calibration: Calibration
    run: Run
    base: BaseOrientation


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
        self._start(lambda: _of_session(record, settings, rows))

    def process_again(self, settings: HeadSettings) -> None:
        """Calibrate the loaded run anew, with what is on the screen now."""
        if self._loaded is not None:
            run, source = self._loaded
            self._loading = None
            self._start(lambda: _of_run(run, source, settings))

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
        self._start(lambda: _loaded(path, settings, device, mounts, calibration))

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
        slopes = np.array(
            [[float(np.linalg.norm(_responses(fit.names, fit.values)))] for fit in calibration.fits]
        )
        roles = tuple(_role_of(name) for name in calibration.channels)
        self.mg_per_unit = mg_per_unit(slopes, roles, calibration.conditions.g_mps2)
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


def _of_session(
    record: SessionRecord, settings: HeadSettings, rows: Sequence[int] | None
) -> ResultsState:
    run = record.run()
    if rows is not None:
        run = run.rows(rows)
    state = _results(run, settings.conditions(), record.start.base, record.folder.name)
    try:
        write_calibration(state.calibration, record.folder / FILE)
    except StorageError as error:
        note = Note(Severity.WARNING, "not_kept", f"the calibration was not kept: {error}")
        state = replace(state, notes=(*state.notes, note))
    return state


def _of_run(run: Run, source: str, settings: HeadSettings) -> ResultsState:
    return _results(run, settings.conditions(), settings.base, source)


def _loaded(
    path: Path,
    settings: HeadSettings,
    device: str | None,
    mounts: Sequence[str] | None,
    calibration: Calibration | None,
) -> ResultsState | TableState | Choice:
    run = load(path, device, mounts)
    if isinstance(run, Choice):
        return run
    if run.test == "accuracy":
        if calibration is None or not calibration.is_triad:
            raise FitError(
                f"{path.name} is an accuracy check: load or measure the calibration of the triad"
                " first, then load this file"
            )
        return accuracy_table(calibration, run)
    if run.sensor != "accelerometer" or run.test != "dividing_head":
        raise FitError(
            f"{path.name} holds a {run.sensor} in the test {run.test!r}; here are"
            " accelerometers on the dividing head"
        )
    return _results(
        run, _stated(run.conditions, settings.conditions()), _base(run, settings), path.name
    )


def _results(run: Run, conditions: Conditions, base: BaseOrientation, source: str) -> ResultsState:
    calibration = calibrate(run, conditions, base)
    source_file, sha256 = run.meta.get("source"), run.meta.get("source_sha256")
    if not calibration.provenance.records and source_file and sha256:
        calibration = replace(
            calibration,
            provenance=replace(calibration.provenance, records=((str(source_file), str(sha256)),)),
        )
    tables = [derived_table(calibration), measured_table(calibration, run)]
    check = attitude_table(calibration, run, base)
    if check is not None:
        tables.append(check)
    named = [
        Note(note.severity, note.subject, f"{name}: {note.text}")
        for name, fit in zip(calibration.channels, calibration.fits, strict=True)
        for note in fit.notes
    ]
    return ResultsState(
        title=f"{run.device}, {len(run)} positions",
        source=source,
        parameters=parameter_table(calibration),
        matrices=matrices(calibration),
        residuals=residuals(calibration, run),
        tables=tuple(tables),
        notes=(*calibration.notes, *named),
        calibration=calibration,
        run=run,
        base=base,
    )


def _stated(of_run: Conditions, of_screen: Conditions) -> Conditions:
    """What the run states, and what is on the screen where it states nothing."""
    names = ("g_mps2", "u_g_mps2", "head_u_arcsec")
    stated = {name: getattr(of_run, name) for name in names}
    return replace(
        of_screen, **{name: value for name, value in stated.items() if np.isfinite(value)}
    )


def _base(run: Run, settings: HeadSettings) -> BaseOrientation:
    """The base plate as a session states it; else as it is on the screen."""
    names = ("alpha_arcmin", "beta_arcmin", "gamma_deg", "psi_deg")
    found = [run.meta.get(f"base_{name}") for name in names]
    if any(not isinstance(value, int | float) for value in found):
        return settings.base
    return BaseOrientation(*(float(value) for value in found if isinstance(value, int | float)))


def _responses(names: Sequence[str], values: FloatArray) -> FloatArray:
    """Scale factor and cross-axis sensitivities."""
    return values[[i for i, name in enumerate(names) if name != "bias"]]


def _role_of(channel: str) -> str:
    """``acc_x`` -> ``acc.x``; an assembly's ``acc_3`` -> ``adc.3``."""
    which = channel.rpartition("_")[2]
    return f"adc.{which}" if which.isdecimal() else f"acc.{which}"
