from dataclasses import replace

import pytest
from PySide6.QtCore import Qt

from gui.widgets.device_strip import DeviceStrip
from gui.widgets.states import DeviceStripState, LinkMark

STATE = DeviceStripState(
    ("PW09", "ADXRS610"),
    0,
    "COM4",
    115200,
    LinkMark.STREAMING,
    200.0,
    frames=12480,
    received_bytes=599040,
    temperature_c=26.13,
)


@pytest.fixture
def strip(qtbot):
    widget = DeviceStrip()
    qtbot.addWidget(widget)
    widget.resize(1280, 40)
    widget.show()
    widget.render(STATE)
    return widget


def test_line_of_the_design(strip):
    assert strip._device.currentText() == "PW09"
    assert strip._port.text() == "COM4 115200"
    assert strip._link.text().startswith("streaming  200")
    assert strip._counters["frames"]._number.text() == "12\N{NARROW NO-BREAK SPACE}480"
    assert strip._temperature.text().endswith("°C")


def test_faults_get_a_sign_not_only_a_colour(strip):
    assert not strip._counters["lost"]._sign.isVisible()
    strip.render(replace(STATE, lost=3, frames=12483))
    assert strip._counters["lost"]._sign.isVisible()
    assert not strip._counters["frames"]._sign.isVisible()
    strip.render(STATE)
    assert not strip._counters["lost"]._sign.isVisible()


def test_numbers_do_not_shake_the_row(strip):
    strip.render(replace(STATE, frames=1_000_000))
    wide = strip._counters["frames"]._number.minimumWidth()
    strip.render(replace(STATE, frames=1))
    assert strip._counters["frames"]._number.minimumWidth() == wide


@pytest.mark.parametrize("link", list(LinkMark))
def test_every_link_state_has_words(strip, link):
    strip.render(replace(STATE, link=link))
    assert strip._link.text()
    assert not strip.grab().isNull()


def test_no_device(strip):
    strip.render(DeviceStripState())
    assert not strip._device.isVisible()
    assert not strip._temperature.isVisible()
    assert strip._link.text() == "not connected"


def test_signals(strip, qtbot):
    with qtbot.waitSignal(strip.properties_requested):
        qtbot.mouseClick(strip._properties, Qt.MouseButton.LeftButton)
    chosen = []
    strip.device_chosen.connect(chosen.append)
    qtbot.keyClick(strip._device, Qt.Key.Key_Down)
    assert chosen == [1]


def test_where_it_is_narrow_counters_give_way_and_the_rate_keeps_its_unit(strip):
    wide = [not counter.isHidden() for counter in strip._counters.values()]
    assert all(wide)
    strip.resize(760, 40)
    shown = {name for name, counter in strip._counters.items() if not counter.isHidden()}
    assert {"bad_checksum", "lost", "garbage"} <= shown
    assert "received_bytes" not in shown
    text = strip._link.text()
    assert strip._link.width() >= strip._link.fontMetrics().horizontalAdvance(text)
    strip.resize(1280, 40)
    assert not any(counter.isHidden() for counter in strip._counters.values())
