"""The page Gyrocompass put together."""

from PySide6.QtCore import QCoreApplication, QSize

from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.gyrocompass.content_view import CompassContent
from gui.gyrocompass.presenter import CompassPresenter
from gui.gyrocompass.side_view import CompassSide
from gui.gyrocompass.state import CompassState
from gui.report_export import Report, report_formats
from gui.services import Services
from gui.widgets.analysis_page import AnalysisPage

_PICTURE = QSize(760, 900)


class CompassPage(AnalysisTab):
    """Presenter, views and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.presenter = CompassPresenter(services.jobs, services.messages, self)
        self.content = CompassContent()
        self._side = CompassSide()
        self._page = AnalysisPage(
            self.content,
            (
                QCoreApplication.translate(
                    "Gyrocompass", "Measurements (*.csv *.txt *.json *.jsonl)"
                ),
                QCoreApplication.translate("Gyrocompass", "All files (*)"),
            ),
        )
        self._named = ""
        self.exporting = export_under(
            self._page.findings, report_formats(), self._report, services, self
        )
        self._side.decided.connect(self.presenter.decide)
        self._side.noise.decided.connect(self.presenter.set_noise)
        self._side.noise.record_chosen.connect(self.presenter.load_noise)
        self._page.file_chosen.connect(self.presenter.load)
        self.presenter.changed.connect(self._render)
        self._render(self.presenter.state)

    @property
    def side(self) -> CompassSide:
        """What is decided."""
        return self._side

    @property
    def widget(self) -> AnalysisPage:
        """All the rest."""
        return self._page

    def close(self) -> None:
        """Let go of the plot."""
        self.content.close_plot()

    def _render(self, state: CompassState) -> None:
        self._side.render(state)
        self.content.render(state)
        self._page.render(state.frame)
        found = state.frame.findings
        if found is not None and found.title != self._named:
            self._named = found.title
            self.exporting.renew()

    def _report(self) -> Report | None:
        found, findings = self.presenter.found, self.presenter.state.frame.findings
        if findings is None:
            return None
        return Report(
            f"Gyrocompass {'' if found.run is None else found.run.device}".strip(),
            findings.tables,
            {
                "source": findings.source,
                "choices": found.choices,
                "gyrocompass": found.compass,
                "advice": found.advice,
            },
            self.content.paint,
            _PICTURE,
        )


def make_page(services: Services) -> CompassPage:
    """Build the page."""
    return CompassPage(services)
