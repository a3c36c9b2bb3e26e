"""The export of an analysis: the formats under its findings."""

from collections.abc import Callable, Sequence
from typing import Any

from gui.analysis.tab import AnalysisTab
from gui.exporting import ExportFormat, Exporting
from gui.services import Services
from gui.widgets.export_foot import ExportFoot

SOURCE = "export"


def export_under(
    foot: ExportFoot,
    formats: Sequence[ExportFormat],
    current: Callable[[], Any],
    services: Services,
    tab: AnalysisTab,
) -> Exporting:
    """Offer formats under results, and write what is asked for.

    Parameters
    ----------
    current : returns what is on the page, None for nothing
    tab : keeps it
    """
    exporting = Exporting(
        SOURCE, formats, current, services.root, services.jobs, services.messages, tab
    )
    exporting.serve(foot)
    return exporting
