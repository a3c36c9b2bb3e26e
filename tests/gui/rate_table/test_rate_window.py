"""The real window with the rate-table tab: eleven rates on the simulated rig, files, refusals."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.procedures.measuring import Phase
from core.records.calibration_json import read_calibration
from core.records.open import read_any
from drivers.virtual.address import rig_of
from gui.measuring.results_view import ResultsView
from gui.rate_table.tab import RateTab
from tests.gui.window_driver import Driver

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
TABLE_3_2 = LEGACY / "RotationTable_202405151000.txt"
TABLE_3_3 = LEGACY / "OpticalDividingHead_202405151045.txt"
RATES = list(range(-100, 101, 20))


@pytest.fixture
def window(open_app: Callable[[], Driver]) -> Driver:
    driver = open_app()
    driver.app.window.tabs.setCurrentWidget(driver.app.tabs["Rate table"].widget)
    return driver


def rate_tab(driver: Driver) -> RateTab:
    tab = driver.app.tabs["Rate table"]
    assert isinstance(tab, RateTab)
    return tab


@pytest.mark.timeout(240)
def test_eleven_rates_hands_free_to_an_exported_calibration(
    window: Driver, tmp_path: Path, qtbot: QtBot
):
    tab = rate_tab(window)
    url = f"sim://clbdus?speed=40&seed=3&name={tmp_path.name}"
    window.app.open_simulated(url)
    window.until(lambda: tab.bench.linked)
    assert tab.presenter.state.settings.plan_id == "rate_table_100"
    settings = tab.sitting.settings
    tab.presenter.set_settings(replace(settings, accumulation_s=6.0, whole_turns=False))
    window.app.rig.set_operator(True)
    window.click(tab.view.action_bar._hands_free)
    assert tab.sitting.settings.hands_free

    def finished() -> bool:
        status = tab.sitting.walk.status
        return status is not None and status.phase is Phase.FINISHED

    window.until(finished, 120_000)
    assert [p.step.rate_dps for p in tab.sitting.keeper.positions] == RATES
    window.click(tab.view.action_bar.button("process"))
    window.until(lambda: tab.results.state is not None)
    state = tab.results.state
    assert state is not None
    hidden = {output.role: output for output in rig_of(url).truth()}
    for name, fit in zip(state.calibration.channels, state.calibration.fits, strict=True):
        truth = hidden[f"adc.{name.rpartition('_')[2]}"].value("scale_factor")
        half = fit.expanded()[fit.index("scale_factor")]
        # Four half widths: the drift of the rig between accumulations is not in the stated errors.
        assert abs(fit.value("scale_factor") - truth) < 4.0 * half
    assert isinstance(tab.view.results, ResultsView)
    assert tab.view.results.isVisible()
    for key in ("json", "legacy rotation_table"):
        name = tab.exporting.propose(key)
        tab.exporting.export(key, name)
        window.until(Path(name).exists)
    (exported,) = {p.name for p in Path(tab.presenter.state.folder).glob("Gyro31_gyro.cal.json")}
    found = read_calibration(Path(tab.presenter.state.folder) / exported)
    assert (found.sensor, len(found.fits)) == ("gyro", 9)
    legacy = Path(tab.exporting.propose("legacy rotation_table"))
    assert read_any(legacy).set_rate_dps.tolist() == RATES


def load(tab: RateTab, path: Path, qtbot: QtBot) -> None:
    tab.load(path)
    qtbot.waitUntil(lambda: not tab.results.busy, timeout=10_000)


def cells(tab: RateTab) -> list[str]:
    page = tab.results.page
    assert page is not None
    return [cell for table in page.tables for row in table.rows for cell in row]


def test_table_3_2_is_loaded_and_its_straight_line_is_rejected(window: Driver, qtbot: QtBot):
    tab = rate_tab(window)
    load(tab, TABLE_3_2, qtbot)
    state = tab.results.state
    assert state is not None
    fit = state.calibration.fits[0]
    np.testing.assert_allclose(fit.value("scale_factor"), -79.378668, rtol=1e-7)
    np.testing.assert_allclose(fit.value("bias"), -438.08364, rtol=1e-7)
    assert "rejected, p = 0.001" in cells(tab)
    assert any("the straight line is rejected" in note.text for note in state.page.notes)


def test_files_of_two_units_are_refused_together_until_the_operator_insists(
    window: Driver, qtbot: QtBot
):
    tab = rate_tab(window)
    load(tab, TABLE_3_2, qtbot)
    load(tab, TABLE_3_3, qtbot)
    banner = window.app.messages.current
    assert banner is not None
    assert banner.what == "Table and head run are of two units"
    assert "'ADXRS610'" in banner.meaning
    assert "'Gyro31'" in banner.meaning
    assert not any("3.10" in cell for cell in cells(tab))
    page = tab.results.page
    assert page is not None
    assert not any("Table 3.7" in table.title for table in page.tables)
    window.answer("They are one unit")
    window.until(lambda: tab.results.page is not page)
    again = tab.results.page
    assert again is not None
    (table,) = (table for table in again.tables if "Table 3.7" in table.title)
    errors = [float(row[3].replace("\N{MINUS SIGN}", "-")) for row in table.rows]
    assert np.mean(errors) == pytest.approx(-3.5, abs=0.1)
    assert any("puts -3.5" in note.text for note in again.notes)


def test_switching_to_the_tab_is_quick(window: Driver, qtbot: QtBot):
    import time

    tabs = window.app.window.tabs
    tab = rate_tab(window)
    load(tab, TABLE_3_2, qtbot)
    took: list[float] = []
    for _ in range(5):
        for title in ("Dividing head", "Rate table"):
            begin = time.thread_time()
            tabs.setCurrentWidget(window.app.tabs[title].widget)
            qtbot.wait(1)
            took.append(time.thread_time() - begin)
    assert sorted(took)[len(took) // 2] < 0.05


def test_only_one_tab_measures_hands_free(window: Driver, tmp_path: Path):
    tab = rate_tab(window)
    window.app.open_simulated(f"sim://pointer?speed=20&name={tmp_path.name}")
    window.until(lambda: tab.bench.linked and window.tab.bench.linked)
    window.tab.presenter.set_hands_free(True)
    assert window.tab.sitting.settings.hands_free
    tab.presenter.set_hands_free(True)
    assert tab.sitting.settings.hands_free
    assert not window.tab.sitting.settings.hands_free
    assert not window.tab.presenter.state.actions.hands_free
