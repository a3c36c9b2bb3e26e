"""The rate table's part of the demonstration: eleven rates, four positions, the whole model."""

from dataclasses import replace

from drivers.virtual.truth import compare
from gui.measuring.demonstrating import Stage, Told, process, walk
from gui.rate_table.tab import RateTab

TITLE = "Rate table"
_ACCUMULATION_S = 8.0
_LATITUDE_DEG = 50.45


def play(stage: Stage) -> Told:
    """Measure nine gyros on the table and on the head, and compare with the rig's truth."""
    rig = stage.connect("clbdus")
    tab = stage.show(TITLE)
    if not isinstance(tab, RateTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    stage.until(lambda: tab.sitting.walk.status is not None, "the rig did not answer")
    _prepare(tab, "rate_table_100")
    session = walk(stage, tab, "rate-table-measuring")
    process(stage, tab, "rate-table-results", ("csv", "legacy rotation_table"))
    tab.presenter.new_session()
    _prepare(tab, "g_sensitivity_4")
    walk(stage, tab)
    process(stage, tab, "rate-table-and-head", ("json",))
    state = tab.results.state
    if state is None:
        raise RuntimeError("the results were closed")
    return Told(TITLE, compare(state.calibration, rig), session)


def _prepare(tab: RateTab, plan_id: str) -> None:
    """Take a plan, a short time, and the latitude of the rig."""
    tab.presenter.set_plan(plan_id)
    settings = tab.sitting.settings
    tab.presenter.set_settings(
        replace(settings, accumulation_s=_ACCUMULATION_S, latitude_deg=_LATITUDE_DEG)
    )
