"""One format in which results of a procedure are written as a text."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from core.procedures.calibration import Provenance
from core.records.atomic import write_bytes_atomic

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class ResultFormat(Generic[T]):
    """One format.

    Parameters
    ----------
    title : for the list of formats
    suffix : end of the file's name
    text : (result, provenance, name) -> content; `name` becomes the names in C
    """

    title: str
    suffix: str
    text: Callable[[T, Provenance, str], str]

    def write(self, result: T, provenance: Provenance, path: Path) -> None:
        """Write a result; names in C are those of the file.

        Raises
        ------
        FitError
            The format cannot hold this result.
        StorageError
            The file could not be written.
        """
        write_bytes_atomic(path, self.text(result, provenance, path.stem).encode())
