"""The tab Model vs data put together."""

from pathlib import Path

from core.plans.plan import Plan
from gui.analysis.tab import AnalysisTab
from gui.discrepancy.exporting import SOURCE, folder_of, formats
from gui.discrepancy.follow_up import FollowUp
from gui.discrepancy.plan_grade import graded
from gui.discrepancy.presenter import DiscrepancyPresenter
from gui.discrepancy.trial_presenter import TrialPresenter
from gui.discrepancy.trial_state import TrialState
from gui.discrepancy.trial_view import TrialView
from gui.discrepancy.view import DiscrepancyView
from gui.exporting import Exporting
from gui.services import Services

TITLE = "Model vs data"


class DiscrepancyTab(AnalysisTab):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.presenter = DiscrepancyPresenter(
            services.jobs,
            services.messages,
            services.calibrate_with,
            parent=self,
        )
        self.view = DiscrepancyView(self.presenter)
        self.trial = TrialPresenter(self.presenter, services.settings, services.messages, self)
        self.trial_view = TrialView(self.trial)
        self.view.findings.put_trial(self.trial_view)
        self.trial.changed.connect(self._on_trial)
        self.exporting = Exporting(
            SOURCE,
            formats(),
            lambda: None if self.presenter.alone else self.presenter.story,
            lambda: folder_of(self.presenter.story, services.root()),
            services.jobs,
            services.messages,
            self,
        )
        self.follow_up = FollowUp(
            lambda: self.presenter.story,
            services.open_plan,
            services.root,
            services.messages,
            self,
        )
        findings = self.view.findings
        findings.plan_opened.connect(self.follow_up.open)
        findings.plan_kept.connect(self.follow_up.keep)
        self.exporting.serve(findings.foot)
        self.presenter.changed.connect(self._on_changed)
        self._named: object = None

    @property
    def widget(self) -> DiscrepancyView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the plots."""
        from gui.discrepancy.plots_view import PlotsView

        self.view.put_plots(PlotsView())

    def load(self, path: Path) -> None:
        """Take a session's folder or a file, and find out why its model is rejected."""
        self.presenter.open([str(path)], find=True)

    def grade_plan(self, plan: Plan, passes: int) -> None:
        """Tell what a plan can show that is walked so often."""
        self.view.findings.show_grade()
        self.presenter.open_alone(lambda: graded(plan, passes), "plan")

    def close(self) -> None:
        """Let go of the plots."""
        self.view.drop_plots()

    def _on_changed(self) -> None:
        story = self.presenter.story
        if story is not self._named:
            self._named = story
            self.exporting.renew()

    def _on_trial(self, state: TrialState | None) -> None:
        self.trial_view.render(state)
        self.view.findings.show_trial(None if state is None else state.title)


def make_tab(services: Services) -> DiscrepancyTab:
    """Build the tab."""
    return DiscrepancyTab(services)
