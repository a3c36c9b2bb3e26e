"""What the tabs hand to each other: plans, files, results for certificates."""

from collections.abc import Callable, Mapping
from pathlib import Path

from core.certificates.measured import Measured
from core.plans.plan import Plan
from gui.main_window import CalibratingTab, CertifyingTab, GradingTab, LoadTab, PlanTab, Tab
from gui.services import Addition


class Handing:
    """Finds the tab that takes something, hands it over, and shows that tab.

    Parameters
    ----------
    tabs : returns all tabs by their titles
    show : brings a tab to the front
    """

    def __init__(self, tabs: Callable[[], Mapping[str, Tab]], show: Callable[[Tab], None]) -> None:
        self._tabs = tabs
        self._show = show

    def open_plan(self, plan: Plan) -> bool:
        """Hand a plan to the tab that measures it; return whether one took it."""
        for tab in self._tabs().values():
            if isinstance(tab, PlanTab) and tab.open_plan(plan):
                self._show(tab)
                return True
        return False

    def open_file(self, title: str, path: Path) -> bool:
        """Hand a file to the tab of a title; return whether there is such a tab."""
        tab = self._tabs().get(title)
        if not isinstance(tab, LoadTab):
            return False
        self._show(tab)
        tab.load(path)
        return True

    def calibrate_with(self, addition: Addition, show: bool) -> bool:
        """Hand a run with added effects to the tab that calibrates such runs; whether one did."""
        for tab in self._tabs().values():
            if isinstance(tab, CalibratingTab) and tab.calibrate_with(addition, show):
                if show:
                    self._show(tab)
                return True
        return False

    def grade_plan(self, plan: Plan, passes: int) -> None:
        """Let the tab that can tell what a plan shows do so."""
        for tab in self._tabs().values():
            if isinstance(tab, GradingTab):
                self._show(tab)
                tab.grade_plan(plan, passes)

    def certify(self, measured: Measured) -> None:
        """Hand results to the tab that makes certificates."""
        for tab in self._tabs().values():
            if isinstance(tab, CertifyingTab):
                self._show(tab)
                tab.certify(measured)

    @staticmethod
    def read_measured(path: Path) -> Measured:
        """What a file holds, processed; raises `LabError`."""
        from core.samples.run import Conditions
        from gui.measured_file import measured_of_file

        return measured_of_file(path, Conditions())
