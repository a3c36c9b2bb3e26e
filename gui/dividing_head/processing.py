"""From measurements to a calibration with its tables; runs in a worker thread."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, Severity, StorageError
from core.fit.result import FitResult
from core.plans.orientation import BaseOrientation
from core.procedures.added import NOTHING, Added
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import write_calibration
from core.records.session.record import SessionRecord
from core.samples.run import Conditions, Run
from core.units import MILLI
from gui.dividing_head.settings import HeadSettings, tilter_of
from gui.dividing_head.tables import (
    accuracy_table,
    attitude_table,
    derived_table,
    matrices,
    measured_table,
    parameter_table,
    residuals,
)
from gui.measuring.added_table import added_names, added_table
from gui.measuring.bending import source_of
from gui.measuring.loading import Choice, load
from gui.measuring.nominal import FILE
from gui.measuring.page import Part, ResultsPage
from gui.services import Addition
from gui.widgets.states import MatrixState, TableState


@dataclass(frozen=True, slots=True)
class Stand:
    """What stands between the shaft of the head and the case.

    Parameters
    ----------
    base : how the head's base plate stands
    tilter_deg : yaw, pitch, roll of the tilter on the plate
    """

    base: BaseOrientation
    tilter_deg: tuple[float, float, float]

    @classmethod
    def of(cls, run: Run, settings: HeadSettings) -> "Stand":
        """As the run's session states it; else as it is on the screen."""
        names = ("alpha_arcmin", "beta_arcmin", "gamma_deg", "psi_deg")
        found = [run.meta.get(f"base_{name}") for name in names]
        numbers = [float(value) for value in found if isinstance(value, int | float)]
        if len(numbers) < len(names):
            return cls(settings.base, settings.tilter.angles_deg)
        return cls(BaseOrientation(*numbers), tilter_of(run.meta, "tilter_").angles_deg)


@dataclass(frozen=True, slots=True, eq=False)
class HeadResult:
    """What processing gives.

    Parameters
    ----------
    page : what is shown
    mg_per_unit : milli-g of one unit of output, by the role of the channel
    calibration, run : what the tables and the exports are made of
    """

    page: ResultsPage
    mg_per_unit: Mapping[str, float]
    calibration: Calibration
    run: Run

    @property
    def matrices(self) -> tuple[tuple[MatrixState, ...], ...]:
        """K with U0, and Q, of a triad."""
        return tuple(part for part in self.page.parts if isinstance(part, tuple))

    @property
    def tables(self) -> tuple[TableState, ...]:
        """Every table."""
        return self.page.tables

    @property
    def notes(self) -> tuple[Note, ...]:
        """Every doubt."""
        return self.page.notes

    def with_part(self, part: TableState) -> "HeadResult":
        """The result with one more table at its end, instead of one of the same title."""
        kept = tuple(
            one
            for one in self.page.parts
            if not (isinstance(one, TableState) and one.title == part.title)
        )
        return replace(self, page=replace(self.page, parts=(*kept, part)))


def of_session(
    record: SessionRecord, settings: HeadSettings, rows: Sequence[int] | None
) -> HeadResult:
    """Calibrate a session, or some of its rows; its calibration is kept in its folder."""
    run = record.run()
    if rows is not None:
        run = run.rows(rows)
    state = _results(run, settings.conditions(), Stand.of(run, settings), record.folder.name)
    return _kept(state, record.folder)


def _kept(state: HeadResult, folder: Path) -> HeadResult:
    """The result, its calibration left in the session's folder."""
    try:
        write_calibration(state.calibration, folder / FILE)
    except StorageError as error:
        note = Note(Severity.WARNING, "not_kept", f"the calibration was not kept: {error}")
        page = replace(state.page, parts=(note, *state.page.parts))
        state = replace(state, page=page)
    return state


def of_run(run: Run, source: str, settings: HeadSettings) -> HeadResult:
    """Calibrate a run with what is on the screen."""
    return _results(run, settings.conditions(), Stand.of(run, settings), source)


