"""The dividing-head tab put together."""

import math

from gui.dividing_head.formats import formats
from gui.dividing_head.guide import HeadGuide
from gui.dividing_head.processing import HeadResult
from gui.dividing_head.results import HeadResults
from gui.dividing_head.settings import HeadSettings
from gui.dividing_head.settings_view import HeadForm
from gui.dividing_head.thermal_offer import ThermalOffer
from gui.measuring.tab import MeasuringTab
from gui.services import Services


class HeadTab(MeasuringTab[HeadSettings]):
    """Accelerometers on the dividing head."""

    results: HeadResults

    def __init__(self, services: Services) -> None:
        guide = HeadGuide()
        results = HeadResults(guide.key, services.jobs, services.messages)
        form = HeadForm(HeadSettings())
        super().__init__(services, guide, results, form, formats())
        form.angle_added.connect(self.presenter.add_angle)
        self._thermal = ThermalOffer(services.messages, services.open_file, self)
        results.changed.connect(self._offer_thermal)

    def _offer_thermal(self) -> None:
        session = self.sitting.keeper.session
        if session is None or self.results.state is None or self.results.can_process_again:
            return
        found = {position.set_temperature_c for position in session.positions}
        self._thermal.offer(session.folder, sum(not math.isnan(value) for value in found))

    def exported(self) -> HeadResult | None:
        """The calibration on the page."""
        return self.results.state


def make_tab(services: Services) -> HeadTab:
    """Build the tab."""
    return HeadTab(services)
