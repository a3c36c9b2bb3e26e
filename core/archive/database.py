"""SQLite beside the files, or PostgreSQL by URL: opened, made, migrated, set aside."""

import contextlib
import os
import shutil
import tempfile
from collections.abc import Generator
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, insert, inspect, select, text
from sqlalchemy.engine import URL, make_url
from sqlalchemy.exc import ArgumentError, DatabaseError, NoSuchModuleError, SQLAlchemyError

from core.archive.place import Place
from core.archive.tables import META, MIGRATIONS, TABLES, VERSION
from core.errors import Note, Severity, StorageError

_WAIT_S = 15.0
_PRAGMAS = (
    "journal_mode = WAL",
    "synchronous = NORMAL",
    "foreign_keys = ON",
    "cache_size = -65536",  # 64 MB: a search walks through all entries
)
_LOCK = 0x0CA1_A8C4
"""Number of the lock under which PostgreSQL's tables are made."""
_SIDE = ("", "-wal", "-shm")


@dataclass(slots=True)
class Database:
    """An open index.

    Parameters
    ----------
    engine : SQLAlchemy's
    name : where it stands, for messages; without a password
    read_only : a newer program made it: nothing is written
    notes : what happened when it was opened
    """

    engine: Engine
    name: str
    read_only: bool = False
    notes: list[Note] = field(default_factory=list[Note])
    copy: "tempfile.TemporaryDirectory[str] | None" = None

    def close(self) -> None:
        """Let go of it."""
        self.engine.dispose()
        if self.copy is not None:
            self.copy.cleanup()

    @contextlib.contextmanager
    def reading(self) -> Generator[Connection, None, None]:
        """A connection that sees one state of the index; raises `StorageError`."""
        with told(self.name), self.engine.connect() as connection, connection.begin():
            yield connection

    @contextlib.contextmanager
    def writing(self) -> Generator[Connection, None, None]:
        """A transaction: all of it or nothing; raises `StorageError`."""
        if self.read_only:
            raise StorageError(self.notes[-1].text)
        with told(self.name), self.engine.connect() as bare:
            connection = bare.execution_options(calrig_write=True)
            with connection.begin():
                yield connection


@contextlib.contextmanager
def told(name: str) -> Generator[None, None, None]:
    """Turn what a database says into words."""
    try:
        yield
    except SQLAlchemyError as error:
        raise StorageError(_words(name, error)) from error
    except UnicodeDecodeError as error:
        # SQLite quotes what it finds in a damaged file, and Python cannot read the quotation.
        damage = DatabaseError("", None, ValueError(f"malformed text: {error}"))
        raise StorageError(_words(name, damage)) from damage


def _words(name: str, error: SQLAlchemyError) -> str:
    said = " ".join(str(getattr(error, "orig", None) or error).split())
    safe = "the files of the sessions are untouched"
    if "locked" in said:
        return f"{name}: another program has been writing to it for {_WAIT_S:g} s; try again"
    if _is_damage(error):
        return f"{name}: the index is damaged ({said}); {safe}: open the archive again"
    if "readonly" in said or "read-only" in said:
        return f"{name}: cannot be written ({said}); {safe}"
    if "disk is full" in said or "No space" in said:
        return f"{name}: the disk is full; {safe}: free some space, then refresh"
    if "disk I/O" in said:
        return (
            f"{name}: the disk is full or does not answer ({said}); {safe}: free some space or"
            " connect it again, then refresh"
        )
    return f"{name}: the database of the archive refuses ({said}); {safe}"


def open_database(place: Place, url: str = "") -> Database:
    """Open the index of a folder, and make it if it is not there.

    Parameters
    ----------
    place : the folder
    url : of a shared database, instead of the one that ``archive.json`` names

    Raises
    ------
    StorageError
        It cannot be opened.
    """
    wanted = url or place.database
    if not wanted:
        return _open_file(place)
    database = _connect(_url(wanted))
    _prepare(database)
    return database


def _url(text: str) -> URL:
    try:
        url = make_url(text)
    except ArgumentError as error:
        # The text may hold a password: it is not repeated.
        raise StorageError(
            "the address of the database is none; expected"
            " postgresql://USER@HOST/DATABASE, or nothing for a file beside the sessions"
        ) from error
    if url.get_backend_name() == "postgresql":
        return url.set(drivername="postgresql+psycopg")
    if url.get_backend_name() == "sqlite":
        return url
    raise StorageError(f"{url.get_backend_name()}: the archive knows postgresql and sqlite")


def _connect(url: URL) -> Database:
    name = url.render_as_string(hide_password=True)
    if url.get_backend_name() == "sqlite":
        name = url.database or name
        engine = create_engine(url, connect_args={"timeout": _WAIT_S})
        event.listen(engine, "connect", _on_connect)
        event.listen(engine, "begin", _on_begin)
        return Database(engine, name)
    try:
        options: dict[str, Any] = {"connect_timeout": 10}
        return Database(create_engine(url, connect_args=options, pool_pre_ping=True), name)
    except (ImportError, NoSuchModuleError) as error:
        raise StorageError(
            f'{name}: needs the PostgreSQL driver: pip install "calrig[postgres]"'
        ) from error


