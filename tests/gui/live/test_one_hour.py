"""One hour of two CVGs in the real window: port, record, means, Allan, comparison table."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from core.records.means import read_means
from drivers.recording import read_recording
from drivers.virtual.address import rig_of
from gui.allan.tab import AllanTab
from gui.app import Application, Options
from gui.live.state import Phase
from gui.live.tab import LiveTab

HOUR_S = 3600.0
DEVICES = ("25-143", "25-144")


@pytest.fixture
def app(qtbot: QtBot, tmp_path: Path) -> Iterator[Application]:
    qt = QApplication.instance()
    assert isinstance(qt, QApplication)
    options = Options(root=tmp_path / "data", settings=tmp_path / "set.json", quiet=True)
    made = Application(qt, options)
    qtbot.addWidget(made.window)
    made.start()
    qtbot.waitUntil(lambda: "Live" in made.tabs, timeout=20_000)
    yield made
    made.close()


def record(app: Application, bot: QtBot, url: str, device: str) -> Path:
    """Record an hour of the CVG as an operator would, as fast as the window can take it."""
    live = app.tabs["Live"]
    assert isinstance(live, LiveTab)
    presenter, view = live.presenter, live.view
    app.window.tabs.setCurrentWidget(live.widget)
    app.open_simulated(url)
    bot.waitUntil(lambda: presenter.phase is Phase.WATCHING, timeout=20_000)
    view.settings.serial.setText(device)
    view.settings.serial.editingFinished.emit()
    presenter.act("start")
    assert presenter.phase is Phase.RECORDING
    bot.waitUntil(lambda: presenter.status().seconds >= HOUR_S, timeout=60_000)
    presenter.act("stop")
    recorder = live.keeper.recorder
    assert recorder is not None
    presenter.act("watch")
    recorder.close()
    return recorder.path


@pytest.mark.slow
def test_an_hour_goes_from_the_port_to_the_comparison(
    app: Application, qtbot: QtBot, tmp_path: Path
) -> None:
    urls = [f"sim://cvg25?speed=max&block=10&seed={seed}&name={tmp_path.name}" for seed in (5, 6)]
    paths = [record(app, qtbot, url, name) for url, name in zip(urls, DEVICES, strict=True)]
    for path, name in zip(paths, DEVICES, strict=True):
        stored = read_recording(path)
        assert (stored.device, stored.ended, stored.gaps) == (name, True, ())
        assert stored.seconds >= HOUR_S
    live, allan = app.tabs["Live"], app.tabs["Allan"]
    assert isinstance(live, LiveTab)
    assert isinstance(allan, AllanTab)

    live.measures.average_folder(paths[0].parent)
    qtbot.waitUntil(lambda: len(live.means.state.rows) == 1, timeout=20_000)
    (mean,) = read_means(paths[0].parent / "means.dat")
    column = read_recording(paths[0]).column(0)
    assert mean.mean[0] == pytest.approx(float(np.mean(column)), abs=1e-9)

    app.window.tabs.setCurrentWidget(allan.widget)
    allan.presenter.add([str(path) for path in paths])
    qtbot.waitUntil(lambda: len(allan.library.studies) == len(paths), timeout=60_000)
    for study, url in zip(allan.library.studies, urls, strict=True):
        (output,) = rig_of(url).truth()
        row = study.published.row("random_walk")
        true = output.level.density / np.sqrt(2.0) / study.scale_factor
        assert row.value == pytest.approx(true, rel=0.01)
        assert study.unit == "deg/s"
    findings = allan.presenter.state.findings
    assert findings is not None
    compared = findings.tables[-1]
    assert compared.header[2:] == tuple(f"{name} GyroOut" for name in DEVICES)
    walks = next(row for row in compared.rows if row[0].startswith("N"))
    cells = [float(cell.replace("−", "-")) for cell in walks[2:]]
    assert cells == pytest.approx([2e-4] * len(DEVICES), rel=0.01)
