"""The Accuracy tab put together."""

from dataclasses import replace

from PySide6.QtCore import Qt

from core.errors import LabError, Severity
from core.procedures.accuracy_plan import angles_of_text, kind_of, wanted_deg, with_angles
from core.samples.block import SampleBlock
from core.samples.turning import turning_columns, unwrapped
from gui.accuracy.checking import NEAREST, Checked
from gui.accuracy.guide import AccuracyGuide
from gui.accuracy.offering import Offering
from gui.accuracy.results import AccuracyResults
from gui.accuracy.results_view import AccuracyResultsView
from gui.accuracy.settings import AccuracySettings
from gui.accuracy.settings_view import AccuracyForm
from gui.accuracy.texts import say
from gui.accuracy.written import formats
from gui.measuring.tab import MeasuringTab
from gui.services import Services
from gui.widgets.states import BannerState

_SOURCE = "accuracy angles"


class AccuracyTab(MeasuringTab[AccuracySettings]):
    """Pitch and roll of a unit against the angles of the head."""

    results: AccuracyResults

    def __init__(self, services: Services) -> None:
        guide = AccuracyGuide()
        results = AccuracyResults(
            guide.key, services.jobs, services.messages, services.root, services.nearest
        )
        self._form = AccuracyForm(AccuracySettings())
        self.page = page = AccuracyResultsView()
        super().__init__(services, guide, results, self._form, formats(), page)
        self._judged = 0
        self._form.angles_typed.connect(self._on_angles)
        page.page_chosen.connect(results.show_page)
        page.trace_toggled.connect(results.show_trace)
        self.sitting.changed.connect(self._on_sitting)
        # After the presenter has taken the settings.
        self._form.edited.connect(self._on_edited, Qt.ConnectionType.QueuedConnection)
        self.bench.block.connect(self._on_block)
        self.bench.link_changed.connect(self._on_link)
        self._offering = Offering(results, services.jobs, services.messages, services.nearest, self)
        self._offering.accepted.connect(self._on_use)
        self._on_sitting()

    def exported(self) -> Checked | None:
        """The check on the page."""
        return self.results.state

    def _on_sitting(self) -> None:
        """Show the list of the plan; judge what was measured whenever it has changed."""
        angles = wanted_deg(self.sitting.plan).values()
        self._form.show_angles(", ".join(f"{angle:g}" for angle in angles))
        session = self.sitting.keeper.session
        events = 0 if session is None else len(session.record.events)
        if events != self._judged:
            self._judged = events
            if session is not None and session.positions:
                self.presenter.process()

    def _on_edited(self) -> None:
        """Limit, rule or calibration are others: the verdict follows at once."""
        if self.results.state is not None and not self.results.busy:
            self.presenter.process()

    def _on_use(self) -> None:
        """Judge the raw codes by the calibration that was offered."""
        settings = replace(self.sitting.settings, calibration=NEAREST)
        self._form.edited.emit(settings)

    def _on_angles(self, text: str) -> None:
        """Another list: set angles of the loaded file, or the steps to come."""
        messages = self._services.messages
        messages.clear(_SOURCE)
        session = self.sitting.keeper.session
        try:
            if session is None and self.results.can_process_again:
                kind = kind_of(self.sitting.plan)
                why_not = self.results.take_angles(text, kind, self.sitting.settings)
            elif session is None:
                plan = with_angles(self.sitting.plan, angles_of_text(text))
                self.presenter.set_steps(plan.steps)
                why_not = ""
            else:
                why_not = say("The list belongs to the session; press New session to change it.")
        except LabError as error:
            why_not = str(error)
        if why_not:
            banner = BannerState(
                Severity.WARNING,
                say("The list Angles stays as it was"),
                why_not,
                say(
                    "Type one angle for every row, in degrees, as 0, 30, 60; or press New session."
                ),
            )
            messages.show(_SOURCE, banner)
        self._on_sitting()

    def _on_block(self, block: SampleBlock) -> None:
        """The angle that the unit tells now, for the page Current."""
        role = f"angle.{kind_of(self.sitting.plan)}"
        roles = [channel.role for channel in block.channels]
        if role not in roles:
            return
        place = roles.index(role)
        data = unwrapped(block.data, turning_columns(block.channels))
        self.results.set_level(float(data[:, place].mean()))

    def _on_link(self) -> None:
        if not self.bench.linked:
            self.results.set_level(float("nan"))


def make_tab(services: Services) -> AccuracyTab:
    """Build the tab."""
    return AccuracyTab(services)