def _on_connect(connection: Any, _: object) -> None:
    """A file that two programs may use at once, and that survives their end at any moment."""
    connection.isolation_level = None  # we say BEGIN ourselves
    cursor = connection.cursor()
    for words in _PRAGMAS:
        cursor.execute(f"PRAGMA {words}")
    cursor.close()


def _on_begin(connection: Connection) -> None:
    """A writer takes its turn at once: one that first reads could not become a writer later."""
    write = connection.get_execution_options().get("calrig_write", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if write else "BEGIN")


# ---- the file beside the sessions


def _open_file(place: Place) -> Database:
    if not _is_writable(place):
        return _open_copy(place)
    try:
        return _opened(place.index)
    except StorageError as error:
        cause = error.__cause__
        if not isinstance(cause, SQLAlchemyError) or not _is_damage(cause):
            raise
    aside = _set_aside(place.index)
    database = _opened(place.index)
    database.notes.append(
        Note(
            Severity.WARNING,
            "index_damaged",
            f"the index was damaged; it is kept as {aside.name} and a new one is made from the"
            " files, which are untouched",
        )
    )
    return database


def _opened(path: Path) -> Database:
    database = _connect(URL.create("sqlite+pysqlite", database=str(path)))
    try:
        with database.reading() as connection:
            said = connection.exec_driver_sql("PRAGMA quick_check(1)").scalar_one()
            if said != "ok":
                raise DatabaseError("quick_check", None, ValueError(f"malformed: {said}"))
        _prepare(database)
    except StorageError:
        database.close()
        raise
    return database


def _is_writable(place: Place) -> bool:
    files = [place.root, *(one for one in _files(place.index) if one.exists())]
    return place.stored and all(os.access(one, os.W_OK) for one in files)


def _open_copy(place: Place) -> Database:
    """A folder that may not be written to: a copy of its index, for as long as it is open."""
    folder = tempfile.TemporaryDirectory(prefix="calrig-archive-")
    for one in _files(place.index)[:2]:
        if one.exists():
            shutil.copyfile(one, Path(folder.name) / one.name)
    try:
        database = _opened(Path(folder.name) / place.index.name)
    except StorageError:
        (Path(folder.name) / place.index.name).unlink(missing_ok=True)
        database = _opened(Path(folder.name) / place.index.name)
    database.copy = folder
    database.notes.append(
        Note(
            Severity.INFO,
            "read_only_folder",
            f"{place.root} may not be written to: its index is kept until the program ends",
        )
    )
    return database


def _files(index: Path) -> list[Path]:
    return [index.with_name(index.name + side) for side in _SIDE]


def _set_aside(index: Path) -> Path:
    """Rename a damaged index; return its new name."""
    stamp = datetime.now(UTC).strftime("%Y%m%d-%H%M%S-%f")
    aside = index.with_name(f"{index.name}.damaged-{stamp}")
    for one, side in zip(_files(index), _SIDE, strict=True):
        if one.exists():
            try:
                one.replace(aside.with_name(aside.name + side))
            except OSError as error:
                raise StorageError(
                    f"{one}: damaged, and cannot be set aside ({error.strerror}): close other"
                    " programs that use it and try again"
                ) from error
    return aside


def _is_damage(error: SQLAlchemyError) -> bool:
    said = str(getattr(error, "orig", None) or error)
    return any(word in said for word in ("malformed", "not a database", "file is encrypted"))


# ---- the schema


def _prepare(database: Database) -> None:
    """Make the tables, or bring them up to date."""
    found = _version(database)
    if found < VERSION:
        with database.writing() as connection:
            if connection.dialect.name == "postgresql":
                connection.execute(text(f"SELECT pg_advisory_xact_lock({_LOCK})"))
            # Another program may have done it while we waited.
            _migrate(connection, _version_in(connection))
    elif found > VERSION:
        database.read_only = True
        words = (
            f"{database.name}: this archive was made by a newer CalRig (schema {found}; this"
            f" program knows {VERSION}): it is shown and not changed; update CalRig"
        )
        database.notes.append(Note(Severity.WARNING, "newer_schema", words))


def _version(database: Database) -> int:
    with database.reading() as connection:
        return _version_in(connection)


def _version_in(connection: Connection) -> int:
    if not inspect(connection).has_table(META.name):
        return 0
    return int(connection.execute(select(META.c.value).where(META.c.key == "schema")).scalar_one())


def _migrate(connection: Connection, found: int) -> None:
    if found == 0:
        TABLES.create_all(connection)
        connection.execute(insert(META), {"key": "schema", "value": str(VERSION)})
        return
    for version in range(found, VERSION):
        for statement in MIGRATIONS[version]:
            connection.execute(text(statement))
    connection.execute(META.update().where(META.c.key == "schema"), {"value": str(VERSION)})
