"""``archive.json``: the identity of a folder of sessions, and where its index stands.

Paths in the index are relative to the folder and belong to its identity, so that the folder can be
moved, and several rigs can share one database.
"""

import socket
import uuid
from dataclasses import dataclass, replace
from pathlib import Path

from core.errors import FormatError, StorageError
from core.records.atomic import write_text_atomic
from core.records.json_fields import dump, load_document
from core.records.text import decode, read_bytes

SCHEMA, VERSION = "calrig-archive", 1
NAME = "archive.json"
INDEX = "archive.db"


@dataclass(frozen=True, slots=True)
class Place:
    """A folder that is archived.

    Parameters
    ----------
    root : the folder
    id : its identity, the same wherever it is moved to
    name : of the rig, for people
    database : URL of a shared database; empty for SQLite beside the files
    stored : whether the identity stands in ``archive.json``; not so in a folder that is read-only
    """

    root: Path
    id: str
    name: str
    database: str = ""
    stored: bool = True

    @property
    def index(self) -> Path:
        """File of the index, where it stands beside the files."""
        return self.root / INDEX


def place_of(root: Path) -> Place:
    """Return the identity of a folder; one without is given one.

    Raises
    ------
    StorageError
        There is no such folder.
    FormatError
        Its ``archive.json`` is damaged or from a newer program.
    """
    if not root.is_dir():
        raise StorageError(
            f"{root}: there is no such folder; nothing is changed: connect the disk, or name the"
            " folder of your sessions"
        )
    path = root / NAME
    if path.exists():
        document = load_document(decode(read_bytes(path), path), str(path), SCHEMA, VERSION)
        names = (document.text("id"), document.text("name"), document.text("database"))
        if not names[0]:
            raise FormatError(path, "id is empty")
        return Place(root, *names)
    place = Place(root, _identity(root), socket.gethostname())
    try:
        save_place(place)
    except StorageError:
        return replace(place, stored=False)
    return place


def same_place(place: Place) -> bool:
    """Return whether the folder of an identity is still there, and still the same."""
    try:
        return place.root.is_dir() and place_of(place.root).id == place.id
    except (FormatError, StorageError):
        return False


def save_place(place: Place) -> None:
    """Write ``archive.json``.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    document = {
        "schema": SCHEMA,
        "schema_version": VERSION,
        "id": place.id,
        "name": place.name,
        "database": place.database,
    }
    write_text_atomic(place.root / NAME, dump({**document}) + "\n")


def _identity(root: Path) -> str:
    """The same for two programs that come to a new folder at once; another for every folder."""
    whole = root.resolve()
    name = f"{socket.gethostname()}:{whole}:{whole.stat().st_ino}"
    return uuid.uuid5(uuid.NAMESPACE_URL, name).hex
