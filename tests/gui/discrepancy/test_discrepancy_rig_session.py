"""A hidden effect of the simulated rig, from the measured session to the closed gap."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.samples.run import Conditions
from drivers.virtual.session import Order, simulate_session
from gui.discrepancy.demo import EFFECT, ROLE, SIZE, mixed_twice
from gui.discrepancy.tab import DiscrepancyTab


@pytest.mark.timeout(240)
def test_the_hidden_effect_is_named_and_the_gap_closes(
    qtbot: QtBot, tab: DiscrepancyTab, tmp_path: Path
):
    url = f"sim://pointer?speed=max&seed=4&name={tmp_path.name}&effect={ROLE}/{EFFECT}:{SIZE}"
    order = Order(url, mixed_twice(), "accelerometer", Conditions(g_mps2=9.8106))
    simulate_session(order, tmp_path / "session")
    tab.load(tmp_path / "session")
    qtbot.waitUntil(lambda: bool(tab.presenter.state.proposals), timeout=90_000)
    qtbot.waitUntil(lambda: not tab.presenter.state.busy, timeout=90_000)
    keys = [row.key for card in tab.presenter.state.proposals for row in card.tied]
    assert EFFECT in keys
    qtbot.mouseClick(tab.view.action_bar.button("all"), Qt.MouseButton.LeftButton)
    state = tab.presenter.state
    assert not any(rung.proposed for rung in state.rungs)
    assert state.rungs[0].gap > 3.0
    assert state.rungs[-1].gap < 1.3
