"""The folder of the certificates: every number is given once.

A number is taken by creating the certificate's JSON twin, which fails where the file is there
already: two programs, or two rigs on one network folder, cannot give the same number.
"""

import os
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from core.certificates.certificate import Certificate, certificate_text, parse_certificate
from core.certificates.laboratory import Laboratory
from core.errors import StorageError
from core.records.atomic import sync_folder
from core.records.names import safe_name
from core.records.text import decode, read_bytes

_MAX_BYTES = 64 * 2**20
_ATTEMPTS = 1000


class Register:
    """The certificates of a laboratory.

    Parameters
    ----------
    folder : where they lie; need not exist
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def next_number(self, laboratory: Laboratory, year: int) -> str:
        """The number that the next certificate would get.

        Raises
        ------
        FormatError
            The laboratory's pattern cannot be filled.
        """
        n = 1
        while self.path(laboratory.number_of(year, n)).exists():
            n += 1
        return laboratory.number_of(year, n)

    def issue(
        self, laboratory: Laboratory, year: int, made: Callable[[str], Certificate]
    ) -> tuple[Certificate, Path]:
        """Give the next number to a certificate and keep its twin.

        Parameters
        ----------
        laboratory : whose pattern the number follows
        year : of the date of issue
        made : returns the certificate with the number that it is given

        Returns
        -------
        certificate, path : as issued, and its JSON twin

        Raises
        ------
        StorageError
            The twin cannot be written; no number is lost.
        """
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise StorageError(f"{self.folder}: cannot be made ({error.strerror})") from error
        for _ in range(_ATTEMPTS):
            number = self.next_number(laboratory, year)
            certificate = made(number)
            path = self.path(number)
            try:
                _write_new(path, certificate_text(certificate))
            except FileExistsError:
                continue  # taken by another program since we looked
            except OSError as error:
                raise StorageError(
                    f"{path}: the certificate cannot be kept ({error.strerror})"
                ) from error
            return certificate, path
        raise StorageError(f"{self.folder}: no number is free after {_ATTEMPTS} attempts")

    def path(self, number: str) -> Path:
        """Where the twin of a certificate lies."""
        return self.folder / f"certificate_{safe_name(number)}.json"

    def read(self, path: Path) -> Certificate:
        """Read a twin.

        Raises
        ------
        FormatError
            It is none, is damaged, or from a newer program.
        """
        return parse_certificate(decode(read_bytes(path, max_bytes=_MAX_BYTES), path), str(path))


def _write_new(path: Path, text: str) -> None:
    """Write a file that must not be there yet: whole and durable, or not at all."""
    draft = path.with_name(f".{path.name}.{uuid.uuid4().hex}.tmp")
    try:
        with draft.open("xb") as file:
            _write(file, text)
        try:
            # A hard link fails where the name is taken, which a rename does not.
            path.hardlink_to(draft)
        except (PermissionError, NotImplementedError):
            # Memory sticks and some network folders know no links; a cut can leave half a file.
            with path.open("xb") as file:
                _write(file, text)
        sync_folder(path.parent)
    finally:
        draft.unlink(missing_ok=True)


def _write(file: BinaryIO, text: str) -> None:
    file.write(text.encode())
    file.flush()
    os.fsync(file.fileno())
