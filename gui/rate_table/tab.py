"""The rate-table tab put together."""

from collections.abc import Sequence

from gui.measuring.tab import MeasuringTab
from gui.rate_table.formats import formats
from gui.rate_table.free import free_steps
from gui.rate_table.guide import RateGuide
from gui.rate_table.processing import RateResult
from gui.rate_table.results import RateResults
from gui.rate_table.settings import RateSettings
from gui.rate_table.settings_view import RateForm
from gui.services import Services


class RateTab(MeasuringTab[RateSettings]):
    """Gyros on the rate table, and at rest on the dividing head."""

    results: RateResults

    def __init__(self, services: Services) -> None:
        guide = RateGuide()
        results = RateResults(guide.key, services.jobs, services.messages)
        form = RateForm(RateSettings())
        super().__init__(services, guide, results, form, formats())
        form.rates_set.connect(self._on_rates)

    def exported(self) -> RateResult | None:
        """The results on the page."""
        return self.results.state

    def _on_rates(self, rates: Sequence[float], mounts: Sequence[str], both_ways: bool) -> None:
        self.presenter.set_steps(free_steps(rates, mounts, both_ways=both_ways))


def make_tab(services: Services) -> RateTab:
    """Build the tab."""
    return RateTab(services)
