"""`calrig ports`."""

import json

import pytest

from drivers.ports import SIMULATED
from gui.commands.table import run_command


def test_the_simulated_rig_is_always_there(capsys: pytest.CaptureFixture[str]):
    assert run_command("ports", []) == 0
    text = capsys.readouterr().out
    assert all(url in text and what in text for url, what in SIMULATED)


def test_json_has_one_object_a_port(capsys: pytest.CaptureFixture[str]):
    assert run_command("ports", ["--json", "-"]) == 0
    ports = json.loads(capsys.readouterr().out)["ports"]
    assert [port["url"] for port in ports[-len(SIMULATED) :]] == [url for url, _ in SIMULATED]
    assert all({"url", "text", "kind", "usb"} == port.keys() for port in ports)
