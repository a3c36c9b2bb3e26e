"""Pictures of every widget in both looks: ``python tests/gui/widget_gallery.py FOLDER``.

To be looked at after a change of a widget or of the table of colours.
"""

import os
import sys
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import numpy as np
from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication, QGridLayout, QVBoxLayout, QWidget

from core.arrays import frozen
from core.errors import Severity
from core.samples.block import Channel
from gui.widgets.action_bar import ActionBar
from gui.widgets.banner import Banner
from gui.widgets.device_strip import DeviceStrip
from gui.widgets.history import History
from gui.widgets.log_drawer import LogDrawer
from gui.widgets.matrix_view import MatrixView
from gui.widgets.number_text import fixed, value_and_uncertainty
from gui.widgets.plot import Plot
from gui.widgets.position_picture import PositionPicture
from gui.widgets.residual_plot import ResidualPlot
from gui.widgets.result_table import ResultTable
from gui.widgets.screenshots import save_pictures
from gui.widgets.stage import Stage
from gui.widgets.states import (
    ActionBarState,
    BannerAction,
    BannerState,
    DeviceStripState,
    LinkMark,
    LogEntry,
    MatrixState,
    Pose,
    ResidualSeries,
    ResidualState,
    StageState,
    StepMark,
    StepState,
    TableState,
    Tone,
    measuring_actions,
)
from gui.widgets.step_list import StepList
from gui.widgets.strip_charts import StripCharts
from gui.widgets.strip_view import Interval, Mark

MOUNTS = ("X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to")


def stacked(*parts: QWidget) -> QWidget:
    page = QWidget()
    layout = QVBoxLayout(page)
    for part in parts:
        layout.addWidget(part)
    return page


def positions() -> QWidget:
    page = QWidget()
    grid = QGridLayout(page)
    for row, mount in enumerate(MOUNTS):
        for column, head_deg in enumerate((0, 90, 180, 270, 45)):
            picture = PositionPicture()
            picture.setFixedSize(64, 64)
            picture.set_pose(Pose(mount, head_deg))
            grid.addWidget(picture, row, column)
    for place, pose in enumerate((Pose("X_from", 90), Pose("Z_to", 300, (10, 30, 20)))):
        picture = PositionPicture()
        picture.setFixedSize(280, 280)
        picture.set_pose(pose)
        grid.addWidget(picture, 3 * place, 5, 3, 1)
    return page


