"""Files -> entries: one reader a kind, each for the files that it knows by name and content."""

import hashlib
import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from core.archive.entry import (
    DAMAGED,
    FINISHED,
    OPEN,
    Entry,
    Found,
    Quantity,
    judged,
    mean_of,
)
from core.archive.noise_file import is_noise_file, parse_noise
from core.errors import FormatError
from core.procedures.calibration import Calibration
from core.records.calibration_json import parse_calibration
from core.records.cvgcom import is_cvgcom
from core.records.cvgcom_name import CvgcomName
from core.records.legacy.file import LegacyFile
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.reader import read_legacy
from core.records.means import NAME as MEANS
from core.records.means import read_means
from core.records.names import stamp_of
from core.records.run_file import parse_run
from core.records.run_head import is_run_file
from core.records.session.record import JOURNAL_NAME, START_NAME, read_session
from core.records.text import decode, read_bytes

Reader = Callable[[Path], tuple[Found, ...]]
"""Gives what a file holds; `Entry.path` is left empty. Raises `FormatError`."""

CALIBRATION = ".cal.json"
RUN = ".run.csv"
_HEAD, _MAX_TEXT = 4096, 16 * 2**20


def read_file(path: Path, more: Mapping[str, Reader]) -> tuple[Found, ...]:
    """Return what a file holds for the archive; nothing if it is of no kind that is archived.

    A file that calls itself one of ours and is damaged gives an entry that says so.

    Parameters
    ----------
    path : the file; of a session its folder
    more : further readers by suffix

    Raises
    ------
    FormatError
        Never for content; only if the file cannot be opened.
    """
    reader = _reader(path, more)
    if reader is None:
        return ()
    kind, read, ours = reader
    try:
        found = read(path)
    except FormatError as error:
        if not ours:
            return ()
        return (Found(Entry(kind, "", path.name, verdict=DAMAGED, remark=str(error))),)
    return tuple(_dated(one, path) for one in found)


def _reader(path: Path, more: Mapping[str, Reader]) -> tuple[str, Reader, bool] | None:
    """Kind, reader, and whether the name alone says that it is ours."""
    name = path.name.lower()
    if path.is_dir():
        return "session", read_session_entry, True
    if name.endswith(CALIBRATION):
        return "calibration", read_calibration_entry, True
    if name.endswith(RUN):
        return "run", read_run_entry, True
    if path.suffix.lower() in more:
        return "record", more[path.suffix.lower()], True
    if name == MEANS:
        return "means", read_means_entry, False
    if path.suffix.lower() == ".json":
        return "calibration", read_calibration_entry, False
    if path.suffix.lower() in (".txt", ".csv", ".dat"):
        stems = tuple(f"{layout.stem.lower()}_" for layout in LEGACY_FORMATS.values())
        return "legacy", _read_text, name.startswith(stems)
    return None


def _read_text(path: Path) -> tuple[Found, ...]:
    """Text files are told apart by what they begin with."""
    if is_cvgcom(path):
        return read_cvgcom_entry(path)
    try:
        with path.open("rb") as file:
            head = file.read(_HEAD).decode("utf-8-sig", errors="replace")
    except OSError as error:
        raise FormatError(path, f"cannot be read: {error.strerror}") from error
    if path.stat().st_size > _MAX_TEXT:
        raise FormatError(path, "is too large for a table of means")
    if is_noise_file(head):
        return read_noise_entry(path)
    return read_run_entry(path) if is_run_file(head) else read_legacy_entry(path)


def _dated(found: Found, path: Path) -> Found:
    """Where a file tells no moment, its name may, and at last the file system."""
    if found.entry.measured:
        return found
    told = stamp_of(path.name)
    seconds = path.stat().st_mtime if told is None else told.astimezone().timestamp()
    return replace(found, entry=replace(found.entry, measured=_utc(seconds)))


def _utc(seconds: float) -> str:
    return datetime.fromtimestamp(seconds, UTC).isoformat(timespec="seconds")


def moment(text: str) -> str:
    """A moment with its offset as UTC to the second; empty where it is none."""
    try:
        when = datetime.fromisoformat(text)
    except ValueError:
        return ""
    return "" if when.tzinfo is None else when.astimezone(UTC).isoformat(timespec="seconds")


# ---- one a kind


def read_session_entry(folder: Path) -> tuple[Found, ...]:
    """A session's folder."""
    record = read_session(folder)
    start, positions = record.start, record.positions
    doubt, remark = judged(record.notes, "")
    content = read_bytes(folder / START_NAME) + read_bytes(folder / JOURNAL_NAME)
    entry = Entry(
        kind="session",
        path="",
        serial=start.device,
        sensor=start.sensor,
        what=start.plan.id,
        operator=start.operator,
        profile=start.profile,
        measured=moment(start.started),
        temperature_c=mean_of(position.temperature_c for position in positions),
        verdict=doubt or (FINISHED if record.is_finished else OPEN),
        count=len(positions),
        remark=remark,
        sha256=hashlib.sha256(content).hexdigest(),
    )
    return (Found(entry),)


