"""The page Which procedure? put together."""

from gui.advisor.plan_view import PlanView
from gui.advisor.presenter import AdvisorPresenter
from gui.advisor.side_view import AdvisorSide
from gui.advisor.state import AdvisorState
from gui.analysis.export import export_under
from gui.analysis.tab import AnalysisTab
from gui.report_export import Report, report_formats
from gui.services import Services
from gui.widgets.analysis_page import AnalysisPage


class AdvisorPage(AnalysisTab):
    """Presenter, views and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.presenter = AdvisorPresenter(
            services.jobs, services.messages, services.root, services.open_plan, self
        )
        self.plans = PlanView()
        self._side = AdvisorSide()
        self._page = AnalysisPage(self.plans, ())
        self._named = ""
        self.exporting = export_under(
            self._page.findings, report_formats(drawn=False), self._report, services, self
        )
        presenter = self.presenter
        self._side.decided.connect(presenter.decide)
        self._side.noise.decided.connect(presenter.set_noise)
        self._side.noise.record_chosen.connect(presenter.load_noise)
        self.plans.chosen.connect(presenter.choose)
        self.plans.kept.connect(presenter.keep)
        self.plans.added.connect(presenter.add)
        self._page.triggered.connect(presenter.act)
        presenter.changed.connect(self._render)
        self._render(presenter.state)

    @property
    def side(self) -> AdvisorSide:
        """Sensor and rig."""
        return self._side

    @property
    def widget(self) -> AnalysisPage:
        """All the rest."""
        return self._page

    def close(self) -> None:
        """Nothing runs that must be ended."""

    def _render(self, state: AdvisorState) -> None:
        self._side.render(state)
        self.plans.render(state)
        self._page.render(state.frame)
        found = state.frame.findings
        if found is not None and found.title != self._named:
            self._named = found.title
            self.exporting.renew()

    def _report(self) -> Report | None:
        advised, findings = self.presenter.advised, self.presenter.state.frame.findings
        if advised.after is None or findings is None:
            return None
        return Report(
            f"Prediction {advised.choices.plan_id}",
            findings.tables,
            {
                "method": advised.choices.method,
                "plan": advised.plan,
                "prediction": advised.after,
                "unseen": advised.unseen,
            },
        )


def make_page(services: Services) -> AdvisorPage:
    """Build the page."""
    return AdvisorPage(services)
