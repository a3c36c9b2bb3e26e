"""A whole session with the keyboard alone, on the simulated rig within the program."""

from collections.abc import Callable

from PySide6.QtCore import Qt

from drivers.virtual.address import rig_of
from drivers.virtual.rig import Rig
from tests.gui.window_driver import Driver

CONTROL = Qt.KeyboardModifier.ControlModifier


def test_space_backspace_escape_arrows_and_digits(open_app: Callable[[], Driver]):
    operator, rig = _connected(open_app)
    walk = operator.tab.sitting.walk

    # Space starts; Space in mid-accumulation does not stop it; Esc does.
    _stand(operator, rig)
    operator.key(Qt.Key.Key_Space)
    operator.until(lambda: walk.measuring)
    operator.key(Qt.Key.Key_Space)
    assert walk.measuring
    operator.key(Qt.Key.Key_Escape)
    assert not walk.measuring
    assert operator.count == 0
    _measure(operator, rig)
    assert operator.step.number == 2

    # Backspace measures the last position again, instead of what it gave.
    operator.key(Qt.Key.Key_Backspace)
    operator.until(lambda: walk.measuring)
    operator.until(lambda: not walk.measuring)
    kept = operator.tab.sitting.keeper.positions
    assert [(p.step.number, p.attempt) for p in kept] == [(1, 2)]

    # Ctrl+Z takes the repeat back: the first attempt counts again.
    operator.key(Qt.Key.Key_Z, CONTROL)
    kept = operator.tab.sitting.keeper.positions
    assert [(p.step.number, p.attempt) for p in kept] == [(1, 1)]

    # A digit picks a position, arrows and Enter do too.
    operator.key(Qt.Key.Key_3)
    assert operator.step.number == 3
    operator.key(Qt.Key.Key_Down)
    assert operator.step.number == 3
    operator.key(Qt.Key.Key_Return)
    assert operator.step.number == 4
    _measure(operator, rig)

    # Delete discards the last; Ctrl+Z brings it back.
    operator.key(Qt.Key.Key_Delete)
    assert operator.count == 1
    operator.key(Qt.Key.Key_Z, CONTROL)
    assert operator.count == 2

    # Ctrl+H goes hands-free: turning the head is enough.
    operator.key(Qt.Key.Key_H, CONTROL)
    while operator.count < 8:
        before = operator.count
        _stand(operator, rig)
        operator.until(lambda before=before: operator.count > before)
    operator.key(Qt.Key.Key_F5)
    operator.until(lambda: operator.tab.results.state is not None)


def _connected(open_app: Callable[[], Driver]) -> tuple[Driver, Rig]:
    url = "sim://pointer?speed=20&seed=8&name=keyboard"
    operator = open_app()
    operator.app.open_simulated(url)
    operator.until(lambda: operator.tab.bench.linked)
    rig = rig_of(url)
    return operator, rig


def _stand(operator: Driver, rig: Rig) -> None:
    """Turn the rig to the current step and wait until it rests there."""
    step = operator.step
    rig.remount(step.mount)
    rig.turn(step.head_deg)
    operator.bot.wait(50)
    operator.until(lambda: not rig.state.moving)
    operator.bot.wait(150)


def _measure(operator: Driver, rig: Rig) -> None:
    before = operator.count
    _stand(operator, rig)
    operator.key(Qt.Key.Key_Space)
    operator.until(lambda: operator.count == before + 1)
