"""A page of the tab Methods: a form at the side, a picture, findings and their export."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any

from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.report_export import Report, report_formats
from gui.services import Services
from gui.widgets.analysis_page import AnalysisPage
from gui.widgets.states import FindingsState


class MethodPage(AnalysisTab):
    """Presenter, views and what joins them.

    Parameters
    ----------
    presenter : takes what is decided, tells its state when that has changed
    side, content : the form and the picture; both show a state
    filters : of the file dialog, in words
    drawn : whether the picture can be exported
    """

    def __init__(
        self,
        services: Services,
        presenter: Any,
        side: Any,
        content: Any,
        filters: Sequence[str] = (),
        *,
        drawn: bool = True,
    ) -> None:
        super().__init__()
        presenter.setParent(self)
        self.presenter, self.side, self.content = presenter, side, content
        self.widget = AnalysisPage(content, filters)
        self.exporting = export_under(
            self.widget.findings.foot, report_formats(drawn=drawn), self._report, services, self
        )
        self._named = ""
        side.decided.connect(presenter.decide)
        presenter.changed.connect(self._render)
        self._render(presenter.state)

    def close(self) -> None:
        """Nothing runs that must be ended."""

    @abstractmethod
    def _report(self) -> Report | None:
        """What can be exported; None for nothing."""

    def _name(self, findings: FindingsState) -> str:
        """What another file name is proposed for when it changes."""
        return findings.title

    def _render(self, state: Any) -> None:
        self.side.render(state)
        self.content.render(state)
        self.widget.render(state.frame)
        found = state.frame.findings
        if found is not None and self._name(found) != self._named:
            self._named = self._name(found)
            self.exporting.renew()
