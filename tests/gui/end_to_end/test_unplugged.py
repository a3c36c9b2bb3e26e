"""The cable is pulled in mid-accumulation."""

from collections.abc import Callable

from drivers.virtual.pty_process import PtyProcess
from gui.widgets.states import LinkMark
from tests.gui.window_driver import Driver


def test_only_that_accumulation_is_lost(rig: PtyProcess, open_app: Callable[[], Driver]):
    operator = open_app()
    operator.connect(rig.port)
    operator.measure(rig)
    operator.measure(rig)
    operator.set_head(rig, operator.step)
    operator.press("accumulate")
    operator.until(lambda: operator.tab.sitting.walk.measuring)
    rig.order(unplug=True)
    operator.until(lambda: operator.tab.presenter.state.stage.headline == "Link lost")
    assert not operator.tab.sitting.walk.measuring
    assert operator.count == 2
    banner = operator.app.messages.current
    assert banner is not None
    assert banner.what.startswith("Link lost")
    link = operator.app.connection.link
    assert link is not None
    assert link.mark is LinkMark.LOST

    rig.order(plug_in=True)
    operator.until(lambda: operator.tab.bench.linked)
    operator.until(lambda: operator.app.messages.current is None)
    assert operator.step.number == 3
    operator.measure(rig)
    assert [p.step.number for p in operator.tab.sitting.keeper.positions] == [1, 2, 3]
    assert link.counters.reconnections == 1
