"""A cycle that the dividing head measured, handed over by its folder."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.plans.plan import load_plans
from core.records.run_file import write_run
from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_session
from gui.thermal.tab import ThermalTab
from gui.thermal.working import CycleOutcome
from tests.gui.thermal.conftest import cycle

TEMPERATURES = (27.0, -10.0, 27.0, 50.0, 27.0)


def measure(folder: Path) -> None:
    plan = replace(
        load_plans()["thermal_8"],
        accumulation_s=0.5,
        settle_s=0.5,
        temperatures_c=TEMPERATURES,
    )
    url = "sim://pointer?speed=max&name=thermal"
    simulate_session(Order(url, plan, "accelerometer", Conditions(g_mps2=9.8106)), folder)


@pytest.mark.timeout(240)
def test_the_last_cycle_is_one_key_away(tab: ThermalTab, qtbot: QtBot, tmp_path: Path) -> None:
    measure(tmp_path / "20260101_1000_PW09_thermal_8")
    qtbot.mouseClick(tab.view.page.action_bar.button("last"), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: tab.library.result is not None, timeout=20_000)
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    assert len(outcome.run) == 8 * len(TEMPERATURES)
    assert not outcome.assumed
    assert [one.axis for one in outcome.thermal.channels] == ["x", "y", "z"]
    assert {round(one.temperature_c) for one in outcome.thermal.channels[0].hysteresis} == {27}
    assert len(outcome.splits) == len(TEMPERATURES)
    assert outcome.tilt is not None
    assert len(tab.view.plots.plots) == 3


def test_an_assembly_of_nine_sensors_is_no_triad(
    tab: ThermalTab, qtbot: QtBot, tmp_path: Path
) -> None:
    run = cycle()
    nine = replace(
        run,
        y=np.hstack([run.y] * 3),
        y_se=np.hstack([run.y_se] * 3),
        channels=tuple(f"{block}{axis}" for block in "123" for axis in "xyz"),
        axes=run.axes * 3,
    )
    write_run(nine, tmp_path / "assembly.run.csv")
    tab.load(tmp_path / "assembly.run.csv")
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    assert len(outcome.thermal.channels) == 9
    assert outcome.tilt is None
    assert outcome.splits == ()
    plots = tab.view.plots
    assert len(plots.plots) == 9
    # They are looked through, not squeezed.
    assert plots.plots[8].height() > 8 * plots.fontMetrics().height()
