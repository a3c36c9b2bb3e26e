"""The page Which procedure? put together."""

from gui.advisor.plan_view import PlanView
from gui.advisor.presenter import AdvisorPresenter
from gui.advisor.side_view import AdvisorSide
from gui.analysis.page import MethodPage
from gui.report_export import Report
from gui.services import Services


class AdvisorPage(MethodPage):
    """Presenter, views and what joins them."""

    presenter: AdvisorPresenter
    side: AdvisorSide
    content: PlanView

    def __init__(self, services: Services) -> None:
        presenter = AdvisorPresenter(
            services.jobs, services.messages, services.root, services.open_plan
        )
        super().__init__(services, presenter, AdvisorSide(), PlanView(), drawn=False)
        self.side.noise.decided.connect(presenter.set_noise)
        self.side.noise.record_chosen.connect(presenter.load_noise)
        self.content.chosen.connect(presenter.choose)
        self.content.kept.connect(presenter.keep)
        self.content.added.connect(presenter.add)
        self.widget.triggered.connect(presenter.act)

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
