"""The dividing-head tab put together."""

from gui.dividing_head.formats import formats
from gui.dividing_head.guide import HeadGuide
from gui.dividing_head.processing import HeadResult
from gui.dividing_head.results import HeadResults
from gui.dividing_head.settings import HeadSettings
from gui.dividing_head.settings_view import HeadForm
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

    def exported(self) -> HeadResult | None:
        """The calibration on the page."""
        return self.results.state


def make_tab(services: Services) -> HeadTab:
    """Build the tab."""
    return HeadTab(services)
