"""A board nobody has seen is brought to live charts by an operator at the window."""

import time

import numpy as np
import pytest

from drivers.profile import load_profile
from gui.live.tab import LiveTab
from tests.gui.frames.board import Board
from tests.gui.frames.conftest import Operator


def test_an_unknown_board_comes_to_live_charts(operator: Operator, board: Board):
    view, presenter = operator.tab.view, operator.tab.presenter
    operator.type(view.source.port.lineEdit(), board.port)
    operator.click(view.source.listen)
    # The layout is found by itself.
    operator.until(lambda: presenter.state.sure)
    state = presenter.state
    assert (state.sync, state.length) == ("9C D1 2E", board.layout.length)
    assert "poly 0xA097" in state.checks[state.check]
    # What was proposed is taken away and pointed at again, to see that hands can do it.
    operator.drag(4, 12)
    operator.click(view.fields.form.remove)
    assert len(presenter.state.fields) == 2
    operator.drag(4, 12)
    operator.click(view.fields.form.add)
    assert [row.type for row in presenter.state.fields[1:4]] == ["i24"] * 3
    operator.until(lambda: len(presenter.readings.live) == 5)
    for place, axis in enumerate("xyz", start=1):
        view.fields.table.selectRow(place)
        form = view.fields.form
        operator.type(form.name, f"acc_{axis}")
        operator.type(form.scale, "9.8/2**20")
        operator.type(form.unit.lineEdit(), "m/s^2")
        operator.type(form.role.lineEdit(), f"acc.{axis}")
    operator.bot.keyClicks(view.definition.name, "Strange board")
    assert presenter.state.doubt == ""
    operator.until(lambda: presenter.state.hz > 0.0)
    operator.click(view.definition.use)
    # From here on it is a device like any other.
    link = operator.app.connection.link
    assert link is not None
    assert link.profile.id == "strange_board"
    operator.show("Live")
    live = operator.app.tabs["Live"]
    assert isinstance(live, LiveTab)
    operator.until(lambda: link.counters.frames > 100)
    assert link.counters.bad_checksum == 0
    assert [channel.name for channel in live.presenter.trace.channels][:3] == [
        "acc_x", "acc_y", "acc_z"
    ]  # fmt: skip
    operator.until(lambda: live.presenter.trace.history.end > 50)
    profile = load_profile(operator.app._root / "devices" / "strange_board.toml")
    assert profile.nominal_hz == pytest.approx(200.0, rel=0.03)
    assert profile.stream.counter.step == 1
    rows = [row.role for row in presenter.state.fields]
    assert rows == ["counter", "acc.x", "acc.y", "acc.z", ""]
    # Device Properties has it too.
    operator.app.devices.refresh()
    assert ("strange_board", "Strange board") in operator.app.devices.state.profiles


def test_a_tick_costs_the_window_little(operator: Operator, board: Board):
    view, presenter = operator.tab.view, operator.tab.presenter
    operator.type(view.source.port.lineEdit(), board.port)
    operator.click(view.source.listen)
    operator.until(lambda: presenter.state.sure)
    spent = []
    for _ in range(20):
        begun = time.process_time()
        operator.tab.source.tick()
        view.bytes.viewport().grab()
        spent.append(time.process_time() - begun)
    assert np.median(spent) < 0.1
