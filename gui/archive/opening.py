"""In which tab an entry can be worked with; no Qt."""

from pathlib import Path

from core.archive.entry import DAMAGED, Entry
from core.errors import FormatError
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.session.record import START_NAME, read_session

TAB_OF_TEST = {
    "dividing_head": "Dividing head",
    "static_positions": "Rate table",
    "rate_table": "Rate table",
    "accuracy": "Accuracy",
}
"""Titles of the tabs that process the runs of each test."""
RECORDS = "Allan"
CERTIFICATES = "Certificates"


def opening_of(entry: Entry, path: Path) -> tuple[str, Path] | None:
    """Return the title of the tab and what it is to load; None for what is shown here only.

    A calibration is worked with through the session in whose folder it stands.
    """
    if entry.verdict == DAMAGED:
        return None
    if entry.kind == "record":
        return RECORDS, path
    folder = path.parent if entry.kind == "calibration" else path
    if entry.kind in ("session", "calibration"):
        test = _test_of(folder)
    elif entry.kind == "legacy":
        test = LEGACY_FORMATS[entry.what].test.get(entry.sensor, "")
    else:
        test = entry.what if entry.kind == "run" else ""
    title = TAB_OF_TEST.get(test, "")
    return (title, folder) if title else None


def _test_of(folder: Path) -> str:
    if not (folder / START_NAME).exists():
        return ""
    try:
        return read_session(folder).start.plan.test
    except FormatError:
        return ""
