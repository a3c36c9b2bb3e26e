"""Folders of old files copied into the archive, each once.

Copies stand in ``imported/DEVICE/`` below the archive's folder under their old names and times, so
that the index can be rebuilt from them. Nothing in the folder that is imported is changed.
"""

import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from core.archive.entry import DAMAGED, Entry
from core.archive.reading import read_file
from core.errors import FormatError, StorageError
from core.records.atomic import not_stored, sync_folder
from core.records.cvgcom_name import FOLDER as CVGCOM_FOLDER
from core.records.names import safe_name
from core.records.session.record import START_NAME

if TYPE_CHECKING:
    from core.archive.store import Archive, Progress

FOLDER = "imported"
TAKEN, KNOWN, UNKNOWN, DAMAGED_FILE = "taken", "already there", "not known", "damaged"


@dataclass(frozen=True, slots=True)
class FileReport:
    """What became of one file, or one session's folder.

    Parameters
    ----------
    path : where it was found
    outcome : ``"taken"``, ``"already there"``, ``"not known"`` or ``"damaged"``
    what : kind and devices; of a damaged one the reason
    copy : where it stands in the archive; None if it was not taken
    """

    path: Path
    outcome: str
    what: str
    copy: Path | None = None


def import_folder(
    archive: "Archive", folder: Path, progress: "Progress | None" = None
) -> tuple[FileReport, ...]:
    """Copy what is known in a folder and its subfolders into the archive, and index it.

    Parameters
    ----------
    archive : where to
    folder : where from; only read
    progress : told how many of how many files are done

    Raises
    ------
    StorageError
        The folder is not there or lies in the archive, or a copy cannot be written; what was taken
        before stays, and the same import goes on where it was broken off.
    """
    root = archive.place.root.resolve()
    if not folder.is_dir():
        raise StorageError(f"{folder}: there is no such folder")
    if folder.resolve().is_relative_to(root):
        raise StorageError(f"{folder}: lies in the archive itself; what is in it is found there")
    if root.is_relative_to(folder.resolve()):
        raise StorageError(f"{folder}: holds the archive itself: name the folders beside it")
    archive.refresh()
    sources = list(_sources(folder))
    taken: set[str] = set()
    reports: list[FileReport] = []
    for done, source in enumerate(sources, 1):
        reports.append(_import(archive, source, taken))
        if progress is not None:
            progress(done, len(sources))
    archive.refresh()
    return tuple(reports)


def _sources(folder: Path) -> Iterator[Path]:
    """Files and sessions' folders, in the order of their names."""
    for base, folders, files in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") or name == CVGCOM_FOLDER
        )
        if START_NAME in files:
            folders.clear()
            yield Path(base)
        else:
            yield from (Path(base) / name for name in sorted(files) if name[0] != ".")


def _import(archive: "Archive", source: Path, taken: set[str]) -> FileReport:
    try:
        found = read_file(source, archive.more)
    except (FormatError, OSError) as error:
        return FileReport(source, DAMAGED_FILE, str(error))
    entries = [one.entry for one in found]
    if not entries:
        return FileReport(source, UNKNOWN, "no kind of file that is archived")
    if entries[0].verdict == DAMAGED:
        return FileReport(source, DAMAGED_FILE, entries[0].remark)
    sha256, what = entries[0].sha256, _what(entries)
    if sha256 and (sha256 in taken or archive.known(sha256)):
        return FileReport(source, KNOWN, what)
    copy, new = _copy(source, archive.place.root / FOLDER / safe_name(entries[0].serial))
    taken.add(sha256)
    return FileReport(source, TAKEN if new else KNOWN, what, copy)


def _what(entries: list[Entry]) -> str:
    return f"{entries[0].kind} of {', '.join(dict.fromkeys(one.serial for one in entries))}"


def _copy(source: Path, folder: Path) -> tuple[Path, bool]:
    """Copy under the old name; return where to, and whether it is new there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for count in range(1, 1000):
            target = _numbered(folder / source.name, count)
            if not target.exists():
                draft = target.with_name(f".{target.name}.{os.getpid()}.tmp")
                if source.is_dir():
                    shutil.rmtree(draft, ignore_errors=True)
                    shutil.copytree(source, draft)
                else:
                    shutil.copy2(source, draft)
                _sync(draft)
                draft.rename(target)
                sync_folder(folder)
                return target, True
            if source.is_file() and _same(source, target):
                return target, False
    except OSError as error:
        raise not_stored(folder, error, "what was imported before stays") from error
    raise StorageError(f"{folder}: a thousand files of the name {source.name}")


def _sync(copy: Path) -> None:
    """Wait until a copy is on the disk: whoever reads "taken" may delete what was copied."""
    if os.name == "nt":  # Windows syncs only what may be written to, which a copy may not be
        return
    for path in [copy, *copy.rglob("*")] if copy.is_dir() else [copy]:
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _numbered(path: Path, count: int) -> Path:
    if count == 1:
        return path
    stem, dot, rest = path.name.partition(".")
    return path.with_name(f"{stem}_{count}{dot}{rest}")


def _same(one: Path, other: Path) -> bool:
    """Whether two files too large to be hashed are the same: by size and by their bytes."""
    if one.stat().st_size != other.stat().st_size:
        return False
    with one.open("rb") as first, other.open("rb") as second:
        while block := first.read(1 << 20):
            if block != second.read(1 << 20):
                return False
    return True
