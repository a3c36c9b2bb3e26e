"""The archive of a folder of sessions: opened, kept up to date, asked."""

import contextlib
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from itertools import groupby
from pathlib import Path

from sqlalchemy import Connection, delete, insert, select, tuple_, update
from sqlalchemy.exc import IntegrityError

from core.archive import search
from core.archive.database import Database, open_database
from core.archive.entry import DAMAGED, Entry, Found, Quantity
from core.archive.place import Place, place_of
from core.archive.reading import Reader, read_file
from core.archive.scan import Changes, Folder, scan
from core.archive.search import Hits, Reading, Wanted
from core.archive.tables import ENTRIES, FOLDERS, PLACES
from core.errors import FormatError, Note, StorageError

Progress = Callable[[int, int], None]
"""Told how many folders of how many are done; may raise to break off."""

_BATCH = 200


@dataclass(frozen=True, slots=True)
class Refreshed:
    """What a look at the folders has changed.

    Parameters
    ----------
    taken, removed : entries put in (also anew), and taken out
    damaged : files that call themselves ours and cannot be read, with the reason
    """

    taken: int = 0
    removed: int = 0
    damaged: tuple[Entry, ...] = ()


class Archive:
    """An open archive; one thread at a time.

    Parameters
    ----------
    root : folder of the sessions
    url : of a shared database, instead of the one that ``archive.json`` names
    more : readers of further suffixes, for what `core` cannot read

    Raises
    ------
    StorageError
        The folder is not there, or its index cannot be opened.
    FormatError
        ``archive.json`` is damaged.
    """

    def __init__(self, root: Path, url: str = "", more: Mapping[str, Reader] | None = None) -> None:
        self.place: Place = place_of(root)
        self.more: Mapping[str, Reader] = more or {}
        self._database: Database = open_database(self.place, url)

    def __enter__(self) -> "Archive":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def notes(self) -> tuple[Note, ...]:
        """What happened when it was opened."""
        return tuple(self._database.notes)

    @property
    def read_only(self) -> bool:
        """A newer program made the index: it is shown, not changed."""
        return self._database.read_only

    @property
    def name(self) -> str:
        """Where the index stands."""
        return self._database.name

    def close(self) -> None:
        """Let go of the index; may be called again."""
        self._database.close()

    # ---- keeping up to date

    def refresh(self, progress: Progress | None = None) -> Refreshed:
        """Take in what has changed in the folders since the last look.

        An interruption loses nothing: what was taken in stays, the rest is found the next time.

        Raises
        ------
        StorageError
            The index cannot be written; or the folder is not there any more, or another one stands
            there now: then nothing is forgotten.
        """
        if self.read_only:
            return Refreshed()
        if self.place.stored and place_of(self.place.root).id != self.place.id:
            raise StorageError(
                f"{self.place.root}: another archive stands there now; nothing is changed: open the"
                " archive anew"
            )
        changes = self._changes()
        taken = 0
        removed = self._forget(changes.gone)
        damaged: list[Entry] = []
        for done, batch in enumerate(_batches(changes.folders)):
            found, lost = self._read(batch)
            damaged += [one.entry for _, _, one in found if one.entry.verdict == DAMAGED]
            self._store(batch, found, lost)
            taken += len(found)
            removed += len(lost)
            if progress is not None:
                progress(min((done + 1) * _BATCH, len(changes.folders)), len(changes.folders))
        return Refreshed(taken, removed, tuple(damaged))

    def rebuild(self, progress: Progress | None = None) -> Refreshed:
        """Forget everything of this folder and read all files anew."""
        with self._writing() as connection:
            connection.execute(delete(ENTRIES).where(ENTRIES.c.place == self.place.id))
            connection.execute(delete(FOLDERS).where(FOLDERS.c.place == self.place.id))
        return self.refresh(progress)

    def _changes(self) -> Changes:
        with self._database.reading() as connection:
            rows = connection.execute(
                select(FOLDERS.c.path, FOLDERS.c.mtime).where(FOLDERS.c.place == self.place.id)
            )
            known = {str(row.path): int(row.mtime) for row in rows}
        return scan(self.place.root, known, time.time())

    def _read(
        self, folders: Sequence[Folder]
    ) -> tuple[list[tuple[str, str, Found]], list[tuple[str, str]]]:
        """Read what is new in folders: what was found, and (folder, path) of what is no more."""
        stored = self._signatures(folders)
        found: list[tuple[str, str, Found]] = []
        lost: list[tuple[str, str]] = []
        for folder in folders:
            before = stored.get(folder.path, {})
            items = {item.path: item for item in folder.items}
            lost += [(folder.path, path) for path in before if path not in items]
            for item in folder.items:
                if before.get(item.path) == item.signature:
                    continue
                found += [
                    (folder.path, item.signature, replace(one, entry=entry))
                    for one in self._found(item.path)
                    for entry in [replace(one.entry, path=item.path)]
                ]
                if item.path in before:
                    lost.append((folder.path, item.path))
        return found, lost

    def _found(self, path: str) -> tuple[Found, ...]:
        try:
            return read_file(self.place.root / path, self.more)
        except (FormatError, OSError):
            # It went away or may not be read; the next look tells.
            return ()

    def _signatures(self, folders: Sequence[Folder]) -> dict[str, dict[str, str]]:
        """Signatures of the stored entries by folder and path."""
        columns = (ENTRIES.c.folder, ENTRIES.c.path, ENTRIES.c.signature)
        paths = [folder.path for folder in folders]
        query = (
            select(*columns)
            .where(ENTRIES.c.place == self.place.id, ENTRIES.c.folder.in_(paths))
            .order_by(ENTRIES.c.folder)
        )
        with self._database.reading() as connection:
            rows = connection.execute(query).all()
        return {
            folder: {path: signature for _, path, signature in group}
            for folder, group in groupby(rows, key=lambda row: str(row[0]))
        }

    def _store(
        self,
        folders: Sequence[Folder],
        found: list[tuple[str, str, Found]],
        lost: list[tuple[str, str]],
    ) -> None:
        """Put a batch in as a whole; what another program took in meanwhile is replaced."""
        paths = {path for _, path in lost} | {one.entry.path for _, _, one in found}
        mine = ENTRIES.c.place == self.place.id
        with self._writing() as connection:
            if paths:
                connection.execute(delete(ENTRIES).where(mine, ENTRIES.c.path.in_(paths)))
            search.store(connection, self.place.id, found)
            self._note_times(connection, folders)

    def _note_times(self, connection: Connection, folders: Sequence[Folder]) -> None:
        keys = [(self.place.id, folder.path) for folder in folders]
        known = tuple_(FOLDERS.c.place, FOLDERS.c.path)
        connection.execute(delete(FOLDERS).where(known.in_(keys)))
        connection.execute(
            insert(FOLDERS),
            [
                {"place": self.place.id, "path": folder.path, "mtime": folder.mtime}
                for folder in folders
            ],
        )

    def _forget(self, gone: Sequence[str]) -> int:
        """Take out what stood in folders that are no longer there."""
        removed = 0
        for at in range(0, len(gone), _BATCH):
            paths = gone[at : at + _BATCH]
            with self._writing() as connection:
                for table in (ENTRIES, FOLDERS):
                    column = ENTRIES.c.folder if table is ENTRIES else FOLDERS.c.path
                    done = connection.execute(
                        delete(table).where(table.c.place == self.place.id, column.in_(paths))
                    )
                    removed += done.rowcount if table is ENTRIES else 0
        return removed

    @contextlib.contextmanager
    def _writing(self) -> Generator[Connection, None, None]:
        """A transaction that waits until no other program writes about the same folder."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        told = {"name": self.place.name, "path": str(self.place.root), "seen": now}
        mine = update(PLACES).where(PLACES.c.id == self.place.id).values(**told)
        with self._database.writing() as connection:
            if connection.execute(mine).rowcount == 0:
                try:
                    with connection.begin_nested():
                        connection.execute(insert(PLACES), {"id": self.place.id, **told})
                except IntegrityError:  # the other program's row has just come
                    connection.execute(mine)
            yield connection

    # ---- asking

    def search(
        self, text: str = "", kinds: Sequence[str] = (), serial: str = "", limit: int = 500
    ) -> Hits:
        """Find entries, the latest first.

        Parameters
        ----------
        text : words that must all stand somewhere in an entry; case makes no difference
        kinds : of these kinds only
        serial : of this device exactly
        limit : no more than these
        """
        with self._database.reading() as connection:
            return search.search(connection, Wanted(text, tuple(kinds), serial), limit)

    def entry(self, number: int) -> Entry:
        """Return an entry by its number.

        Raises
        ------
        StorageError
            There is none.
        """
        with self._database.reading() as connection:
            found = search.entry_by_id(connection, number)
        if found is None:
            raise StorageError(f"the archive holds nothing of the number {number}: list it anew")
        return found

    def quantities(self, entry: Entry) -> tuple[Quantity, ...]:
        """Return the parameters of a calibration, or the coefficients of a noise analysis."""
        with self._database.reading() as connection:
            return search.quantities_of(connection, entry.id)

    def readings(
        self, serial: str, name: str, channel: str, sensor: str = ""
    ) -> tuple[Reading, ...]:
        """Return every value of a parameter of a device, the earliest first."""
        with self._database.reading() as connection:
            return search.readings(connection, serial, name, channel, sensor)

    def known(self, sha256: str) -> bool:
        """Whether a file of this content is in the archive."""
        query = select(ENTRIES.c.id).where(ENTRIES.c.sha256 == sha256).limit(1)
        with self._database.reading() as connection:
            return connection.execute(query).first() is not None

    def path_of(self, entry: Entry) -> Path:
        """Return where the file of an entry stands.

        Raises
        ------
        StorageError
            It stands at another rig, or is no longer there.
        """
        if entry.place != self.place.id:
            with self._database.reading() as connection:
                query = select(PLACES.c.name, PLACES.c.path).where(PLACES.c.id == entry.place)
                name, path = connection.execute(query).one()
            raise StorageError(f"{entry.path} stands at the rig {name}, in its folder {path}")
        path = self.place.root / entry.path
        if not path.exists():
            raise StorageError(f"{path}: is no longer there; refresh the archive")
        return path


def _batches(folders: Sequence[Folder]) -> Iterator[Sequence[Folder]]:
    for at in range(0, len(folders), _BATCH):
        yield folders[at : at + _BATCH]
