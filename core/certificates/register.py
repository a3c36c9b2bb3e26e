"""The folder of the certificates: every number is given once.

A number is taken by creating the certificate's JSON twin, which fails where the file is there
already: two programs, or two rigs on one network folder, cannot give the same number.
"""

import os
import uuid
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import BinaryIO

from core.certificates.certificate import Certificate, certificate_text, parse_certificate
from core.certificates.laboratory import Laboratory
from core.errors import FormatError, StorageError
from core.records.atomic import make_folder, sync_folder
from core.records.json_fields import dump, load_document
from core.records.names import safe_name
from core.records.text import decode, read_bytes

_MAX_BYTES = 64 * 2**20
_ATTEMPTS = 1000
_WITHDRAWAL, _WITHDRAWAL_VERSION = "calrig-withdrawal", 1
_TWIN, _ENDED = "certificate_", ".withdrawn.json"


@dataclass(frozen=True, slots=True)
class Issued:
    """A line of the register.

    Parameters
    ----------
    path : the JSON twin
    number, serial, item, customer, issued : as stated
    verdict : ``"pass"``, ``"fail"``, ``"undecided"``; empty without a statement of conformity
    replaces, replaced_by : numbers of other certificates; empty for none
    withdrawn : day and reason; empty while it holds
    damage : why it cannot be read; empty if it can
    """

    path: Path
    number: str
    serial: str = ""
    item: str = ""
    customer: str = ""
    issued: str = ""
    verdict: str = ""
    replaces: str = ""
    replaced_by: str = ""
    withdrawn: str = ""
    damage: str = ""


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
        make_folder(self.folder)
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
        return self.folder / f"{_TWIN}{safe_name(number)}.json"

    def read(self, path: Path) -> Certificate:
        """Read a twin.

        Raises
        ------
        FormatError
            It is none, is damaged, or from a newer program.
        """
        return parse_certificate(decode(read_bytes(path, max_bytes=_MAX_BYTES), path), str(path))

    def withdraw(self, number: str, day: str, reason: str) -> Path:
        """State that a certificate holds no longer; the twin stays as it is.

        Parameters
        ----------
        number : of the certificate
        day : ISO date
        reason : in words

        Raises
        ------
        StorageError
            There is no such certificate, it was withdrawn before, or nothing can be written.
        """
        twin = self.path(number)
        if not twin.exists():
            raise StorageError(f"{twin}: there is no such certificate")
        path = twin.with_suffix(_ENDED)
        text = dump(
            {
                "schema": _WITHDRAWAL,
                "schema_version": _WITHDRAWAL_VERSION,
                "number": number,
                "day": day,
                "reason": reason,
            }
        )
        try:
            _write_new(path, text + "\n")
        except FileExistsError as error:
            raise StorageError(f"{path}: the certificate was withdrawn before") from error
        except OSError as error:
            raise StorageError(f"{path}: cannot be written ({error.strerror})") from error
        return path

    def entries(self) -> tuple[Issued, ...]:
        """Every certificate of the folder, the newest number first; damaged ones say why."""
        twins = [
            path for path in self.folder.glob(f"{_TWIN}*.json") if not path.name.endswith(_ENDED)
        ]
        found = [self._entry(path) for path in twins]
        after = {one.replaces: one.number for one in found if one.replaces}
        lines = [replace(one, replaced_by=after.get(one.number, "")) for one in found]
        return tuple(sorted(lines, key=lambda one: (one.issued, one.number), reverse=True))

    def _entry(self, path: Path) -> Issued:
        try:
            certificate = self.read(path)
            withdrawn = _withdrawal(path.with_suffix(_ENDED))
        except FormatError as error:
            return Issued(path, path.stem.removeprefix(_TWIN), damage=str(error))
        order, conformity = certificate.order, certificate.conformity
        return Issued(
            path,
            certificate.number,
            order.serial,
            " ".join(filter(None, (order.item, order.model))),
            order.customer,
            order.issued,
            "" if conformity is None else conformity.verdict.value,
            order.replaces,
            withdrawn=withdrawn,
        )


def _withdrawal(path: Path) -> str:
    """Day and reason of a withdrawal; empty where there is none."""
    if not path.exists():
        return ""
    text = decode(read_bytes(path, max_bytes=_MAX_BYTES), path)
    found = load_document(text, path, _WITHDRAWAL, _WITHDRAWAL_VERSION)
    return f"{found.text('day')}: {found.text('reason')}"


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
