"""One way in for everything that holds a run."""

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from core.errors import FormatError
from core.records.legacy.reader import read_legacy
from core.records.run_file import parse_run
from core.records.run_head import is_run_file
from core.records.session.record import JOURNAL_NAME, START_NAME, read_session
from core.records.text import decode, read_bytes
from core.samples.run import Run

_HEAD = 4096


def read_any(
    path: Path,
    *,
    sensor: str | None = None,
    device: str | None = None,
    mounts: Sequence[str] | None = None,
) -> Run:
    """Read a session's folder (or a file in it), a run file or a legacy text file.

    Parameters
    ----------
    path : recognised by what it holds, not by its name
    sensor, device, mounts : for sources that leave a choice, see `LegacyFile.to_run`

    Raises
    ------
    FormatError
        It is none of them, is damaged, or what was asked for is not in it.
    """
    if path.is_dir() or path.name in (START_NAME, JOURNAL_NAME):
        _refuse_mounts(path, mounts)
        run = read_session(path if path.is_dir() else path.parent).run(sensor)
        return _of(run, path, None, device)
    head = _head(path)
    if head.lstrip().startswith("{"):
        raise FormatError(path, "is a JSON document, no measurements")
    if is_run_file(head):
        _refuse_mounts(path, mounts)
        content = read_bytes(path)
        run = parse_run(decode(content, path), str(path))
        source = {"source": path.name, "source_sha256": hashlib.sha256(content).hexdigest()}
        return _of(replace(run, meta={**run.meta, **source}), path, sensor, device)
    return read_legacy(path).to_run(sensor=sensor, device=device, mounts=mounts)


def _head(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return file.read(_HEAD).decode("utf-8-sig", errors="replace")
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise FormatError(path, f"cannot be read: {why}") from error


def _refuse_mounts(path: Path, mounts: Sequence[str] | None) -> None:
    if mounts is not None:
        raise FormatError(path, "mounts are given, but the rows already tell them")


def _of(run: Run, path: Path, sensor: str | None, device: str | None) -> Run:
    if device is not None and device != run.device:
        raise FormatError(path, f"holds no rows of {device!r}, only of {run.device!r}")
    if sensor is not None and sensor != run.sensor:
        raise FormatError(path, f"holds outputs of the {run.sensor}, not of the {sensor}")
    return run
