"""The tables of the right-hand side as files."""

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from core.records.atomic import make_folder, write_text_atomic
from core.records.names import safe_name
from gui.exporting import ExportFormat
from gui.widgets.states import FindingsState
from gui.widgets.table_text import table_text


def formats() -> tuple[ExportFormat, ...]:
    """The formats of what is shown."""
    point = QCoreApplication.translate("Archive", "Tables, CSV (1.5, …)")
    comma = QCoreApplication.translate("Archive", "Tables, CSV (1,5; …)")
    return (_format("csv", point, ",", "."), _format("csv_comma", comma, ";", ","))


def _format(key: str, title: str, separator: str, decimal: str) -> ExportFormat:
    def write(findings: FindingsState, path: Path) -> None:
        make_folder(path.parent)
        write_text_atomic(path, text_of(findings, separator, decimal), encoding="utf-8-sig")

    return ExportFormat(key, title, _name, write, at_once=True)


def _name(findings: FindingsState) -> str:
    title = findings.title.replace(" → ", "_")
    return f"{safe_name(title)}_{datetime.now():%Y%m%d%H%M}.csv"


def text_of(findings: FindingsState, separator: str, decimal: str) -> str:
    """All tables, each under its title."""
    parts = [findings.title, *findings.source.splitlines()]
    for table in findings.tables:
        parts += ["", table.title, table_text(table, separator=separator, decimal=decimal).rstrip()]
    return "\n".join(parts) + "\n"
