import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from core.errors import Severity
from gui.widgets.banner import Banner
from gui.widgets.states import BannerAction, BannerState

STATE = BannerState(
    Severity.WARNING,
    "This looks like position 3, not 4",
    "Nothing has been recorded.",
    "Turn the head to 270°.",
    (BannerAction("take", "Take as position 3"), BannerAction("again", "Measure again")),
)


@pytest.fixture
def banner(qtbot):
    widget = Banner()
    qtbot.addWidget(widget)
    widget.resize(800, 60)
    widget.show()
    widget.render(STATE)
    return widget


def test_no_state_no_banner(banner):
    assert banner.isVisible()
    banner.render(None)
    assert not banner.isVisible()


def test_buttons_tell_their_key(banner, qtbot):
    pressed = []
    banner.action.connect(pressed.append)
    buttons = [b for b in banner.findChildren(QPushButton) if b.isVisible()]
    assert [b.text() for b in buttons] == ["Take as position 3", "Measure again"]
    for button in buttons:
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert pressed == ["take", "again"]


def test_close_and_escape(banner, qtbot):
    with qtbot.waitSignal(banner.closed):
        qtbot.keyClick(banner, Qt.Key.Key_Escape)
    assert not banner.isVisible()
    banner.render(STATE)
    assert banner.isVisible()
    with qtbot.waitSignal(banner.closed):
        qtbot.mouseClick(banner._close, Qt.MouseButton.LeftButton)


def test_what_must_stay_cannot_be_closed(banner, qtbot):
    banner.render(BannerState(Severity.ERROR, "Disk full", closable=False))
    qtbot.keyClick(banner, Qt.Key.Key_Escape)
    assert banner.isVisible()
    assert not banner._close.isVisible()


@pytest.mark.parametrize("severity", list(Severity))
def test_every_severity_is_drawn_and_read_out(banner, severity):
    banner.render(BannerState(severity, "What", "Meaning.", "Remedy."))
    assert not banner.grab().isNull()
    assert banner.accessibleName() == "What"
    assert banner.accessibleDescription() == "Meaning. Remedy."
