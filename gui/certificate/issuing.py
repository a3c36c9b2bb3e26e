"""Work of the tab Certificates on files; runs in a worker thread."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path

from core.certificates.certificate import Certificate
from core.certificates.laboratory import day_of
from core.certificates.register import Issued, Register
from core.errors import LabError, StorageError
from core.records.atomic import write_text_atomic
from gui.certificate.html import certificate_sections, certificate_title, whole_html
from gui.certificate.pdf import Paper


@dataclass(frozen=True, slots=True)
class Registered:
    """The folder as it was found."""

    entries: tuple[Issued, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Opened:
    """An issued certificate."""

    certificate: Certificate
    path: Path


@dataclass(frozen=True, slots=True, eq=False)
class Done:
    """A certificate that was issued just now.

    Parameters
    ----------
    certificate : with its number
    path : the twin
    files : PDF and HTML; empty where they could not be written
    problem : why not
    """

    certificate: Certificate
    path: Path
    files: tuple[Path, ...]
    problem: str = ""


def entries_of(register: Register) -> Registered:
    """List the folder."""
    return Registered(register.entries())


def opened(register: Register, path: Path) -> Opened:
    """Read a twin; raises `FormatError`."""
    return Opened(register.read(path), path)


def issue(register: Register, draft: Certificate, results: tuple[str, ...], folder: Path) -> Done:
    """Give the number, keep the twin, write PDF and HTML.

    Parameters
    ----------
    draft : the certificate without a number
    results : its results, of `results_html`
    folder : of the laboratory's file, which a relative logo belongs to

    Raises
    ------
    StorageError, FormatError
        No number was given. Once it is, files that cannot be written are told in `Done.problem`.
    """
    made: Callable[[str], Certificate] = lambda number: replace(draft, number=number)  # noqa: E731
    certificate, path = register.issue(draft.laboratory, year_of(draft.order.issued), made)
    try:
        return Done(certificate, path, write_files(certificate, results, folder, path))
    except LabError as error:
        return Done(certificate, path, (), str(error))


def write_files(
    certificate: Certificate, results: tuple[str, ...], folder: Path, twin: Path
) -> tuple[Path, ...]:
    """Write PDF and HTML beside a twin; raises `StorageError`, also where they are there."""
    paths = files_of(twin)
    for path in paths:
        if path.exists():
            raise StorageError(f"{path}: is there, and an issued certificate is not overwritten")
    sections, title = (
        certificate_sections(certificate, results, folder),
        certificate_title(certificate),
    )
    pdf, html = paths
    Paper(sections, title).save(pdf)
    write_text_atomic(html, whole_html(sections, title))
    return paths


def files_of(twin: Path) -> tuple[Path, Path]:
    """PDF and HTML of a twin."""
    return twin.with_suffix(".pdf"), twin.with_suffix(".html")


def year_of(issued: str) -> int:
    """The year that a number counts in."""
    return (day_of(issued) or date.today()).year
