"""The device file in the user's folder."""

from collections.abc import Collection
from pathlib import Path

from core.records.atomic import make_folder, write_text_atomic
from core.records.names import safe_name
from gui.frames.taught import Taught

FOLDER = "devices"


def file_of(root: Path, name: str) -> Path:
    """Return where the device file of a board stands."""
    return root / FOLDER / f"{safe_name(name).lower()}.toml"


def why_not(root: Path, name: str, packaged: Collection[str]) -> str:
    """Return why no file of this name may be written; empty if it may."""
    path = file_of(root, name)
    if path.stem in packaged and not path.exists():
        return f'There is a device file "{path.stem}" of the program: choose another name'
    return ""


def save(root: Path, taught: Taught, baud: int) -> Path:
    """Write the device file; one of the same name is replaced.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    path = file_of(root, taught.name)
    make_folder(path.parent)
    write_text_atomic(path, taught.text(baud))
    return path
