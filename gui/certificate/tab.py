"""The tab Certificates put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.certificates.measured import Measured
from core.plans.plan import Plan, Step
from gui.certificate.presenter import CertificatePresenter
from gui.certificate.view import CertificateView
from gui.services import Services


class CertificateTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.presenter = CertificatePresenter(services, self)
        self.view = CertificateView(self.presenter)

    @property
    def widget(self) -> CertificateView:
        """What is shown."""
        return self.view

    def certify(self, measured: Measured) -> None:
        """Begin a certificate of results."""
        self.presenter.take(measured)

    def load(self, path: Path) -> None:
        """Begin a certificate of what a file, or a session's folder, holds."""
        self.presenter.load(path)

    def after_paint(self) -> None:
        """Nothing: the tab is light until results come."""

    def why_busy(self) -> str:
        """Why the ports cannot be let go of: never, it has nothing to do with them."""
        return ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """Nothing has to be set on the rig."""
        return None

    def close(self) -> None:
        """Keep what was typed about the laboratory."""
        self.presenter.keeper.flush()


def make_tab(services: Services) -> CertificateTab:
    """Build the tab."""
    return CertificateTab(services)
