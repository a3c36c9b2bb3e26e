"""Long use: a binding that loses one reference a call dies here and not at the operator's."""

import sys

import numpy as np
from PySide6.QtCore import QPointF, QSize
from PySide6.QtGui import QImage, QPainter

from core.samples.block import Channel
from gui.widgets.device_strip import DeviceStrip
from gui.widgets.history import History
from gui.widgets.stage import Stage
from gui.widgets.states import DeviceStripState, LinkMark, Pose, StageState, Tone
from gui.widgets.strip_charts import StripCharts

CALLS = 100_000


def test_void_calls_lose_no_reference_to_none(qapp):
    image = QImage(QSize(8, 8), QImage.Format.Format_RGB32)
    painter = QPainter(image)
    before = sys.getrefcount(None)
    for _ in range(CALLS):
        painter.drawPoint(QPointF(1, 1))
    painter.end()
    assert sys.getrefcount(None) >= before - 100


def test_an_hour_of_frames_in_little(qapp, qtbot):
    """2000 frames of strip, stage and charts: some 1e5 calls of Qt through our own code."""
    charts, stage, strip = StripCharts(), Stage(), DeviceStrip()
    for widget in (charts, stage, strip):
        qtbot.addWidget(widget)
        widget.resize(500, 250)
        widget.show()
    channels = tuple(Channel(f"c{number}") for number in range(3))
    history = History(channels, 1000.0)
    charts.set_history(history)
    charts.track(2.0)
    rng = np.random.default_rng(1)
    for frame in range(2000):
        history.append(np.arange(33) + history.end, rng.normal(size=(33, 3)))
        charts.refresh()
        share = frame % 100 / 100
        stage.render(
            StageState("Measuring", "", Tone.BUSY, share, 10 - 10 * share, Pose("X_from", frame))
        )
        strip.render(
            DeviceStripState(("PW09",), 0, "sim://", 0, LinkMark.STREAMING, 1000.0, 33 * frame)
        )
        if frame % 4 == 0:
            qapp.processEvents()
    assert history.end == 66_000
    assert strip.accessibleName().startswith("PW09")
