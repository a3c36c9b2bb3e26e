"""The button Certificate on the results pages hands over what is on them."""

from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.certificates.measured import Measured
from gui.accuracy.tab import AccuracyTab
from gui.dividing_head.tab import HeadTab
from gui.measuring.tab import MeasuringTab
from gui.rate_table.tab import RateTab
from gui.services import Services
from tests.gui.certificate.conftest import CHECK, SPECIMENS, TRIAD


@pytest.mark.parametrize(
    ("kind", "path", "sensor"),
    [
        (HeadTab, TRIAD, "accelerometer"),
        (RateTab, SPECIMENS / "RotationTable_202405151000.txt", "gyro"),
        (AccuracyTab, CHECK, ""),
    ],
)
def test_a_results_page_is_handed_over(
    kind: type[MeasuringTab],
    path: Path,
    sensor: str,
    services: Services,
    qtbot: QtBot,
):
    given: list[Measured] = []
    tab = kind(replace(services, certify=given.append))
    qtbot.addWidget(tab.widget)
    tab.widget.resize(1280, 760)
    tab.widget.show()
    assert tab.results.measured is None
    tab.load(path)
    button = tab.view.results.certificate
    qtbot.waitUntil(button.isVisible, timeout=20_000)
    button.click()
    (measured,) = given
    calibration = measured.calibration
    assert ("" if calibration is None else calibration.sensor) == sensor
    assert len(measured.printed) >= 2
    assert measured.coverage
    assert (measured.conformity is not None) is (kind is AccuracyTab)
    tab.close()
