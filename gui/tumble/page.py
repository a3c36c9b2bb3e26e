"""The page Fourier tumble put together."""

from PySide6.QtCore import QCoreApplication, QSize

from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.report_export import Report, report_formats
from gui.services import Services
from gui.tumble.content_view import TumbleContent
from gui.tumble.presenter import TumblePresenter
from gui.tumble.side_view import TumbleSide
from gui.tumble.state import TumbleState
from gui.widgets.analysis_page import AnalysisPage

_PICTURE = QSize(760, 900)


class TumblePage(AnalysisTab):
    """Presenter, views and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.presenter = TumblePresenter(services.jobs, services.messages, services.root, self)
        self.content = TumbleContent()
        self._side = TumbleSide()
        self._page = AnalysisPage(
            self.content,
            (
                QCoreApplication.translate("Tumble", "Measurements (*.csv *.txt *.json *.jsonl)"),
                QCoreApplication.translate("Tumble", "All files (*)"),
            ),
        )
        self.exporting = export_under(
            self._page.findings, report_formats(), self._report, services, self
        )
        self._named = ""
        self._side.decided.connect(self.presenter.decide)
        self._page.triggered.connect(self.presenter.act)
        self._page.file_chosen.connect(self.presenter.load)
        self.presenter.changed.connect(self._render)
        self._render(self.presenter.state)

    @property
    def side(self) -> TumbleSide:
        """What is decided."""
        return self._side

    @property
    def widget(self) -> AnalysisPage:
        """All the rest."""
        return self._page

    def close(self) -> None:
        """Nothing runs that must be ended."""

    def _render(self, state: TumbleState) -> None:
        self._side.render(state)
        self.content.render(state)
        self._page.render(state.frame)
        found = state.frame.findings
        if found is not None and found.source != self._named:
            self._named = found.source
            self.exporting.renew()

    def _report(self) -> Report | None:
        study, findings = self.presenter.study, self.presenter.state.frame.findings
        if study is None or findings is None:
            return None
        return Report(
            f"Tumble {self.presenter.device}",
            findings.tables,
            {"source": findings.source, "tumble": study},
            self.content.paint,
            _PICTURE,
        )


def make_page(services: Services) -> TumblePage:
    """Build the page."""
    return TumblePage(services)
