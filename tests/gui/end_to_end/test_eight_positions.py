"""From the port to the exported calibration, through the real window."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PySide6.QtWidgets import QLineEdit

from core.records.calibration_json import read_calibration
from core.records.open import read_any
from drivers.virtual.pty_process import PtyProcess
from tests.gui.window_driver import Driver


def test_scan_eight_positions_process_export(
    rig: PtyProcess, open_app: Callable[[], Driver], tmp_path: Path
):
    operator = open_app()
    operator.connect(rig.port)
    assert operator.app.connection.setups[0].profile_id == "pw09_raw"
    assert operator.tab.presenter.state.layout == "pointer"

    for _ in range(8):
        operator.measure(rig)
    assert operator.tab.presenter.state.stage.headline == "All positions done"

    operator.press("process")
    operator.until(lambda: operator.tab.results.state is not None)
    state = operator.tab.results.state
    assert state is not None
    _agrees(state.calibration, rig.order(truth=True)["truth"])

    name = operator.tab.view.results.foot.name
    assert isinstance(name, QLineEdit)
    assert name.text().endswith(".cal.json")
    target = tmp_path / "out.cal.json"
    name.setText(str(target))
    operator.press("export")
    operator.until(target.exists)
    _agrees(read_calibration(target), rig.order(truth=True)["truth"])

    folder = operator.tab.sitting.keeper.session
    assert folder is not None
    (legacy,) = folder.folder.glob("OpticalDividingHead_*.txt")
    assert len(read_any(legacy)) == 8
    lines = (folder.folder / "positions.jsonl").read_text().splitlines()
    assert sum('"accepted"' in line for line in lines) == 8
    raw = json.loads(lines[-1])["event"]["position"]["raw"]
    assert (folder.folder / raw["name"]).stat().st_size >= raw["last"] > raw["first"]


def _agrees(calibration: object, truth: object) -> None:
    """All parameters within twice their U, and most within it."""
    assert isinstance(truth, dict)
    off = []
    for axis, fit in zip(calibration.axes, calibration.fits, strict=True):
        hidden = truth[f"acc.{axis}"]
        true = np.array([hidden[name] for name in fit.names])
        off.append((fit.values - true) / fit.expanded())
    worst = np.abs(np.concatenate(off))
    assert len(worst) == 12
    assert np.all(worst < 2.0), worst
    assert np.mean(worst < 1.0) > 0.6, worst
