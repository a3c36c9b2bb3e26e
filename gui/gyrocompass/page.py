"""The page Gyrocompass put together."""

from PySide6.QtCore import QCoreApplication, QSize

from gui.analysis.page import MethodPage
from gui.gyrocompass.content_view import CompassContent
from gui.gyrocompass.presenter import CompassPresenter
from gui.gyrocompass.side_view import CompassSide
from gui.report_export import Report
from gui.services import Services

_PICTURE = QSize(760, 900)


class CompassPage(MethodPage):
    """Presenter, views and what joins them."""

    presenter: CompassPresenter
    side: CompassSide
    content: CompassContent

    def __init__(self, services: Services) -> None:
        presenter = CompassPresenter(services.jobs, services.messages)
        filters = (
            QCoreApplication.translate("Gyrocompass", "Measurements (*.csv *.txt *.json *.jsonl)"),
            QCoreApplication.translate("Gyrocompass", "All files (*)"),
        )
        super().__init__(services, presenter, CompassSide(), CompassContent(), filters)
        self.side.noise.decided.connect(presenter.set_noise)
        self.side.noise.record_chosen.connect(presenter.load_noise)
        self.widget.file_chosen.connect(presenter.load)

    def close(self) -> None:
        """Let go of the plot."""
        self.content.close_plot()

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
