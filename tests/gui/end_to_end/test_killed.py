"""The program is killed in mid-session; the next one goes on where it stood."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from core.plans.plan import load_plans
from core.records.session.record import read_session
from drivers.virtual.pty_process import PtyProcess
from tests.gui.window_driver import Driver

SCRIPT = Path(__file__).with_name("hands_free_app.py")
ROOT = Path(__file__).parents[3]


def test_a_killed_session_is_continued(
    rig: PtyProcess, open_app: Callable[[], Driver], tmp_path: Path
):
    data = tmp_path / "data"
    data.mkdir()
    steps = load_plans()["pointer_8"].steps
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    with subprocess.Popen(
        [sys.executable, str(SCRIPT), rig.port, str(data)], env=environment
    ) as program:
        try:
            for number, step in enumerate(steps[:3], start=1):
                rig.order(remount=step.mount)
                rig.order(turn=step.head_deg)
                _wait_for(data, number)
            # On the way to the fourth, or already measuring it.
            rig.order(turn=steps[3].head_deg)
            time.sleep(0.4)
        finally:
            os.kill(program.pid, signal.SIGKILL)
    (folder,) = (path.parent for path in data.glob("*/session.json"))
    before = read_session(folder)
    assert not before.is_finished
    kept = [position.step.number for position in before.positions]
    assert kept[:3] == [1, 2, 3]

    operator = open_app()
    told = "A session of PW09 is not finished"
    operator.until(lambda: getattr(operator.app.messages.current, "what", "") == told)
    banner = operator.app.messages.current
    assert banner is not None
    assert f"{len(kept)} of 8" in banner.meaning
    operator.answer("Continue it")
    assert operator.count == len(kept)
    operator.connect(rig.port)
    while operator.count < 8:
        operator.measure(rig)
    operator.press("process")
    operator.until(lambda: operator.tab.results.state is not None)
    state = operator.tab.results.state
    assert state is not None
    assert len(state.run) == 8
    assert state.calibration.is_triad
    operator.app.window.close()
    assert read_session(folder).is_finished


def _wait_for(data: Path, positions: int) -> None:
    """Wait until the journal on the disk holds so many positions."""
    deadline = time.monotonic() + 30.0
    while time.monotonic() < deadline:
        journals = list(data.glob("*/positions.jsonl"))
        text = journals[0].read_text(encoding="utf-8") if journals else ""
        if text.count('"kind":"accepted"') >= positions:
            return
        time.sleep(0.05)
    pytest.fail(f"{positions} positions never came to the disk")
