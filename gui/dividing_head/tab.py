"""The dividing-head tab put together."""

from pathlib import Path

from PySide6.QtCore import QObject

from core.errors import LabError, Severity
from core.plans.plan import Plan, Step, load_plans
from core.procedures.measuring import Phase
from core.records.session.find import Unfinished, unfinished
from gui.dividing_head.bench import Bench
from gui.dividing_head.exporting import Exporting
from gui.dividing_head.nominal import nominal_of
from gui.dividing_head.presenter import HeadPresenter, remembered
from gui.dividing_head.results import ResultsPresenter
from gui.dividing_head.resuming import Resuming, settings_of_session
from gui.dividing_head.sitting import Sitting
from gui.dividing_head.taking import Taking
from gui.dividing_head.view import HeadView
from gui.services import Services

_TEST = "dividing_head"


class HeadTab(QObject):
    """Presenter, view and what joins them."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        plans = {key: plan for key, plan in load_plans().items() if plan.test == _TEST}
        settings = remembered(services.settings)
        plan = plans.get(settings.plan_id) or next(iter(plans.values()))
        messages = services.messages
        self.bench = Bench(services.connection, self)
        self.results = ResultsPresenter(services.jobs, messages, self)
        self.sitting = Sitting(
            self.bench,
            messages,
            services.root,
            lambda name: nominal_of(services.root(), name),
            plan,
            settings,
            self,
        )
        self.taking = Taking(self.sitting, self.bench, messages, self)
        self.presenter = HeadPresenter(
            self.bench, self.sitting, self.taking, self.results, plans, services.settings, self
        )
        self.exporting = Exporting(self.results, self._folder, services.jobs, messages, self)
        self._resuming = Resuming(messages, self)
        self._resuming.chosen.connect(self._on_resume)
        self.taking.cue.connect(self._on_cue)
        self.view = HeadView(self.presenter)
        self.view.file_chosen.connect(self._on_file)
        self.results.changed.connect(self._on_results)
        self.view.results.closed.connect(self.results.clear)
        self.view.results.set_formats(self.exporting.formats)
        self.view.results.format_chosen.connect(self._on_format)
        self.view.results.export_requested.connect(self.exporting.export)

    @property
    def widget(self) -> HeadView:
        """What is shown."""
        return self.view

    def after_paint(self) -> None:
        """Load the charts, and look for sessions that wait."""
        from gui.dividing_head.graph import MainGraph
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
        """What has to be set on the head now."""
        status = self.sitting.walk.status
        if status is None or status.step is None or status.phase is Phase.MEASURING:
            return None
        return self.sitting.plan, status.step

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

    def _on_unfinished(self, found: object) -> None:
        if isinstance(found, tuple) and self.sitting.keeper.session is None:
            self._resuming.offer(found)

    def _on_failed(self, error: LabError) -> None:
        self._services.messages.log(Severity.ERROR, str(error), _TEST)

    def _on_resume(self, one: object) -> None:
        if not isinstance(one, Unfinished) or one.record is None:
            raise TypeError(f"{type(one).__name__} cannot be continued")
        try:
            self.sitting.resume(
                one.folder, settings_of_session(one.record.start, self.sitting.settings)
            )
        except LabError as error:
            self._services.messages.tell_error("session", "The session cannot be opened", error)

    def _on_file(self, name: str) -> None:
        self.load(Path(name))

    def _on_results(self) -> None:
        state = self.results.state
        self.view.results.render(state)
        if state is not None:
            self._on_format(self.exporting.chosen)

    def _on_format(self, key: str) -> None:
        self.view.results.show_name(key, self.exporting.propose(key))


def make_tab(services: Services) -> HeadTab:
    """Build the tab."""
    return HeadTab(services)
