"""No word of the window is cut, in any language, on the smallest screen with the rig beside."""

from collections.abc import Callable

import pytest
from pytestqt.qtbot import QtBot

from gui.languages.choice import LANGUAGES
from gui.widgets.device_strip import DeviceStrip
from gui.widgets.states import DeviceStripState, LinkMark
from tests.gui.languages.cut_words import cut_words
from tests.gui.window_driver import Driver


def settled(operator: Driver) -> list[str]:
    """What is cut once the window has laid itself out anew."""
    cut: list[str] = []
    for _ in range(20):
        operator.bot.wait(20)
        cut = list(cut_words(operator.app.window))
        if not cut:
            break
    return cut


def test_every_tab_has_room_for_its_words(open_app: Callable[[], Driver]):
    operator = open_app()
    app, window = operator.app, operator.app.window
    app.open_simulated("sim://pointer?speed=1&seed=3&name=words")
    operator.until(lambda: operator.tab.bench.linked)
    window.resize(1280, 800)
    cut: set[str] = set()
    for language in LANGUAGES:
        window.menu.languages[language].trigger()
        for title, tab in app.tabs.items():
            window.tabs.setCurrentWidget(tab.widget)
            cut |= {f"{language}, {title}: {one}" for one in settled(operator)}
        for toggle in (window.toggle_devices, window.toggle_preferences):
            toggle()
            cut |= {f"{language}, {toggle.__name__}: {one}" for one in settled(operator)}
            toggle()
    window.menu.languages["en"].trigger()
    assert sorted(cut) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_busy_device_strip_cuts_nothing_beside_the_rig(language: str, qtbot: QtBot, speaking):
    speaking(language)
    strip = DeviceStrip()
    qtbot.addWidget(strip)
    strip.resize(1008, strip.sizeHint().height())
    strip.show()
    state = DeviceStripState(
        devices=("CVG25 No. 1234", "PW09"),
        current=0,
        port="/dev/ttyUSB0",
        baud=921600,
        link=LinkMark.STREAMING,
        rate_hz=2000.2,
        frames=123_456_789,
        received_bytes=12_345_678_901,
        bad_checksum=12_345,
        lost=12_345,
        garbage=1_234_567,
        temperature_c=26.1,
    )
    for _ in range(2):
        strip.render(state)
        qtbot.wait(20)
    assert list(cut_words(strip)) == []


def test_what_is_cut_is_found(qtbot: QtBot):
    strip = DeviceStrip()
    qtbot.addWidget(strip)
    strip.show()
    assert list(cut_words(strip)) == []
    strip.setFixedWidth(150)
    qtbot.wait(20)
    assert len(list(cut_words(strip))) > 2
