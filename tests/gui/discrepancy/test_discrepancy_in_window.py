"""From a page of results through the comparison and back, in the real window."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication

from core.records.calibration_json import read_calibration
from core.records.run_file import write_run
from gui.discrepancy.tab import TITLE, DiscrepancyTab
from gui.measuring.bending import BendingResults
from gui.measuring.tab import MeasuringTab
from tests.core.procedures.bent_triad import K2_X, bent_run
from tests.core.procedures.test_added import table_run
from tests.gui.window_driver import Driver

_LONG = 60_000


def _explained(driver: Driver, title: str, path: Path) -> tuple[MeasuringTab, DiscrepancyTab]:
    """Load a file in a measuring tab, and ask its page why the model is rejected."""
    tab = driver.app.tabs[title]
    assert isinstance(tab, MeasuringTab)
    driver.app.window.tabs.setCurrentWidget(tab.widget)
    tab.load(path)
    driver.until(lambda: tab.results.page is not None, _LONG)
    # The page gets its room when the window lays itself out.
    driver.until(lambda: tab.view.results.explain.isVisible() and tab.view.results.width() > 300)
    driver.click(tab.view.results.explain)
    other = driver.app.tabs[TITLE]
    assert isinstance(other, DiscrepancyTab)
    assert driver.app.window.tabs.currentWidget() is other.widget
    driver.until(lambda: other.presenter.story is not None, _LONG)
    assert other.presenter.story is not None
    assert other.presenter.story.paths == (path,)
    driver.until(lambda: bool(other.presenter.state.proposals), _LONG)
    driver.until(lambda: not other.presenter.state.busy, _LONG)
    return tab, other


def _effects(tab: MeasuringTab) -> list[str]:
    assert isinstance(tab.results, BendingResults)
    page = tab.results.page
    return [] if page is None else list(page.effects)


@pytest.mark.timeout(240)
def test_what_is_added_goes_into_the_calibration_of_the_head_and_out_again(
    open_app: "Callable[[], Driver]", tmp_path: Path
):
    driver = open_app()
    path = tmp_path / "bent.run.csv"
    write_run(bent_run(noise=0.5), path)
    head, story = _explained(driver, "Dividing head", path)
    assert _effects(head) == []

    story.presenter.choose("second_order_nonlinearity")
    driver.click(story.view.action_bar.button("add"))
    driver.until(lambda: bool(_effects(head)), _LONG)
    assert _effects(head) == ["Second-order nonlinearity K2: acc_x"]
    driver.until(lambda: not story.presenter.state.busy, _LONG)
    driver.click(story.view.action_bar.button("all"))
    driver.until(lambda: len(_effects(head)) == 2, _LONG)

    assert driver.app.window.tabs.currentWidget() is story.widget
    driver.click(story.view.action_bar.button("calibrate"))
    assert driver.app.window.tabs.currentWidget() is head.widget
    driver.until(lambda: not head.results.busy, _LONG)
    assert head.view.results.take_out.isVisible()
    exported = tmp_path / "bent.cal.json"
    head.exporting.export("json", str(exported))
    driver.until(exported.exists)
    calibration = read_calibration(exported)
    x = calibration.channels.index("acc_x")
    assert calibration.effects[x][0].effect == "second_order_nonlinearity"
    fit = calibration.fits[x]
    assert abs(fit.value("second_order") - K2_X) < 4.0 * fit.u("second_order")

    driver.click(head.view.results.take_out)
    driver.until(lambda: _effects(head) == [] and not head.results.busy, _LONG)
    assert not head.view.results.take_out.isVisible()
    driver.app.window.tabs.setCurrentWidget(story.widget)
    driver.click(story.view.action_bar.button("undo"))
    driver.until(lambda: len(_effects(head)) == 1, _LONG)
    assert QApplication.activeModalWidget() is None


@pytest.mark.timeout(240)
def test_a_page_of_the_rate_table_follows_too(open_app: "Callable[[], Driver]", tmp_path: Path):
    driver = open_app()
    path = tmp_path / "table.run.csv"
    write_run(table_run(800.0), path)
    table, story = _explained(driver, "Rate table", path)
    assert story.presenter.state.proposals
    story.presenter.choose("scale_factor_asymmetry")
    driver.click(story.view.action_bar.button("add"))
    driver.until(lambda: bool(_effects(table)), _LONG)
    assert _effects(table) == ["Scale-factor asymmetry: gyro_z"]
    driver.until(lambda: not story.presenter.state.busy, _LONG)
    driver.click(story.view.action_bar.button("undo"))
    driver.until(lambda: not _effects(table), _LONG)
