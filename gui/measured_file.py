"""What a file holds, ready for a certificate: processed as the tab of its test would do it."""

import math
from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import TypeVar

from core.certificates.measured import Measured, measured_of
from core.errors import FormatError
from core.procedures.calibration import Calibration
from core.records.calibration_json import read_calibration
from core.records.cvgcom import is_cvgcom
from core.records.noise_study import StudyRequest
from core.records.open import read_any
from core.records.session.record import JOURNAL_NAME, START_NAME, read_session
from core.records.session.start import SessionStart
from core.samples.run import Conditions, Run
from drivers.records import is_recording
from gui.measuring.loading import Choice
from gui.measuring.page import Part
from gui.measuring.printed import printed_of
from gui.measuring.settings import MeasuringSettings

T = TypeVar("T", bound=MeasuringSettings)


def measured_of_file(
    path: Path,
    conditions: Conditions,
    device: str | None = None,
    request: StudyRequest | None = None,
) -> Measured:
    """Read a session, a run file, a legacy file, a calibration, or a record at rest.

    Parameters
    ----------
    path : recognised by what it holds
    conditions : what the laboratory states; a session and a run file know better themselves
    device : which one, where a file holds several
    request : how a record at rest is analysed; None for what its file tells

    Raises
    ------
    FormatError, FitError
        It is refused, or holds what no certificate is made of.
    """
    if path.suffix.lower() == ".json" and path.name not in (START_NAME, JOURNAL_NAME):
        calibration = read_calibration(path)
        return measured_of(calibration, printed_of(parts_of_calibration(calibration)))
    if path.is_file() and (is_recording(path) or is_cvgcom(path)):
        return _of_record(path, conditions, request)
    run = read_any(path, device=device)
    if run.test == "record":
        return _of_record(path, conditions, request)
    if run.test not in _READERS:
        raise FormatError(
            path,
            f"holds the test {run.test!r}; certificates are made of {', '.join(_READERS)}, record",
        )
    return _READERS[run.test](path, run, conditions, device)


def parts_of_calibration(calibration: Calibration) -> tuple[Part, ...]:
    """What can be printed of a calibration alone, without its measurements."""
    from gui.dividing_head.tables import derived_table, matrices, parameter_table

    notes = (
        *calibration.notes,
        *(
            replace(note, text=f"{name}: {note.text}")
            for name, fit in zip(calibration.channels, calibration.fits, strict=True)
            for note in fit.notes
        ),
    )
    if calibration.sensor != "accelerometer":
        from gui.rate_table.tables import parameter_table as of_gyros

        return (of_gyros(calibration), *notes)
    parts = (*matrices(calibration), parameter_table(calibration), *notes)
    known = all({"bias", "scale_factor"} <= set(fit.names) for fit in calibration.fits)
    return (*parts, derived_table(calibration)) if known else parts


def _of_head(path: Path, run: Run, conditions: Conditions, device: str | None) -> Measured:
    from gui.dividing_head.processing import HeadResult, of_file
    from gui.dividing_head.settings import HeadSettings, settings_of_session

    if run.sensor != "accelerometer":
        return _of_gyros(path, run, conditions, device)
    settings = _settings(path, HeadSettings(), settings_of_session, conditions)
    result = of_file(path, settings, device, None, None)
    if not isinstance(result, HeadResult):
        raise _undecided(path, result)
    return measured_of(result.calibration, printed_of(result.page.parts))


def _of_gyros(path: Path, run: Run, conditions: Conditions, device: str | None) -> Measured:  # noqa: ARG001
    from gui.rate_table.processing import RateResult, of_file
    from gui.rate_table.settings import RateSettings, settings_of_session

    settings = _settings(path, RateSettings(), settings_of_session, conditions)
    result = of_file(path, device, None, None, None, settings)
    if not isinstance(result, RateResult):
        raise _undecided(path, result)
    return measured_of(result.calibration, printed_of(result.page.parts))


def _of_check(path: Path, run: Run, conditions: Conditions, device: str | None) -> Measured:  # noqa: ARG001
    from gui.accuracy.certified import measured_of_check
    from gui.accuracy.checking import CheckRequest, check_file
    from gui.accuracy.settings import AccuracySettings, settings_of_session

    settings = _settings(path, AccuracySettings(), settings_of_session, conditions)
    # Calibrations lie beside the session, each in the folder of its own.
    request = CheckRequest(settings.conditions(), settings.calibration, path.parent, settings.limit)
    return measured_of_check(check_file(path, device, request))


def _of_record(path: Path, conditions: Conditions, request: StudyRequest | None) -> Measured:
    from gui.allan.certified import measured_of_record

    return measured_of_record(path, conditions, request or StudyRequest())


def _settings(
    path: Path,
    standard: T,
    of_session: Callable[[SessionStart, T], T],
    conditions: Conditions,
) -> T:
    """The settings of a session, else the standard ones; what is stated counts before both."""
    folder = path if path.is_dir() else path.parent
    if path.is_dir() or path.name in (START_NAME, JOURNAL_NAME):
        standard = of_session(read_session(folder).start, standard)
    known = {item.name for item in fields(standard)}
    stated = {
        item.name: getattr(conditions, item.name)
        for item in fields(Conditions)
        if item.name in known and math.isfinite(getattr(conditions, item.name))
    }
    return replace(standard, **stated)


def _undecided(path: Path, result: object) -> FormatError:
    """What is to be chosen before a file can be processed."""
    if isinstance(result, Choice):
        names = ", ".join(result.devices)
        return FormatError(path, f"holds several devices: {names}; choose one of them")
    return FormatError(path, "holds nothing that a certificate can be made of")


_READERS: Mapping[str, Callable[[Path, Run, Conditions, str | None], Measured]] = {
    "dividing_head": _of_head,
    "static_positions": _of_gyros,
    "rate_table": _of_gyros,
    "accuracy": _of_check,
}
"""How the runs of each test are processed."""
