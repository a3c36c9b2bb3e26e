"""The real window against a rig in a process of its own, behind a real pseudo-terminal."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from drivers.virtual.pty_process import PtyProcess
from tests.gui.window_driver import SPEED


@pytest.fixture
def rig(tmp_path: Path) -> Iterator[PtyProcess]:
    """PW09 on the rig, at a port whose name outlasts unplugging."""
    if sys.platform == "win32":
        pytest.fail("the pseudo-terminal needs Linux; run this file there")
    with PtyProcess(f"sim://pointer?speed={SPEED}&seed=5", tmp_path / "port") as process:
        yield process
