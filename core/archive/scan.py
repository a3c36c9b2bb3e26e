"""Which folders of an archive have changed since the last look.

A folder's own time changes whenever a file in it is made, replaced or removed, so that ten thousand
sessions that lie still cost one look each and no reading. Folders in which something was written
shortly before are looked at again the next time: files that grow change no folder's time, and two
changes within a tick of the clock change it once.
"""

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from core.archive.place import INDEX, NAME
from core.archive.reading import CALIBRATION
from core.records.cvgcom_name import FOLDER as CVGCOM_FOLDER
from core.records.session.record import JOURNAL_NAME, START_NAME

QUIET_S = 600.0
"""Seconds after which a folder in which nothing was written lies still."""
UNSETTLED = 0
"""Time of a folder that has to be looked at again."""


@dataclass(frozen=True, slots=True)
class Item:
    """A file, or a session's folder, that can give entries.

    Parameters
    ----------
    path : below the root
    signature : sizes and times; another one after every change
    """

    path: str
    signature: str


@dataclass(frozen=True, slots=True)
class Folder:
    """A folder that is new or has changed.

    Parameters
    ----------
    path : below the root; empty for the root itself
    mtime : its time, ns; `UNSETTLED` where it must be looked at again
    items : all that it holds itself, without its subfolders
    """

    path: str
    mtime: int
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Changes:
    """What a scan found.

    Parameters
    ----------
    folders : new and changed ones
    gone : paths of folders that are no longer there
    """

    folders: tuple[Folder, ...]
    gone: tuple[str, ...]


def scan(root: Path, known: Mapping[str, int], now: float) -> Changes:
    """Compare the folders under `root` with what is known.

    Parameters
    ----------
    root : the archive's folder
    known : time of each folder at the last look, ns, by its path below the root
    now : seconds since the epoch
    """
    children: dict[str, list[str]] = {}
    for path in known:
        if path:
            children.setdefault(path.rpartition("/")[0], []).append(path)
    changed: list[Folder] = []
    seen: set[str] = set()
    todo = [""]
    base = os.fspath(root)
    while todo:
        path = todo.pop()
        whole = f"{base}/{path}" if path else base
        try:
            mtime = os.stat(whole).st_mtime_ns  # noqa: PTH116  # ten thousand times: no Path objects
        except OSError:
            continue
        seen.add(path)
        if known.get(path, UNSETTLED) == mtime:
            todo += children.get(path, ())
            continue
        folder, inside = _look(whole, path, mtime, now)
        changed.append(folder)
        todo += inside
    return Changes(tuple(changed), tuple(path for path in known if path not in seen))


def _look(whole: str, path: str, mtime: int, now: float) -> tuple[Folder, list[str]]:
    """List a folder."""
    files: dict[str, os.stat_result] = {}
    folders: list[str] = []
    try:
        with os.scandir(whole) as listing:
            for one in listing:
                if one.name.startswith(".") and one.name != CVGCOM_FOLDER:
                    continue
                below = f"{path}/{one.name}" if path else one.name
                if one.is_dir(follow_symlinks=False):
                    folders.append(below)
                elif one.is_file():
                    files[one.name] = one.stat()
    except OSError:
        return Folder(path, UNSETTLED, ()), []
    newest = max([mtime, *(stat.st_mtime_ns for stat in files.values())])
    settled = now - newest / 1e9 > QUIET_S
    return Folder(path, mtime if settled else UNSETTLED, tuple(_items(path, files))), folders


def _items(path: str, files: Mapping[str, os.stat_result]) -> Iterator[Item]:
    """A session is one item, and what stands beside it are its own copies; but calibrations."""
    if START_NAME in files:
        yield Item(path, _signature(files[n] for n in (START_NAME, JOURNAL_NAME) if n in files))
        files = {name: stat for name, stat in files.items() if name.endswith(CALIBRATION)}
    for name, stat in files.items():
        if name in (NAME, INDEX) or name.startswith(INDEX):
            continue
        yield Item(f"{path}/{name}" if path else name, _signature([stat]))


def _signature(stats: Iterable[os.stat_result]) -> str:
    return " ".join(f"{stat.st_size}:{stat.st_mtime_ns}" for stat in stats)