def read_calibration_entry(path: Path) -> tuple[Found, ...]:
    """A calibration."""
    content = read_bytes(path)
    calibration = parse_calibration(decode(content, path), str(path))
    source = calibration.provenance
    fit_notes = [note for fit in calibration.fits for note in fit.notes]
    verdict, remark = judged([*calibration.notes, *fit_notes])
    entry = Entry(
        kind="calibration",
        path="",
        serial=source.device,
        sensor=calibration.sensor,
        what=source.procedure,
        operator=_operator(path.parent),
        profile=source.profile,
        measured=moment(source.measured_utc) or moment(source.computed_utc),
        temperature_c=calibration.temperature_c,
        verdict=verdict,
        count=len(calibration.fits),
        remark=remark,
        sha256=hashlib.sha256(content).hexdigest(),
    )
    return (Found(entry, quantities_of(calibration)),)


def quantities_of(calibration: Calibration) -> tuple[Quantity, ...]:
    """All parameters of all sensors."""
    return tuple(
        Quantity(channel, parameter.name, parameter.symbol, parameter.unit, value, u, dof)
        for channel, fit in zip(calibration.channels, calibration.fits, strict=True)
        for parameter, value, u, dof in zip(
            fit.parameters,
            fit.values.tolist(),
            fit.stderr.tolist(),
            fit.t_dof.tolist(),
            strict=True,
        )
    )


def _operator(folder: Path) -> str:
    """Who measured, where a calibration stands in its session's folder."""
    if not (folder / START_NAME).exists():
        return ""
    try:
        return read_session(folder).start.operator
    except FormatError:
        return ""


def read_run_entry(path: Path) -> tuple[Found, ...]:
    """A run file."""
    content = read_bytes(path)
    run = parse_run(decode(content, path), str(path))
    verdict, remark = judged(run.notes, "")
    entry = Entry(
        kind="run",
        path="",
        serial=run.device,
        sensor=run.sensor,
        what=run.test,
        operator=str(run.meta.get("operator", "")),
        profile=str(run.meta.get("profile", "")),
        measured=moment(str(run.meta.get("measured_utc", ""))),
        temperature_c=mean_of(run.temperature_c),
        verdict=verdict,
        count=len(run),
        remark=remark,
        sha256=hashlib.sha256(content).hexdigest(),
    )
    return (Found(entry),)


def read_legacy_entry(path: Path) -> tuple[Found, ...]:
    """A file of the old programs: one entry a device."""
    file = read_legacy(path)
    devices = dict.fromkeys(file.devices)
    return tuple(
        Found(
            Entry(
                kind="legacy",
                path="",
                part=device if len(devices) > 1 else "",
                serial=device,
                sensor=file.layout.sensor,
                what=file.layout.id,
                temperature_c=_temperature(file, device),
                count=file.devices.count(device),
                sha256=file.sha256,
            )
        )
        for device in devices
    )


def _temperature(file: LegacyFile, device: str) -> float:
    """Mean temperature in degrees; NaN where the file does not tell it so."""
    try:
        return mean_of(file.to_run(device=device).temperature_c)
    except FormatError:
        # Which way the unit stood is asked when it is processed, not here.
        return math.nan


def read_cvgcom_entry(path: Path) -> tuple[Found, ...]:
    """A record of CVGCom, by its name: hours of samples are not read for a list."""
    name = CvgcomName.parse(path.name)
    serial = path.stem if name is None else name.device
    what = "" if name is None else ("static" if name.static else "moving")
    return (Found(Entry("record", "", serial, sensor="gyro", what=what)),)


def read_means_entry(path: Path) -> tuple[Found, ...]:
    """Means of records: one entry a device."""
    found: dict[str, int] = {}
    for mean in read_means(path):
        name = CvgcomName.parse(mean.record)
        serial = mean.record if name is None else name.device
        found[serial] = found.get(serial, 0) + 1
    sha256 = hashlib.sha256(read_bytes(path)).hexdigest()
    return tuple(
        Found(
            Entry(
                kind="means",
                path="",
                part=serial if len(found) > 1 else "",
                serial=serial,
                count=count,
                sha256=sha256,
            )
        )
        for serial, count in found.items()
    )


def read_noise_entry(path: Path) -> tuple[Found, ...]:
    """A table of noise coefficients: one entry a device."""
    content = read_bytes(path)
    devices = parse_noise(decode(content, path), str(path))
    return tuple(
        Found(
            Entry(
                kind="noise",
                path="",
                part=device if len(devices) > 1 else "",
                serial=device,
                sensor=_sensor_of(quantities),
                what="allan",
                count=len({quantity.channel for quantity in quantities}),
                sha256=hashlib.sha256(content).hexdigest(),
            ),
            quantities,
        )
        for device, quantities in devices.items()
    )


def _sensor_of(quantities: tuple[Quantity, ...]) -> str:
    units = {quantity.unit for quantity in quantities}
    for sensor, mark in (("accelerometer", "m/s"), ("gyro", "deg")):
        if any(unit.startswith(mark) for unit in units):
            return sensor
    return ""
