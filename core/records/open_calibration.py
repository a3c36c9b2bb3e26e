"""Calibrations from any file that holds or gives one, and the one that belongs to a check."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from core.errors import FormatError
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import read_calibration
from core.records.open import read_any
from core.records.session.record import START_NAME
from core.samples.run import Conditions

_KEPT = "*/*.cal.json"
_EVER = datetime.min.replace(tzinfo=UTC)


def open_calibration(path: Path, conditions: Callable[[Conditions], Conditions]) -> Calibration:
    """Read a calibration, or make one of a session, run file or legacy file of positions.

    Parameters
    ----------
    path : the file, or a session's folder
    conditions : what counts for positions, by what their file states

    Raises
    ------
    FormatError, FitError
        The file is neither, or its positions give no calibration.
    """
    if path.suffix == ".json" and path.name != START_NAME:
        return read_calibration(path)
    run = read_any(path)
    return calibrate(run, conditions(run.conditions))


def nearest_calibration(root: Path, device: str, when: datetime | None) -> Path | None:
    """The calibration of a device's accelerometer triad that was measured nearest to a moment.

    Parameters
    ----------
    root : folder of all sessions; each keeps its calibration in its own folder
    device : as it calls itself
    when : moment of the check; None for the newest calibration

    Returns
    -------
    Path or None
        None where there is none. A file that cannot be read is passed over.
    """
    found: list[tuple[datetime, Path]] = []
    for path in sorted(root.glob(_KEPT)):
        try:
            calibration = read_calibration(path)
        except FormatError:
            continue
        same = calibration.provenance.device.strip() == device.strip()
        if same and calibration.sensor == "accelerometer" and calibration.is_triad:
            found.append((_moment(calibration), path))
    if not found:
        return None
    if when is None:
        return max(found)[1]
    wanted = when if when.tzinfo is not None else when.astimezone()
    return min(found, key=lambda one: abs(one[0] - wanted))[1]


def _moment(calibration: Calibration) -> datetime:
    told = calibration.provenance.measured_utc or calibration.provenance.computed_utc
    try:
        moment = datetime.fromisoformat(told)
    except ValueError:
        return _EVER
    return moment if moment.tzinfo is not None else moment.replace(tzinfo=UTC)