def of_addition(addition: Addition, settings: HeadSettings, kept: Path | None) -> HeadResult:
    """Calibrate a run with further effects; `kept` is the session's folder, None for files."""
    run, stated = addition.run, settings.conditions()
    conditions = stated if kept is not None else _stated(run.conditions, stated)
    source = source_of(addition.paths)
    state = _results(run, conditions, Stand.of(run, settings), source, addition.added)
    return state if kept is None else _kept(state, kept)


def of_file(
    path: Path,
    settings: HeadSettings,
    device: str | None,
    mounts: Sequence[str] | None,
    calibration: Calibration | None,
) -> HeadResult | TableState | Choice:
    """Calibrate what a file holds; an accuracy check gives a table by the present calibration.

    Raises
    ------
    FormatError, FitError
        The file is refused, or holds something else.
    """
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
    conditions = _stated(run.conditions, settings.conditions())
    return _results(run, conditions, Stand.of(run, settings), path.name)


def _results(
    run: Run, conditions: Conditions, stand: Stand, source: str, added: Added = NOTHING
) -> HeadResult:
    calibration = calibrate(run, conditions, stand.base, stand.tilter_deg, added)
    source_file, sha256 = run.meta.get("source"), run.meta.get("source_sha256")
    if not calibration.provenance.records and source_file and sha256:
        calibration = replace(
            calibration,
            provenance=replace(calibration.provenance, records=((str(source_file), str(sha256)),)),
        )
    named = [
        Note(note.severity, note.subject, f"{name}: {note.text}")
        for name, fit in zip(calibration.channels, calibration.fits, strict=True)
        for note in fit.notes
    ]
    notes = (*calibration.notes, *named)
    in_matrices = matrices(calibration)
    parameters, plot = parameter_table(calibration), residuals(calibration, run)
    parts: list[Part] = (
        [*in_matrices, *notes, plot, parameters] if in_matrices else [parameters, *notes, plot]
    )
    bent = added_table(calibration)
    if bent is not None:
        parts.insert(0, bent)
    parts += [derived_table(calibration), measured_table(calibration, run)]
    check = attitude_table(calibration, run, stand.base, stand.tilter_deg)
    if check is not None:
        parts.append(check)
    return HeadResult(
        page=ResultsPage(
            f"{run.device}, {len(run)} positions",
            source,
            tuple(parts),
            effects=added_names(calibration),
        ),
        mg_per_unit=_mg_per_unit(calibration),
        calibration=calibration,
        run=run,
    )


def _stated(of_run: Conditions, of_screen: Conditions) -> Conditions:
    """What the run states, and what is on the screen where it states nothing."""
    names = ("g_mps2", "u_g_mps2", "head_u_arcsec")
    stated = {name: getattr(of_run, name) for name in names}
    return replace(
        of_screen, **{name: value for name, value in stated.items() if np.isfinite(value)}
    )


def _mg_per_unit(calibration: Calibration) -> Mapping[str, float]:
    k = np.array([[_sensitivity(fit)] for fit in calibration.fits])
    roles = tuple(_role_of(name) for name in calibration.channels)
    return mg_per_unit(k, roles, calibration.conditions.g_mps2)


def _sensitivity(fit: FitResult) -> float:
    """Change of output per unit of input in the steepest direction."""
    slopes = [
        value
        for name, value in zip(fit.names, fit.values.tolist(), strict=True)
        if name == "scale_factor" or name.startswith("cross_axis_")
    ]
    return float(np.linalg.norm(slopes))


def _role_of(channel: str) -> str:
    """``acc_x`` -> ``acc.x``; an assembly's ``acc_3`` -> ``adc.3``."""
    which = channel.rpartition("_")[2]
    return f"adc.{which}" if which.isdecimal() else f"acc.{which}"


def mg_per_unit(k: FloatArray, roles: tuple[str, ...], g: float) -> dict[str, float]:
    """Milli-g of one unit of output, by role.

    Parameters
    ----------
    k : (c, 3) output per m/s^2 along each case axis; the steepest counts
    roles : (c,) of the outputs
    g : local gravity, m/s^2
    """
    sensitivity = np.linalg.norm(k, axis=1)
    return {
        role: 1.0 / (float(s) * g * MILLI)
        for role, s in zip(roles, sensitivity, strict=True)
        if s > 0
    }
