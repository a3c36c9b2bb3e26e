"""The page Compare gyros put together."""

from pathlib import Path

from PySide6.QtCore import Qt

from core.records.atomic import write_text_atomic
from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.comparison.content_view import ComparisonContent
from gui.comparison.presenter import ComparisonPresenter
from gui.comparison.side_view import ComparisonSide
from gui.comparison.state import ComparisonState
from gui.comparison.tables import say
from gui.exporting import ExportFormat
from gui.services import Services
from gui.widgets.states import FindingsState
from gui.widgets.table_text import table_text

_NAME = "gyro_comparison.csv"


class ComparisonPage(AnalysisTab):
    """Presenter, views and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
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
        self.exporting = export_under(
            self.content.findings.foot,
            (
                _format("csv", say("Table, CSV"), ",", "."),
                _format("excel", say("Table, CSV with decimal comma"), ";", ","),
            ),
            lambda: self.presenter.state.findings,
            services,
            self,
        )
        self._named = False
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

    def _on_g(self, g_mps2: float) -> None:
        self.presenter.g_mps2 = g_mps2

    def _render(self, state: ComparisonState) -> None:
        self._side.render(state)
        self.content.render(state)
        if state.findings is not None and not self._named:
            self._named = True
            self.exporting.renew()


def _format(key: str, title: str, separator: str, decimal: str) -> ExportFormat:
    def write(findings: FindingsState, path: Path) -> None:
        text = table_text(findings.tables[0], separator=separator, decimal=decimal)
        # Spreadsheets that want a decimal comma take UTF-8 without a BOM for CP1251.
        write_text_atomic(path, text, encoding="utf-8" if decimal == "." else "utf-8-sig")

    return ExportFormat(key, title, lambda _: _NAME, write, at_once=True)


def make_page(services: Services) -> ComparisonPage:
    """Build the page."""
    return ComparisonPage(services)
