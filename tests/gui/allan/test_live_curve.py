"""The curve of the running device grows, whatever the portions, and knows of lost samples."""

import time
from collections.abc import Iterator

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.allan.deviation import overlapping
from core.arrays import frozen, frozen_int
from core.samples.block import Channel, SampleBlock
from gui.allan.live import PERIOD_MS
from gui.allan.presenter import LIVE_KEY
from gui.allan.tab import AllanTab
from gui.devices.setup import DeviceSetup
from tests.core.records.noise_records import gyro_noise

CHANNELS = (Channel("GyroOut", "deg/s", "rate.z"), Channel("Temperature", "degC", "temp"))
RATE = 100.0


@pytest.fixture
def silent(tab: AllanTab) -> Iterator[AllanTab]:
    """The tab with a device at a port; the tests say themselves what it sends."""
    connection = tab.live._connection
    connection.open([DeviceSetup("sim://cvg25?seed=2", 115200, "cvgx48", "25-143")])
    connection._timer.stop()
    yield tab
    connection.close()


def block(values: np.ndarray, first: int) -> SampleBlock:
    data = np.column_stack([values, np.full(len(values), 25.0)])
    index = np.arange(first, first + len(values))
    return SampleBlock(CHANNELS, frozen_int(index), frozen(data), RATE)


def feed(tab: AllanTab, values: np.ndarray, first: int = 0, portion: int = 700) -> None:
    for at in range(0, len(values), portion):
        tab.live._connection.blocks.emit(block(values[at : at + portion], first + at))


def test_the_curve_grows_and_equals_that_of_the_whole_record(
    silent: AllanTab, qtbot: QtBot
) -> None:
    tab = silent
    values = gyro_noise(40_000, RATE, (0.02, 0.0125, 3e-4))
    tab.view.action_bar.button("live").click()
    lengths: list[int] = []
    for part in range(4):
        feed(tab, values[part * 10_000 : (part + 1) * 10_000], part * 10_000)
        tab.live.update()
        assert tab.live.found is not None
        lengths.append(len(tab.live.found.curve.taus))
    assert lengths == sorted(lengths)
    assert lengths[-1] > lengths[0]
    curve = tab.live.found.curve
    whole = overlapping(values, RATE, m=curve.m)
    # Partial overlap scatters about full overlap by far less than the deviation itself.
    np.testing.assert_allclose(curve.deviation[:40], whole.deviation[:40], rtol=0.01)
    picture = tab.presenter.state.picture
    assert picture is not None
    assert picture.curves[-1].name == "25-143 GyroOut, live"
    qtbot.waitUntil(lambda: tab.live.found is not None and bool(tab.live.found.rows))
    n = next(row for row in tab.live.found.rows if row.symbol == "N")
    assert n.value == pytest.approx(0.02, rel=0.05)
    assert tab.presenter.state.current == LIVE_KEY


def test_the_timer_draws_about_once_a_second(silent: AllanTab, qtbot: QtBot) -> None:
    silent.presenter.start_live()
    feed(silent, gyro_noise(2000, RATE, (0.02, 0.0, 0.0)))
    assert silent.live.found is None
    qtbot.waitUntil(lambda: silent.live.found is not None, timeout=3 * PERIOD_MS)


def test_lost_samples_are_no_difference(silent: AllanTab) -> None:
    values = np.random.default_rng(5).normal(size=4000)
    silent.presenter.start_live()
    feed(silent, values[:2000])
    feed(silent, values[2000:] + 1000.0, 2500)
    silent.live.update()
    assert silent.live.found is not None
    curve = silent.live.found.curve
    assert curve.deviation.max() < 2.0
    assert any(note.subject == "gaps" for note in curve.notes)


def test_a_stuck_channel_is_said(silent: AllanTab) -> None:
    silent.presenter.start_live()
    feed(silent, np.full(3000, 7.0))
    silent.live.update()
    assert silent.live.found is None
    assert "stuck" in silent.presenter.state.rows[0].detail
    assert "stuck" in silent.view.hint.text()


def test_stop_keeps_the_curve_and_remove_takes_it(silent: AllanTab) -> None:
    silent.presenter.act("live")
    feed(silent, np.random.default_rng(5).normal(size=3000))
    silent.presenter.act("stop")
    assert not silent.live.running
    assert silent.presenter.state.picture is not None
    feed(silent, np.ones(3000), 3000)
    assert silent.live.count == 3000
    silent.presenter.act("remove")
    assert silent.presenter.state.rows == ()


def test_the_cost_of_an_update_does_not_grow_with_the_record(silent: AllanTab) -> None:
    rng = np.random.default_rng(1)
    silent.presenter.start_live()

    def fed(samples: int) -> tuple[int, float]:
        """Points of the curve after so many samples, and the best time of an update."""
        first = silent.live.count
        for at in range(0, samples, 100_000):
            silent.live._connection.blocks.emit(block(rng.normal(size=100_000), first + at))
        allan = silent.live._allan
        assert allan is not None
        times: list[float] = []
        for _ in range(5):
            begin = time.perf_counter()
            curve = allan.curve()
            times.append(time.perf_counter() - begin)
        return len(curve.taus), min(times)

    early, _ = fed(200_000)
    late, seconds = fed(3_000_000)
    # Sixteen times the record are four octaves of four points each.
    assert late - early == 16
    assert seconds < 0.05
