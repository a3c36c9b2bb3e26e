"""The rig in a process of its own."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

from core.errors import LinkError
from drivers.profile import load_profiles
from drivers.transport import open_port
from drivers.virtual.pty_process import PtyProcess
from drivers.virtual.pty_rig import main

CVG = load_profiles()["cvgx48"].port


def heard(port: str, count: int, baud: int = 0) -> bytes:
    transport = open_port(port, CVG, baud)
    data = b""
    while len(data) < count:
        data += transport.read()
    transport.close()
    return data


def test_frames_come_at_the_right_speed_alone():
    with PtyProcess("sim://cvg25?rate=1000") as rig:
        assert heard(rig.port, 4800).count(b"\xaa\x55") >= 98
        assert heard(rig.port, 4800, 57600).count(b"\xaa\x55") < 5


def test_orders_are_obeyed_and_answered():
    with PtyProcess("sim://clbacc") as rig:
        assert rig.order(turn=90)["ok"] is True
        time.sleep(0.1)
        state = rig.order(state=True)["state"]
        assert isinstance(state, dict)
        assert state["head_target_deg"] == 90.0
        with pytest.raises(ValueError, match="unknown mount"):
            rig.order(remount="sideways")
    rig.close()
    with pytest.raises(LinkError, match="has ended"):
        rig.order(turn=0)


def test_backlog_of_a_port_that_nobody_reads_is_lost_and_counted():
    with PtyProcess("sim://cvg25?rate=2000&speed=10") as rig:
        time.sleep(0.5)
        assert rig.order(state=True)["overrun"] not in (0, None)


def test_link_names_the_port_over_unplugging(tmp_path):
    link = tmp_path / "ttyCVG"
    with PtyProcess("sim://cvg25", link) as rig:
        assert rig.port == str(link)
        heard(rig.port, 480)
        rig.order(unplug=True)
        assert not link.is_symlink()
        with pytest.raises(LinkError, match="no such port"):
            open_port(rig.port)
        rig.order(plug_in=True)
        heard(rig.port, 480)
    assert not link.is_symlink()


def test_control_socket_serves_several(tmp_path):
    control = tmp_path / "rig.sock"
    process = subprocess.Popen(
        [sys.executable, "-m", "drivers.virtual.pty_rig", "sim://cvg25", "--control", str(control)],
        stdout=subprocess.PIPE,
        stdin=subprocess.DEVNULL,
        cwd=Path(__file__).parents[3],
    )
    assert process.stdout is not None
    port = json.loads(process.stdout.readline())["port"]
    clients = [socket.socket(socket.AF_UNIX) for _ in range(2)]
    for client in clients:
        client.connect(str(control))
    clients[0].sendall(b'{"tu')
    clients[1].sendall(b'{"truth": true}\n')
    assert b"scale_factor" in clients[1].recv(65536)
    clients[0].sendall(b'rn": 45}\n')
    answer = json.loads(clients[0].recv(65536))
    assert answer == {"ok": True, "port": port, "overrun": 0}
    clients[0].close()
    clients[1].sendall(b'{"quit": true}\n')
    assert process.wait(5) == 0
    assert not control.exists()
    clients[1].close()
    process.stdout.close()


def test_ends_with_its_parent():
    script = (
        "import sys, os\n"
        "from drivers.virtual.pty_process import PtyProcess\n"
        "rig = PtyProcess('sim://cvg25')\n"
        "sys.stdout.write(f'{rig._process.pid}\\n')\n"
        "sys.stdout.flush()\n"
        "sys.stdin.read()\n"
    )
    parent = subprocess.Popen(
        [sys.executable, "-c", script],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=Path(__file__).parents[3],
    )
    assert parent.stdout is not None
    assert parent.stdin is not None
    child = int(parent.stdout.readline())
    parent.send_signal(signal.SIGKILL)
    parent.wait()
    parent.stdin.close()
    parent.stdout.close()
    until = time.monotonic() + 5.0
    while Path(f"/proc/{child}/cmdline").exists() and time.monotonic() < until:
        if not Path(f"/proc/{child}/cmdline").read_bytes():
            break  # a zombie that waits for the system to reap it
        time.sleep(0.02)
    else:
        assert not Path(f"/proc/{child}").exists(), os.kill(child, signal.SIGKILL)


@pytest.mark.parametrize(
    ("url", "why"),
    [("sim://toaster", "no device"), ("sim://cvg25?speed=max", "has a speed")],
)
def test_wrong_addresses(url, why, capsys):
    with pytest.raises(SystemExit):
        main([url])
    assert why in capsys.readouterr().err


def test_other_systems_are_told_what_to_do(monkeypatch, capsys):
    monkeypatch.setattr(sys, "platform", "win32")
    with pytest.raises(SystemExit):
        main(["sim://cvg25"])
    assert "open the sim:// address instead" in capsys.readouterr().err


def test_a_rig_that_does_not_start_is_said():
    with pytest.raises(LinkError, match="has ended"):
        PtyProcess("sim://toaster")
