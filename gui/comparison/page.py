"""The page Compare gyros put together."""

from pathlib import Path

from PySide6.QtCore import Qt

from core.errors import Severity, StorageError
from core.records.atomic import write_bytes_atomic
from gui.analysis.tab import AnalysisTab
from gui.comparison.content_view import ComparisonContent
from gui.comparison.presenter import SOURCE, ComparisonPresenter
from gui.comparison.side_view import ComparisonSide
from gui.comparison.state import ComparisonState
from gui.comparison.tables import say
from gui.services import Services
from gui.widgets.states import BannerState, TableState
from gui.widgets.table_text import table_text

_NAME = "gyro_comparison.csv"


class ComparisonPage(AnalysisTab):
    """Presenter, views and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.presenter = ComparisonPresenter(services.jobs, services.messages, self)
        self.content = ComparisonContent()
        self._side = ComparisonSide(self.presenter.g_mps2)
        self._side.added.connect(self.presenter.add)
        # The list is filled anew, which it must not be while a name is being taken over from it.
        queued = Qt.ConnectionType.QueuedConnection
        self._side.renamed.connect(self.presenter.rename, queued)
        self._side.removed.connect(self.presenter.remove)
        self._side.g_edited.connect(self._on_g)
        self.presenter.changed.connect(self._render)
        findings = self.content.findings
        findings.set_formats(
            (("csv", say("Table, CSV")), ("excel", say("Table, CSV with decimal comma")))
        )
        findings.show_name(str(services.root() / _NAME))
        findings.export_requested.connect(self.export)
        self._render(self.presenter.state)

    @property
    def side(self) -> ComparisonSide:
        """The files."""
        return self._side

    @property
    def widget(self) -> ComparisonContent:
        """The table."""
        return self.content

    def close(self) -> None:
        """Nothing runs that must be ended."""

    def export(self, key: str, name: str) -> None:
        """Write the table under a name; one without a folder goes to the sessions'."""
        findings = self.presenter.state.findings
        if findings is None or not name.strip():
            return
        path = self._services.root() / Path(name.strip()).expanduser()
        text = _text(findings.tables[0], key)
        messages = self._services.messages
        try:
            write_bytes_atomic(path, text.encode("utf-8-sig" if key == "excel" else "utf-8"))
        except StorageError as error:
            messages.tell_error(SOURCE, say("Not exported"), error)
            return
        messages.show(SOURCE, BannerState(Severity.INFO, say("Exported"), str(path)))

    def _on_g(self, g_mps2: float) -> None:
        self.presenter.g_mps2 = g_mps2

    def _render(self, state: ComparisonState) -> None:
        self._side.render(state)
        self.content.render(state)


def _text(table: TableState, key: str) -> str:
    if key == "excel":
        return table_text(table, separator=";", decimal=",")
    return table_text(table, separator=",")


def make_page(services: Services) -> ComparisonPage:
    """Build the page."""
    return ComparisonPage(services)
