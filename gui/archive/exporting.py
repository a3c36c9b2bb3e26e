"""The tables of the right-hand side as a file."""

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from core.errors import LabError, Severity
from core.records.atomic import write_text_atomic
from core.records.names import safe_name
from gui.archive.presenter import SOURCE, ArchivePresenter
from gui.messages import Messages
from gui.widgets.states import BannerState, FindingsState
from gui.widgets.table_text import table_text

_SEPARATORS = {"csv": (",", "."), "csv_comma": (";", ",")}


class Exporting(QObject):
    """Writes what is shown.

    Parameters
    ----------
    presenter : whose findings are written
    root : folder that a bare name is put into
    messages : where the outcome is told
    """

    def __init__(
        self,
        presenter: ArchivePresenter,
        root: Callable[[], Path],
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._presenter, self._root, self._messages = presenter, root, messages

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return (
            ("csv", QCoreApplication.translate("Archive", "Tables, CSV (1.5, …)")),
            ("csv_comma", QCoreApplication.translate("Archive", "Tables, CSV (1,5; …)")),
        )

    def propose(self) -> str:
        """A file name for what is shown."""
        findings = self._presenter.state.findings
        title = "archive" if findings is None else findings.title.replace(" → ", "_")
        return f"{safe_name(title)}_{datetime.now():%Y%m%d%H%M}.csv"

    def export(self, key: str, name: str) -> None:
        """Write the tables under a name."""
        findings = self._presenter.state.findings
        if findings is None or not name.strip():
            return
        path = self._root() / "exports" / name.strip()
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_text_atomic(path, text_of(findings, *_SEPARATORS[key]), encoding="utf-8-sig")
        except (LabError, OSError) as error:
            self._messages.show(
                SOURCE,
                BannerState(
                    Severity.ERROR,
                    QCoreApplication.translate("Archive", "The file cannot be written"),
                    str(error),
                    QCoreApplication.translate(
                        "Archive", "Close it where it is open, or choose another folder."
                    ),
                ),
            )
            return
        done = QCoreApplication.translate("Archive", "Written: {path}").format(path=path)
        self._messages.show(SOURCE, BannerState(Severity.INFO, done))


def text_of(findings: FindingsState, separator: str, decimal: str) -> str:
    """All tables, each under its title."""
    parts = [findings.title, *findings.source.splitlines()]
    for table in findings.tables:
        parts += ["", table.title, table_text(table, separator=separator, decimal=decimal).rstrip()]
    return "\n".join(parts) + "\n"