def stages() -> QWidget:
    states = (
        StageState(
            "Turn to 90°",
            "X from ODH, position 2 of 8. Turn the head, then press Space.",
            Tone.ACTION,
            pose=Pose("X_from", 90),
            next_pose=Pose("X_from", 180),
            next_label="X from ODH 180°",
        ),
        StageState("Settling", "", Tone.BUSY, 0.6, 1.2, Pose("X_from", 90)),
        StageState("Measuring", "10 s at 200.0 Hz", Tone.BUSY, 0.3, 7.0, Pose("X_from", 90)),
        StageState("Done", "Position 2 is on disk.", Tone.GOOD, pose=Pose("X_from", 90)),
        StageState("Link lost", "COM4 vanished at 12:04:11.", Tone.BAD),
        StageState("Idle", "Choose a device to begin."),
    )
    page = QWidget()
    grid = QGridLayout(page)
    for place, state in enumerate(states):
        stage = Stage()
        stage.render(state)
        grid.addWidget(stage, place // 2, place % 2)
    return page


def lines() -> QWidget:
    parts: list[QWidget] = []
    for severity in Severity:
        banner = Banner()
        banner.render(
            BannerState(
                severity,
                "This looks like position 3, not 4",
                "Nothing has been recorded under position 4.",
                "Turn the head to 270°, or take it as position 3.",
                (BannerAction("take", "Take as position 3"),),
            )
        )
        parts.append(banner)
    for link in LinkMark:
        strip = DeviceStrip()
        strip.render(
            DeviceStripState(
                ("PW09",), 0, "COM4", 115200, link, 200.0, 12480, 599040, 0, 3, 0, 26.1
            )
        )
        parts.append(strip)
    bar = ActionBar()
    bar.render(ActionBarState(measuring_actions(("accumulate", "repeat", "load")), hands_free=True))
    log = LogDrawer()
    log.append(LogEntry(datetime(2025, 11, 22, 12, 4, 11, tzinfo=UTC), Severity.INFO, "Connected."))
    log.set_open(True)
    return stacked(*parts, bar, log)


def steps() -> QWidget:
    marks = (StepMark.DONE, StepMark.NOW, StepMark.PROBLEM, StepMark.TO_COME)
    values = ("−1092.9  −77.1  12866.3", "", "looks like position 4", "")
    rows = [
        StepState(
            f"{number + 1}   {90 * (number % 4)}°",
            marks[min(number, 3)],
            Pose(MOUNTS[number // 4], 90 * (number % 4)),
            values[min(number, 3)],
            3 if number == 0 else 0,
            MOUNTS[number // 4].replace("_", " ") + " ODH",
        )
        for number in range(8)
    ]
    widget = StepList()
    widget.render(rows)
    return widget


def results() -> QWidget:
    rng = np.random.default_rng(1)
    table = ResultTable()
    table.render(
        TableState(
            "Parameters (Table 2.7)",
            "U = K·a + U0   (2.2)",
            ("Sensor", "Parameter", "Value", "±U (95 %)", "Unit", "Note"),
            (
                ("X", "U0", *value_and_uncertainty(-375.12, 3.21), "code", ""),
                ("X", "k_x", *value_and_uncertainty(-1334.9021, 0.412), "code/(m/s²)", ""),
                ("X", "k_xy", *value_and_uncertainty(0.0512, 0.0034), "code/(m/s²)", "small"),
            ),
            2,
        )
    )
    matrix = MatrixView()
    numbers = ((-1334.90, 42.77, -61.50), (35.60, -1338.98, 17.00), (-6.52, 14.41, 1335.22))
    cells = tuple(tuple((fixed(value, 2), "0.41") for value in row) for row in numbers)
    matrix.render(MatrixState("K =", cells, "code/(m/s²)", "U = K·a + U0   (2.2)"))
    residuals = ResidualPlot()
    residuals.render(
        ResidualState(
            tuple(f"{number + 1}: {90 * (number % 4)}°" for number in range(8)),
            tuple(
                ResidualSeries(name, tuple(rng.normal(size=8).tolist()), (2.0,) * 8)
                for name in "XYZ"
            ),
            "code",
        )
    )
    return stacked(table, matrix, residuals)


def charts() -> QWidget:
    rng = np.random.default_rng(2)
    names = (("GyroOut", "V"), ("Temperature", "°C"), ("AntiNodePeriod", "µs"))
    channels = tuple(Channel(name, unit) for name, unit in names)
    index = np.arange(180_000)
    index[90_000:] += 20_000
    t = index / 100.0
    data = np.column_stack(
        [
            -0.0206 + 0.003 * np.sin(t / 300) + 4e-4 * rng.normal(size=t.size),
            26.1 + 2 * (1 - np.exp(-t / 900)),
            23.733621597 + 2e-5 * np.sin(t / 500) + 2e-6 * rng.normal(size=t.size),
        ]
    )
    history = History(channels, 100.0)
    history.append(index, frozen(data))
    widget = StripCharts()
    widget.set_history(history)
    widget.set_cursors(400.0, 1500.0)
    widget.set_marks([Mark(1300.0, "table started")])
    widget.set_intervals([Interval(1600.0, 1800.0, "1", selected=True)])
    return widget


def allan() -> QWidget:
    tau = frozen(np.logspace(-2, 3, 40))
    sigma = frozen(np.sqrt(1e-4 / tau + 1e-5 + 1e-7 * tau))
    plot = Plot("τ, s", "σ(τ), deg/s", log_x=True, log_y=True)
    plot.add_band(tau, frozen(0.8 * sigma), frozen(1.2 * sigma), 0)
    plot.add_curve(tau, sigma, 0, "PW09")
    plot.add_curve(tau, frozen(0.01 / np.sqrt(tau)), 6, "N", dashed=True)
    plot.add_points(tau, frozen(1.05 * sigma), 1, "measured", low=sigma, high=frozen(1.1 * sigma))
    return plot


GALLERY: dict[str, tuple[Callable[[], QWidget], QSize]] = {
    "positions": (positions, QSize(700, 600)),
    "stages": (stages, QSize(1600, 900)),
    "lines": (lines, QSize(1150, 760)),
    "steps": (steps, QSize(330, 640)),
    "results": (results, QSize(900, 760)),
    "charts": (charts, QSize(1100, 420)),
    "allan": (allan, QSize(640, 440)),
}


def main(folder: Path) -> list[Path]:
    """Draw everything into a folder; return the files."""
    app = QApplication.instance() or QApplication([])
    if not isinstance(app, QApplication):
        raise TypeError("a Qt application without widgets is already running")
    folder.mkdir(parents=True, exist_ok=True)
    return [
        path
        for name, (make, size) in GALLERY.items()
        for path in save_pictures(app, make, folder, name, size)
    ]


if __name__ == "__main__":
    main(Path(sys.argv[1]))
