"""The laboratory: what does not change from one certificate to the next."""

from dataclasses import dataclass, fields
from datetime import date
from pathlib import Path

from core.errors import FormatError, Note, Severity
from core.records.atomic import write_text_atomic
from core.records.json_fields import Fields, Json, dump, load_document
from core.records.text import decode, read_bytes

SCHEMA, VERSION = "calrig-laboratory", 1
FILE = "laboratory.json"
_MAX_BYTES = 2**20


@dataclass(frozen=True, slots=True)
class Standard:
    """A measurement standard and its traceability (ISO/IEC 17025, 7.8.4.1 c).

    Parameters
    ----------
    name : what it is, e.g. ``"optical dividing head ODGE-5"``
    serial : its serial number
    certificate : number of its own certificate
    valid_until : ISO date; empty where it has none
    traceable_to : laboratory or national institute
    """

    name: str
    serial: str = ""
    certificate: str = ""
    valid_until: str = ""
    traceable_to: str = ""


@dataclass(frozen=True, slots=True)
class Laboratory:
    """Who issues certificates.

    Parameters
    ----------
    name, address : of the laboratory
    place : where it calibrates, if elsewhere
    accreditation : number and body; empty for none
    logo : picture file, relative to the laboratory's file or absolute; empty for none
    authorised_by, position : who signs
    number : pattern of the certificates' numbers with ``{year}`` and ``{n}``
    statement : further text of the laboratory's own, at the end
    standards : what it measures with
    """

    name: str = ""
    address: str = ""
    place: str = ""
    accreditation: str = ""
    logo: str = ""
    authorised_by: str = ""
    position: str = ""
    number: str = "{year}-{n:04d}"
    statement: str = ""
    standards: tuple[Standard, ...] = ()

    def missing(self) -> tuple[str, ...]:
        """What ISO/IEC 17025, 7.8.2 and 7.8.4, asks for and is not stated, in words."""
        asked = {
            "name of the laboratory": self.name,
            "address of the laboratory": self.address,
            "person who authorises": self.authorised_by,
            "standards and their traceability": self.standards,
        }
        return tuple(words for words, value in asked.items() if not value)

    def number_of(self, year: int, n: int) -> str:
        """Number of the n-th certificate of a year.

        Raises
        ------
        FormatError
            The pattern cannot be filled, or gives the same number twice.
        """
        try:
            number = self.number.format(year=year, n=n)
            other = self.number.format(year=year, n=n + 1)
        except (KeyError, IndexError, ValueError) as error:
            raise FormatError(FILE, f"the pattern {self.number!r} cannot be filled") from error
        if number == other:
            raise FormatError(FILE, f"the pattern {self.number!r} has no {{n}}")
        return number


def day_of(text: str) -> date | None:
    """The day of an ISO date; None where the text is none."""
    try:
        return date.fromisoformat(text.strip())
    except ValueError:
        return None


def standard_doubts(laboratory: Laboratory, when: str) -> tuple[Note, ...]:
    """Standards whose certificates were not valid on a day, or are not told to be.

    Parameters
    ----------
    when : ISO date of the calibration; nothing is judged where it is none
    """
    day = day_of(when)
    notes: list[Note] = []
    for standard in laboratory.standards:
        until = day_of(standard.valid_until)
        if standard.valid_until and until is None:
            words = f'{standard.name}: "{standard.valid_until}" is no date; write it as 2026-03-31'
        elif until is not None and day is not None and until < day:
            words = f"{standard.name}: its certificate was valid until {until}, not on {day}"
        elif not standard.certificate:
            words = f"{standard.name}: no certificate is named, so that nothing can be traced"
        else:
            continue
        notes.append(Note(Severity.WARNING, "standard", words))
    return tuple(notes)


TEXTS = tuple(item.name for item in fields(Laboratory) if item.name != "standards")
OF_STANDARD = tuple(item.name for item in fields(Standard))


def laboratory_to_json(laboratory: Laboratory) -> dict[str, Json]:
    """The laboratory as a JSON object."""
    return {
        **{name: getattr(laboratory, name) for name in TEXTS},
        "standards": [
            {name: getattr(standard, name) for name in OF_STANDARD}
            for standard in laboratory.standards
        ],
    }


def laboratory_of_json(found: Fields) -> Laboratory:
    """The laboratory of a JSON object.

    Raises
    ------
    FormatError
        Members are missing or no texts; all of them are told at once.
    """
    standards = found.objects("standards") if "standards" in found.data else []
    parts = ((found, TEXTS), *((one, OF_STANDARD) for one in standards))
    missing = [f"{one.where}.{name}".lstrip(".") for one, names in parts for name in names
               if name not in one.data]  # fmt: skip
    missing += [] if "standards" in found.data else ["standards"]
    wrong = [one.wrong(name, "a text", one.data[name]).why for one, names in parts for name in names
             if not isinstance(one.data.get(name, ""), str)]  # fmt: skip
    if missing:
        words = ", ".join(missing)
        wrong.insert(0, f"not stated: {words}; what does not apply stays an empty text")
    if wrong:
        raise FormatError(found.path, "; ".join(wrong))
    return Laboratory(
        **{name: found.text(name) for name in TEXTS},
        standards=tuple(
            Standard(**{name: one.text(name) for name in OF_STANDARD}) for one in standards
        ),
    )


def write_laboratory(laboratory: Laboratory, path: Path) -> None:
    """Write the laboratory's file.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    document: dict[str, Json] = {"schema": SCHEMA, "schema_version": VERSION}
    write_text_atomic(path, dump({**document, **laboratory_to_json(laboratory)}) + "\n")


def read_laboratory(path: Path) -> Laboratory:
    """Read the laboratory's file; a laboratory without a word where there is none.

    Raises
    ------
    FormatError
        The file is another one, damaged, or from a newer program.
    """
    if not path.exists():
        return Laboratory()
    text = decode(read_bytes(path, max_bytes=_MAX_BYTES), path)
    return laboratory_of_json(load_document(text, path, SCHEMA, VERSION))
