"""The files of an accuracy check: verdict and tables, the old program's text, the rows."""

from datetime import datetime
from pathlib import Path

from core.records.atomic import write_bytes_atomic
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.legacy.writer import write_legacy
from core.records.names import safe_name, stamp
from core.records.run_file import write_run
from core.version import SOFTWARE
from gui.accuracy.checking import Checked
from gui.accuracy.tables import chips_of, parts_of, rule_of, title_of
from gui.accuracy.texts import say
from gui.exporting import ExportFormat
from gui.widgets.states import TableState
from gui.widgets.table_text import table_text

KEPT = "accuracy.csv"
"""Every judged session keeps its verdict under this name in its folder."""
_LEGACY = LEGACY_FORMATS["accuracy"]


def formats() -> tuple[ExportFormat, ...]:
    """Verdict and tables, the old program's text, the run file."""
    return (
        ExportFormat("csv", say("Verdict and tables, CSV"), _csv_name, write_csv),
        ExportFormat(
            "excel", say("Verdict and tables, CSV with decimal comma"), _csv_name, _write_excel
        ),
        ExportFormat("legacy", _LEGACY.title, _legacy_name, _write_legacy),
        ExportFormat("run", say("Run file of the rows"), _run_name, _write_run),
    )


def write_csv(checked: Checked, path: Path) -> None:
    """Write verdicts, rule and tables; raises `StorageError`."""
    write_bytes_atomic(path, _text(checked, ",", ".").encode())


def _write_excel(checked: Checked, path: Path) -> None:
    write_bytes_atomic(path, _text(checked, ";", ",").encode("utf-8-sig"))


def _write_legacy(checked: Checked, path: Path) -> None:
    write_legacy(checked.run, _LEGACY, path)


def _write_run(checked: Checked, path: Path) -> None:
    write_run(checked.run, path)


def _text(checked: Checked, separator: str, decimal: str) -> str:
    found = checked.found
    lines = [title_of(found), checked.source, SOFTWARE, rule_of(checked)]
    lines += [f"{chip.name}: {chip.verdict} {chip.why}" for chip in chips_of(found)]
    lines += [note.text for note in found.notes]
    head = "".join(f'"{line.replace(chr(34), chr(39))}"\n' for line in lines)
    tables = [
        f'\n"{part.title}"\n{table_text(part, separator=separator, decimal=decimal)}'
        for part in parts_of(found)
        if isinstance(part, TableState)
    ]
    return head + "".join(tables)


def _csv_name(checked: Checked) -> str:
    return f"{safe_name(checked.found.device)}_{checked.found.kind}_accuracy.csv"


def _legacy_name(checked: Checked) -> str:
    return f"{_LEGACY.stem}_{_stamp(checked)}.txt"


def _run_name(checked: Checked) -> str:
    return f"{safe_name(checked.found.device)}_{checked.found.kind}_accuracy.run.csv"


def _stamp(checked: Checked) -> str:
    """Local time of the test's start, now where that is not known."""
    meta = checked.run.meta
    told = meta.get("measured_utc") or meta.get("start_local")
    moment = datetime.fromisoformat(str(told)) if told else datetime.now()
    return stamp(moment.astimezone())
