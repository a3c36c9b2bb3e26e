"""File and folder names made from device names and times."""

import re
import unicodedata
from datetime import datetime

NO_NAME = "No Name"
"""What the old programs show until a device has been scanned."""

MAX_LENGTH = 64

# What Windows forbids, path separators, and anything that does not print.
_FORBIDDEN = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
_RESERVED = re.compile(
    r"(?:con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])", re.IGNORECASE
)


def safe_name(device: str) -> str:
    """Return a file name part for a device name; inside files the name stays as it is.

    No path leaves the folder it is joined to, on Windows or Linux: separators and forbidden
    characters become ``_``, leading and trailing dots and blanks go, reserved device names get a
    leading ``_``, an empty name becomes ``No_Name``. Two different names may give the same part.
    """
    text = unicodedata.normalize("NFC", device)
    text = "".join("_" if unicodedata.category(c)[0] == "C" else c for c in text)
    text = re.sub(r"\s+", "_", _FORBIDDEN.sub("_", text).strip())
    text = re.sub(r"_+", "_", text).strip("._ ")[:MAX_LENGTH].rstrip("._ ")
    if not text:
        text = NO_NAME.replace(" ", "_")
    if _RESERVED.fullmatch(text.split(".", 1)[0]):
        text = "_" + text
    return text


def name_in_file(device: str) -> str:
    """Return a device name that stays on one line; an empty one becomes ``No Name``."""
    breaks = ("Cc", "Cs", "Zl", "Zp")
    text = "".join(" " if unicodedata.category(c) in breaks else c for c in device)
    return text.strip() or NO_NAME


def stamp(when: datetime) -> str:
    """``YYYYMMDDhhmm`` of the test's start, as the old programs name their files."""
    return when.strftime("%Y%m%d%H%M")


_STAMP = re.compile(r"_(\d{12})(?:_\d+)?\.\w+$")


def stamp_of(file_name: str) -> datetime | None:
    """The local time in a legacy file name, None where it holds none."""
    match = _STAMP.search(file_name)
    if match is None:
        return None
    try:
        return datetime.strptime(match[1], "%Y%m%d%H%M")
    except ValueError:
        return None
