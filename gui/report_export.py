"""Export of an analysis page: its tables, its numbers, its pictures."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QSize

from core.records.atomic import make_folder, write_text_atomic
from core.records.json_text import to_json
from core.records.names import safe_name, stamp
from gui.exporting import ExportFormat, pictures
from gui.widgets.states import TableState
from gui.widgets.table_text import table_text

if TYPE_CHECKING:
    from gui.widgets.chart_export import Paint


@dataclass(frozen=True, slots=True, eq=False)
class Report:
    """What can be exported.

    Parameters
    ----------
    stem : begin of the file name, e.g. method and device
    tables : as they stand on the page
    data : the results themselves, for JSON
    paint, size : the picture; None where the page has none
    """

    stem: str
    tables: tuple[TableState, ...]
    data: Mapping[str, object]
    paint: "Paint | None" = None
    size: QSize = field(default_factory=QSize)


def report_formats(*, drawn: bool = True) -> tuple[ExportFormat, ...]:
    """The formats of a `Report`.

    Parameters
    ----------
    drawn : the page has a picture
    """
    tables = QCoreApplication.translate("ReportExport", "Tables, CSV")
    results = QCoreApplication.translate("ReportExport", "Results, JSON")
    picture = QCoreApplication.translate("ReportExport", "Picture, {suffix}")
    return (
        ExportFormat("csv", tables, lambda one: f"{_stem(one)}.csv", _write_tables, at_once=True),
        ExportFormat("json", results, lambda one: f"{_stem(one)}.json", _write_data, at_once=True),
        *(pictures(picture, _stem, _draw) if drawn else ()),
    )


def _stem(report: Report) -> str:
    return f"{safe_name(report.stem)}_{stamp(datetime.now())}"


def _write_tables(report: Report, path: Path) -> None:
    make_folder(path.parent)
    parts = [
        "\n".join(line for line in (f"# {table.title}", table_text(table, separator=",")))
        for table in report.tables
    ]
    write_text_atomic(path, "\n".join(parts))


def _write_data(report: Report, path: Path) -> None:
    make_folder(path.parent)
    write_text_atomic(path, to_json(report.data))


def _draw(report: Report, path: Path) -> None:
    if report.paint is not None:
        from gui.widgets.chart_export import save_chart

        save_chart(report.paint, report.size, path, report.stem)
