"""A rig in a process of its own: orders, answers, faults of the start, its end."""

import os
from pathlib import Path

import pytest

from core.errors import LinkError
from drivers.virtual.pty_process import PtyProcess


def test_it_takes_orders_and_ends_with_its_block(tmp_path: Path) -> None:
    link = tmp_path / "port"
    with PtyProcess("sim://pointer?speed=20", link) as rig:
        assert rig.port == str(link)
        assert os.path.realpath(link).startswith("/dev/pts/")
        answer = rig.order(turn=90)
        assert "error" not in answer
        with pytest.raises(ValueError, match="fly"):
            rig.order(fly=1)
    assert not link.exists()


def test_a_rig_that_does_not_exist_is_said() -> None:
    with pytest.raises(LinkError):
        PtyProcess("sim://ghost")
