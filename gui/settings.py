"""What the program remembers from one start to the next, in one JSON file."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import cast

from core.records.atomic import make_folder, write_text_atomic

Section = Mapping[str, object]


class Settings:
    """Sections of plain values by name.

    A file that cannot be read costs the preferences, never the start: the defaults are taken, and
    `doubt` says why. A section holds only what was put there; who reads it checks it.

    Parameters
    ----------
    path : the file; need not exist
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.doubt = ""
        self._sections: dict[str, dict[str, object]] = {}
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return
        except (OSError, ValueError, RecursionError) as error:
            self.doubt = f"{path}: the preferences cannot be read ({error}); defaults are used"
            return
        if isinstance(found, dict):
            self._sections = {
                str(name): dict(cast(Section, section))
                for name, section in cast(Section, found).items()
                if isinstance(section, dict)
            }

    def section(self, name: str) -> Section:
        """Values of a section; empty if it was never stored."""
        return self._sections.get(name, {})

    def store(self, name: str, values: Section) -> None:
        """Keep values of a section; on disk after `save`."""
        self._sections[name] = dict(values)

    def save(self) -> None:
        """Write the file.

        Raises
        ------
        StorageError
            It could not be written; what stood there before is untouched.
        """
        make_folder(self.path.parent)
        text = json.dumps(self._sections, ensure_ascii=False, indent=1)
        write_text_atomic(self.path, text + "\n")


def folder_of(settings: Settings) -> Path | None:
    """The folder of all sessions that the operator chose; None where he chose none."""
    text = text_of(settings.section("laboratory"), "folder")
    return Path(text) if text else None


def number_of(section: Section, key: str, default: float, low: float, high: float) -> float:
    """A number of a section within its limits; the default where there is none such."""
    value = section.get(key)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return default
    return float(value) if low <= value <= high else default


def text_of(section: Section, key: str, default: str = "") -> str:
    """A text of a section; the default where there is none."""
    value = section.get(key)
    return value if isinstance(value, str) else default
