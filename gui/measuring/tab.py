"""A measuring tab put together."""

from collections.abc import Sequence
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, Generic
from weakref import WeakSet

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from core.plans.plan import OWN_PLANS, Plan, Step, load_plans
from core.procedures.measuring import Phase
from core.records.session.find import Unfinished, unfinished
from gui.exporting import ExportFormat, Exporting
from gui.measuring.bench import Bench
from gui.measuring.bending import BendingResults
from gui.measuring.guide import Guide, S
from gui.measuring.presenter import MeasuringPresenter
from gui.measuring.results import Results
from gui.measuring.results_view import ResultsView
from gui.measuring.resuming import Resuming
from gui.measuring.settings_view import SettingsForm
from gui.measuring.site import SECTION, Site, site_of
from gui.measuring.sitting import Sitting
from gui.measuring.taking import Taking
from gui.measuring.view import MeasuringView
from gui.services import Addition, Services

MODEL_VS_DATA = "Model vs data"
"""The tab that tells what a model lacks, and the tests whose models it knows."""
EXPLAINED = frozenset(("dividing_head", "rate_table", "static_positions"))

_TABS: "WeakSet[MeasuringTab[Any]]" = WeakSet()
"""All measuring tabs that there are."""


class MeasuringTab(Generic[S], QObject):
    """Presenter, view and what joins them.

    Parameters
    ----------
    services : what all tabs share
    guide : what is particular to the test
    results : what is made of the measurements
    form : the operator's settings
    formats : of the export
    page : the results page; None for the common one
    """

    def __init__(
        self,
        services: Services,
        guide: Guide[S],
        results: Results,
        form: SettingsForm[S],
        formats: Sequence[ExportFormat],
        page: ResultsView | None = None,
    ) -> None:
        super().__init__()
        self._services = services
        self.guide = guide
        plans = self._plans = plans_of(guide.tests, services.root() / OWN_PLANS)
        settings = guide.settings_of(services.settings.section(guide.key))
        plan = plans.get(settings.plan_id) or next(iter(plans.values()))
        messages = services.messages
        self.bench = Bench(services.connection, guide.device_of, guide.missing, self)
        self.results = results
        results.setParent(self)
        self.sitting = Sitting[S](guide, self.bench, messages, services.root, plan, settings, self)
        self.sitting.operator = site_of(services.settings.section(SECTION)).operator
        self.taking = Taking(self.sitting, self.bench, messages, self)
        self.presenter = MeasuringPresenter[S](
            self.bench, self.sitting, self.taking, results, plans, services.settings, self
        )
        self.exporting = Exporting(
            f"{guide.key} export",
            formats,
            self.exported,
            self._folder,
            services.jobs,
            messages,
            self,
        )
        nouns = guide.words(plan).nouns
        self._resuming = Resuming(guide.key, guide.tests, nouns, messages, self)
        self._resuming.chosen.connect(self._on_resume)
        self.taking.cue.connect(self._on_cue)
        self.presenter.hands_free_on.connect(self._on_hands_free)
        _TABS.add(self)
        self.view = MeasuringView(self.presenter, form, page)
        self.view.file_chosen.connect(self._on_file)
        results.changed.connect(self._on_results)
        self.view.results.closed.connect(results.clear)
        self.view.results.explain_requested.connect(self._on_explain)
        self.view.grade.clicked.connect(self._on_grade)
        self.view.grade.setVisible(isinstance(results, BendingResults))
        self.view.results.take_out_requested.connect(self._on_take_out)
        self.view.results.explain.setVisible(bool(EXPLAINED.intersection(guide.tests)))
        self.view.results.certificate_requested.connect(self._on_certificate)
        self.exporting.serve(self.view.results.foot)

    def exported(self) -> Any:
        """What the formats of the export are given; None while there is nothing."""
        return self.results.page

    @property
    def widget(self) -> MeasuringView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the charts, and look for sessions that wait."""
        from gui.measuring.graph import MainGraph
        from gui.widgets.strip_charts import StripCharts

        charts = StripCharts()
        charts.setMinimumWidth(18 * charts.fontMetrics().height())
        self.view.graph_place.addWidget(charts, 1)
        MainGraph(charts, self.bench, self.sitting)
        root = self._services.root()
        self._services.jobs.start(
            "unfinished sessions", lambda: unfinished(root), self._on_unfinished, self._on_failed
        )

    def why_busy(self) -> str:
        """Why the ports cannot be let go of."""
        return "An accumulation is running." if self.sitting.walk.measuring else ""

    def wanted(self) -> tuple[Plan, Step] | None:
        """What has to be set on the rig now."""
        status = self.sitting.walk.status
        if status is None or status.step is None or status.phase is Phase.MEASURING:
            return None
        return self.sitting.plan, status.step

    def open_plan(self, plan: Plan) -> bool:
        """Take a plan; False if its test is another one, or a session holds the plan."""
        if plan.test not in self.guide.tests or self.presenter.state.locked.plan:
            return False
        self._plans[plan.id] = plan
        self.presenter.set_plan(plan.id)
        if self.sitting.plan.steps != plan.steps:
            # It has the name of the plan that was there.
            self.presenter.set_steps(plan.steps)
        return True

    def take_site(self, site: Site) -> None:
        """The laboratory states who measures and where; a session keeps what it was begun with."""
        self.sitting.operator = site.operator
        if self.sitting.keeper.session is None:
            settings = self.sitting.settings
            known = {field.name for field in fields(settings)}
            stated = {k: v for k, v in site.to_section().items() if k in known}
            self.presenter.set_settings(replace(settings, **stated))

    def calibrate_with(self, addition: Addition, show: bool) -> bool:
        """Calibrate a run with further effects; False if the run is of another kind of test.

        Parameters
        ----------
        addition : the run and the effects
        show : take it also where the page shows something else
        """
        results = self.results
        if addition.run.test not in self.guide.tests or not isinstance(results, BendingResults):
            return False
        here = results.page is not None and self._source() in addition.paths
        if not (show or here):
            return False
        results.add_effects(addition, self.sitting.settings, self._bench_folder())
        return True

    def close(self) -> None:
        """Leave the session on the disk, to be continued."""
        self.taking.stop()
        self.sitting.close()

    def load(self, path: Path) -> None:
        """Load Data."""
        self.results.load(path, self.sitting.settings)

    def _folder(self) -> Path:
        """Where exports go unless the operator says otherwise."""
        session = self.sitting.keeper.session
        return self._services.root() if session is None else session.folder

    def _on_cue(self, name: str) -> None:
        self._services.play(name)
        if self.sitting.keeper.session is not None:
            self._resuming.withdraw()

    def _on_hands_free(self) -> None:
        """Two tabs that both accumulate by themselves would take each other's positions."""
        for tab in list(_TABS):
            if tab is not self:
                tab.let_go(self._services)

    def let_go(self, services: Services) -> None:
        """Another tab of the window with these services measures hands-free now."""
        if services is self._services and self.sitting.settings.hands_free:
            self.presenter.set_hands_free(False)

    def _on_unfinished(self, found: object) -> None:
        if not isinstance(found, tuple):
            raise TypeError(f"looking for sessions brought {type(found).__name__}")
        if self.guide.tells_damage:
            for one in found:
                if one.record is None:
                    self._services.messages.log(Severity.WARNING, one.problem, self.guide.key)
        if self.sitting.keeper.session is None:
            self._resuming.offer(found)

    def _on_failed(self, error: LabError) -> None:
        self._services.messages.log(Severity.ERROR, str(error), self.guide.key)

    def _on_resume(self, one: object) -> None:
        if not isinstance(one, Unfinished) or one.record is None:
            raise TypeError(f"{type(one).__name__} cannot be continued")
        settings = self.guide.settings_of_session(one.record.start, self.sitting.settings)
        try:
            self.sitting.resume(one.folder, settings)
        except LabError as error:
            source = f"{self.guide.key} session"
            self._services.messages.tell_error(source, "The session cannot be opened", error)

    def _on_file(self, name: str) -> None:
        self.load(Path(name))

    def _bench_folder(self) -> Path | None:
        session = self.sitting.keeper.session
        return None if session is None else session.folder

    def _source(self) -> Path | None:
        """Folder or file that the page is made of."""
        return self.results.source_path or self._bench_folder()

    def _on_take_out(self) -> None:
        if isinstance(self.results, BendingResults):
            self.results.take_out(self.sitting.settings, self._bench_folder())

    def _on_grade(self) -> None:
        self._services.grade_plan(self.sitting.plan, self.sitting.settings.passes)

    def _on_explain(self) -> None:
        path = self._source()
        if path is not None:
            self._services.open_file(MODEL_VS_DATA, path)

    def _on_certificate(self) -> None:
        measured = self.results.measured
        if measured is not None:
            self._services.certify(measured)

    def _on_results(self) -> None:
        page = self.results.page
        self.view.results.render(page)
        if page is None:
            self.exporting.forget()
        else:
            self.exporting.renew()


def plans_of(tests: Sequence[str], own: Path | None = None) -> dict[str, Plan]:
    """The plans of some tests, by their identifiers; a damaged one of the user takes all his away.

    Parameters
    ----------
    tests : of `core.plans.plan.TESTS`
    own : folder of the user's plans; None for the packaged ones alone
    """
    try:
        plans = load_plans(own)
    except LabError:
        # The page that makes plans tells which one; measuring goes on with the packaged ones.
        plans = load_plans()
    return {key: plan for key, plan in plans.items() if plan.test in tests}
