"""``laboratory.toml``: the laboratory as a text file written by hand, and its template.

The window keeps its own ``laboratory.json``; who works without it fills in the template that
``calrig certificate --template laboratory.toml`` writes. What does not apply may be left out.
"""

import tomllib
from dataclasses import fields
from datetime import date
from pathlib import Path
from typing import cast

from core.certificates.laboratory import (
    OF_STANDARD,
    TEXTS,
    Laboratory,
    laboratory_of_json,
    read_laboratory,
)
from core.errors import FormatError, StorageError
from core.records.atomic import write_text_atomic
from core.records.json_fields import Fields, Json
from core.records.text import decode, read_bytes

SUFFIX = ".toml"
_EMPTY = Laboratory()
TEMPLATE = """\
# The laboratory, for certificates made by "calrig certificate --laboratory laboratory.toml".
# Fill in what applies; what does not may stay empty or be left out. Texts stand in quotes.

# Asked for by ISO/IEC 17025:2017, 7.8.2:
name = ""                       # e.g. "Laboratory of inertial sensors"
address = ""                    # e.g. "1 Example Street, Kyiv"
authorised_by = ""              # who signs, e.g. "O. Petrenko"
position = ""                   # e.g. "head of the laboratory"

place = ""                      # where it calibrates, if elsewhere
accreditation = ""              # number and body; empty for none
logo = ""                       # a picture, PNG or SVG, named from the folder of this file
number = "{year}-{n:04d}"       # of the certificates; {n} counts within the year
statement = ""                  # further text, printed at the end

# The standards, with their traceability (7.8.4.1 c): one block each, as many as there are.
# Take the # away and fill in:
#
# [[standards]]
# name = "optical dividing head"
# serial = "114"
# certificate = "UA/24/0118"          # number of the certificate of the standard
# valid_until = "2027-03-01"          # empty where it has no date
# traceable_to = "national institute"
"""


def write_template(path: Path) -> None:
    """Write a commented file to be filled in; a file that is there already is left alone.

    Raises
    ------
    FormatError
        The name does not end with ``.toml``, by which it is read again.
    StorageError
        There is such a file, or it cannot be written.
    """
    if path.suffix.lower() != SUFFIX:
        raise FormatError(path, f"the template is a TOML file: name it {path.stem}{SUFFIX}")
    if path.exists():
        raise StorageError(f"{path}: is there already, and is not written over; name another file")
    write_text_atomic(path, TEMPLATE)


def open_laboratory(path: Path) -> Laboratory:
    """Read the laboratory's file: JSON as the window keeps it, or TOML as written by hand.

    Raises
    ------
    FormatError
        The file is not there, is another one, or damaged; everything that is wrong is told at once.
    """
    if not path.exists():
        raise FormatError(
            path,
            "is not there; the window keeps it beside the sessions, and"
            " calrig certificate --template laboratory.toml writes one to be filled in",
        )
    return _of_toml(path) if path.suffix.lower() == SUFFIX else read_laboratory(path)


def _of_toml(path: Path) -> Laboratory:
    try:
        document = tomllib.loads(decode(read_bytes(path), path))
    except tomllib.TOMLDecodeError as error:
        raise FormatError(path, f"is no TOML: {error}") from error
    top = Fields(str(path), "", cast("dict[str, Json]", document))
    standards = top.objects("standards") if "standards" in top.data else []
    _only_known(path, top, standards)
    top.data.setdefault("standards", [])
    for name in TEXTS:
        top.data.setdefault(name, getattr(_EMPTY, name))
    for one in standards:
        for name in OF_STANDARD[1:]:
            one.data.setdefault(name, "")
        until = one.data["valid_until"]
        # TOML has dates of its own; both ways of writing one mean the same.
        if isinstance(until, date):
            one.data["valid_until"] = until.isoformat()
    return laboratory_of_json(top)


def _only_known(path: Path, top: Fields, standards: list[Fields]) -> None:
    known = {item.name for item in fields(Laboratory)}
    unknown = [key for key in top.data if key not in known]
    for one in standards:
        unknown += [f"{one.where}.{key}" for key in one.data if key not in OF_STANDARD]
    if unknown:
        raise FormatError(
            path,
            f"not known: {', '.join(unknown)}; known are {', '.join(TEXTS)}, and of [[standards]]"
            f" {', '.join(OF_STANDARD)}",
        )
