"""The page Fourier tumble put together."""

from PySide6.QtCore import QCoreApplication, QSize

from gui.analysis.page import MethodPage
from gui.report_export import Report
from gui.services import Services
from gui.tumble.content_view import TumbleContent
from gui.tumble.presenter import TumblePresenter
from gui.tumble.side_view import TumbleSide
from gui.widgets.states import FindingsState

_PICTURE = QSize(760, 900)


class TumblePage(MethodPage):
    """Presenter, views and what joins them."""

    presenter: TumblePresenter
    side: TumbleSide
    content: TumbleContent

    def __init__(self, services: Services) -> None:
        presenter = TumblePresenter(services.jobs, services.messages, services.root)
        filters = (
            QCoreApplication.translate("Tumble", "Measurements (*.csv *.txt *.json *.jsonl)"),
            QCoreApplication.translate("Tumble", "All files (*)"),
        )
        super().__init__(services, presenter, TumbleSide(), TumbleContent(), filters)
        self.widget.triggered.connect(presenter.act)
        self.widget.file_chosen.connect(presenter.load)

    def _name(self, findings: FindingsState) -> str:
        return findings.source

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
