"""File names as CVGCom makes them: ``25-143.exp(001)_s_pr1.txt`` in ``.Gyro_Data/25-143/``."""

import re
from dataclasses import dataclass
from pathlib import Path

from core.records.names import safe_name

FOLDER = ".Gyro_Data"
SUFFIX = ".txt"
_NAME = re.compile(r"(?P<device>.+)\.exp\((?P<number>\d{1,6})\)_(?P<kind>[sd])_pr(?P<profile>\d+)")


@dataclass(frozen=True, slots=True)
class CvgcomName:
    """What a file name tells.

    Parameters
    ----------
    device : serial number as it stands in file names
    experiment : number NNN
    static : ``s``, the unit at rest; else ``d``, on the moving table
    profile : number of the profile
    """

    device: str
    experiment: int
    static: bool
    profile: int

    @classmethod
    def parse(cls, text: str) -> "CvgcomName | None":
        """Read the name of a file, with any suffix; None if it is no such name."""
        match = _NAME.match(text)
        if match is None:
            return None
        return cls(
            match["device"], int(match["number"]), match["kind"] == "s", int(match["profile"])
        )

    @property
    def stem(self) -> str:
        """The name without its suffix."""
        kind = "s" if self.static else "d"
        return f"{self.device}.exp({self.experiment:03d})_{kind}_pr{self.profile}"


def folder_of(root: Path, device: str) -> Path:
    """Where the files of a device stand."""
    return root / FOLDER / safe_name(device)


def next_name(folder: Path, device: str, *, static: bool, profile: int) -> CvgcomName:
    """The name with the next free number of experiment.

    Numbers of files of every kind, profile and suffix count, so that one number is one experiment.
    """
    used = [0]
    if folder.is_dir():
        found = (CvgcomName.parse(path.name) for path in folder.iterdir())
        used += [name.experiment for name in found if name is not None]
    return CvgcomName(safe_name(device), max(used) + 1, static, profile)
