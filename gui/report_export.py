"""Export of an analysis page: its tables, its numbers, its pictures."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QObject, QSize

from core.errors import LabError, Severity, StorageError
from core.records.atomic import write_text_atomic
from core.records.json_text import to_json
from core.records.names import safe_name, stamp
from gui.messages import Messages
from gui.widgets.findings_view import FindingsView
from gui.widgets.states import BannerState, TableState
from gui.widgets.table_text import table_text

if TYPE_CHECKING:
    from gui.widgets.chart_export import Paint

SOURCE = "export"
_SUFFIXES = {"csv": ".csv", "json": ".json", "svg": ".svg", "png": ".png", "pdf": ".pdf"}


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


class ReportExport(QObject):
    """Joins the export of a findings panel with the page.

    Parameters
    ----------
    report : returns what is on the page; None while there is nothing
    folder : returns the folder where files go that are named without one
    messages : where it is told
    """

    def __init__(
        self,
        report: Callable[[], Report | None],
        folder: Callable[[], Path],
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._report = report
        self._folder = folder
        self._messages = messages
        self._view: FindingsView | None = None

    def serve(self, view: FindingsView, *, pictures: bool = True) -> None:
        """Offer the formats on a panel, and write what it asks for."""
        self._view = view
        numbers = (
            ("csv", QCoreApplication.translate("ReportExport", "Tables, CSV")),
            ("json", QCoreApplication.translate("ReportExport", "Results, JSON")),
        )
        drawn = (
            ("svg", QCoreApplication.translate("ReportExport", "Picture, SVG")),
            ("png", QCoreApplication.translate("ReportExport", "Picture, PNG")),
            ("pdf", QCoreApplication.translate("ReportExport", "Picture, PDF")),
        )
        view.set_formats((*numbers, *drawn) if pictures else numbers)
        view.format_chosen.connect(self.propose)
        view.export_requested.connect(self.export)

    def propose(self, key: str = "") -> None:
        """Put a name for the chosen format into the field."""
        report = self._report()
        if self._view is not None:
            chosen = key or self._view.chosen_format
            self._view.show_name("" if report is None else str(self._path_of(report, chosen)))

    def export(self, key: str, name: str) -> None:
        """Write a format under a name; a name without a folder goes to the sessions'."""
        report = self._report()
        if report is None or not name.strip():
            return
        path = self._folder() / Path(name.strip()).expanduser()
        try:
            _write(report, key, path)
        except LabError as error:
            words = QCoreApplication.translate("ReportExport", "Not exported")
            self._messages.tell_error(SOURCE, words, error)
            return
        words = QCoreApplication.translate("ReportExport", "Exported")
        self._messages.show(SOURCE, BannerState(Severity.INFO, words, str(path)))

    def _path_of(self, report: Report, key: str) -> Path:
        return self._folder() / f"{safe_name(report.stem)}_{stamp(datetime.now())}{_SUFFIXES[key]}"


def _write(report: Report, key: str, path: Path) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{path.parent}: cannot be made ({error.strerror})") from error
    if key == "csv":
        parts = [
            "\n".join(line for line in (f"# {table.title}", table_text(table, separator=",")))
            for table in report.tables
        ]
        write_text_atomic(path, "\n".join(parts))
    elif key == "json":
        write_text_atomic(path, to_json(report.data))
    elif report.paint is not None:
        from gui.widgets.chart_export import save_chart

        save_chart(report.paint, report.size, path, report.stem)
