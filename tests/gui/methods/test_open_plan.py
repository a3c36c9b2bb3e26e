"""A plan goes from the page that made it to the tab that measures it, in the real window."""

from collections.abc import Callable

from core.plans.plan import load_plans
from core.procedures.prediction.propose import with_positions
from gui.measuring.tab import MeasuringTab
from gui.methods.tab import MethodsTab
from tests.gui.window_driver import Driver


def test_the_tab_of_the_test_takes_the_plan_and_comes_to_the_front(
    open_app: Callable[[], Driver],
):
    app = open_app().app
    methods = app.tabs["Methods"]
    assert isinstance(methods, MethodsTab)
    app.window.tabs.setCurrentWidget(methods.widget)
    for plan_id, title in (("pointer_16", "Dividing head"), ("rate_table_100", "Rate table")):
        own = with_positions(load_plans()[plan_id], drop=[2])
        assert methods._services.open_plan(own)
        tab = app.tabs[title]
        assert isinstance(tab, MeasuringTab)
        assert app.window.tabs.currentWidget() is tab.widget
        assert tab.sitting.plan.steps == own.steps
    assert not methods._services.open_plan(load_plans()["gyrocompass_4"])
