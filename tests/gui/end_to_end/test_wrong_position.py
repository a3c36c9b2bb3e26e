"""The head stands elsewhere than the list says."""

from collections.abc import Callable

from PySide6.QtCore import Qt

from drivers.virtual.pty_process import PtyProcess
from tests.gui.window_driver import Driver


def test_nothing_is_recorded_under_the_wrong_number(
    rig: PtyProcess, open_app: Callable[[], Driver]
):
    operator = open_app()
    operator.connect(rig.port)
    for _ in range(4):
        operator.measure(rig)
    # Position 13 is wanted, the unit re-mounted with Y along the shaft; somebody turned the head.
    assert operator.step.number == 13
    operator.set_head(rig, operator.tab.sitting.plan.step(2))
    operator.press("accumulate")
    operator.until(lambda: operator.tab.taking.pending is not None)
    assert operator.count == 4
    assert operator.tab.presenter.state.stage.headline == "Wrong position"
    banner = operator.app.messages.current
    assert banner is not None
    assert [action.text for action in banner.actions] == [
        "Accept as position 2",
        "Repeat",
        "Take it anyway",
    ]
    operator.answer("Accept as position 2")
    assert operator.count == 5
    last = operator.tab.sitting.keeper.last
    assert last is not None
    assert last.step.number == 2
    assert any(note.subject == "taken_anyway" for note in last.accumulation.notes)
    assert operator.app.messages.current is None

    # It is one of two measurements of position 2 now; what is taken back no longer counts.
    assert operator.tab.presenter.state.steps[1].replicates == 2
    operator.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert operator.count == 4
    assert operator.tab.presenter.state.steps[1].replicates == 1
