"""Scanning the rig's units, noise, silence and ports that refuse."""

import os
import threading
import time
from dataclasses import replace

import numpy as np
import pytest

from drivers.profile import load_profiles, parse_profile
from drivers.scan import scan
from drivers.transport import open_port
from drivers.virtual.address import rig_of
from drivers.virtual.pty_process import PtyProcess

PROFILES = load_profiles()
UNITS = {
    "clbacc": "adc_board9",
    "pointer": "pw09_raw",
    "clbdus": "adxrs_board9",
    "cvg25": "cvgx48",
}
tty = pytest.importorskip("tty", reason="Windows has no pseudo-terminals")


class Device:
    """A pseudo-terminal with a thread that says something into it, at one speed."""

    def __init__(self, say, baud: str = "B115200") -> None:
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        self.port = os.ttyname(self._slave)
        self.heard = b""
        self._say, self._baud = say, baud
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self) -> None:
        import termios

        while not self._stop.wait(0.01):
            right = termios.tcgetattr(self._slave)[5] == getattr(termios, self._baud)
            try:
                os.write(self._master, self._say(right))
            except BlockingIOError:
                continue
            try:
                self.heard += os.read(self._master, 1000)
            except BlockingIOError:
                continue

    def __enter__(self) -> "Device":
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()
        os.close(self._master)
        os.close(self._slave)


def noise(seed: int):
    rng = np.random.default_rng(seed)
    return lambda _right: rng.bytes(100)


@pytest.mark.parametrize(("unit", "profile"), UNITS.items())
def test_units_of_the_rig_are_found_by_listening(unit, profile):
    url = f"sim://{unit}?name=scan"
    report = scan([url], PROFILES.values())
    assert profile in [found.profile.id for found in report.found]
    best = report.found[0]
    assert (best.url, best.baud) == (url, 115200)
    assert best.frames >= 5
    assert best.share > 0.9
    assert best.identity == {}
    # Two boards of the same assumed frame cannot be told apart; nothing else may come.
    assert len(report.found) == (2 if unit in ("clbacc", "clbdus") else 1)


def test_unit_behind_a_pseudo_terminal_is_found_and_named_when_asked():
    with PtyProcess("sim://pointer") as rig:
        report = scan([rig.port], PROFILES.values(), active=True)
        (found,) = report.found
        assert found.profile.id == "pw09_raw"
        assert found.name == "PW09"
        assert found.identity["firmware"] == "MiniAhrs 2.12"
        (again,) = scan([rig.port], PROFILES.values()).found
        assert again.name == PROFILES["pw09_raw"].name


def test_another_speed_is_found():
    url = "sim://cvg25?name=slow"
    rig = rig_of(url)
    rig.profile = replace(rig.profile, port=replace(rig.profile.port, bauds=(57600,)))
    listed = replace(rig.profile, port=replace(rig.profile.port, bauds=(115200, 57600)))
    (found,) = scan([url], [listed], listen_s=0.5).found
    assert found.baud == 57600


def test_noise_is_strange_and_never_a_device():
    with Device(noise(1)) as device:
        report = scan([device.port], PROFILES.values(), listen_s=0.2)
        assert report.found == ()
        assert report.strange == (device.port,)
        assert device.heard == b""


def test_silence_is_silent():
    with Device(lambda _right: b"") as device:
        began = time.monotonic()
        report = scan([device.port], [PROFILES["stim300"]], listen_s=0.2)
        assert time.monotonic() - began < 1.0
        assert (report.found, report.silent) == ((), (device.port,))


def test_nothing_is_sent_unless_allowed():
    with Device(lambda _right: b"") as device:
        few = [PROFILES["pw09_raw"]]
        few = [replace(few[0], port=replace(few[0].port, bauds=(115200,)))]
        scan([device.port], few, listen_s=0.1)
        assert device.heard == b""
        scan([device.port], few, listen_s=0.1, active=True)
        assert few[0].commands["identify"].data in device.heard


def test_silent_device_answers_when_asked():
    url = "sim://pointer?name=silent"
    rig = rig_of(url)
    rig.receive(rig.profile.commands["stop"].data)
    few = [rig.profile]
    assert scan([url], few, listen_s=0.1).found == ()
    (found,) = scan([url], few, listen_s=0.1, active=True).found
    assert (found.frames, found.name) == (0, "PW09")


def test_text_lines_are_found_after_five_alike():
    def lines(count: list[int]):
        def say(right: bool) -> bytes:
            count[0] += 1
            return b"%d,%d,7\r\n" % (count[0], count[0] % 17) if right else b"\xf3\x9c" * 4

        return say

    with Device(lines([0])) as device:
        report = scan([device.port], PROFILES.values())
        assert [found.profile.id for found in report.found] == ["generic_csv"]


def test_profile_that_explains_little_of_the_stream_is_left_out():
    rig = rig_of("sim://cvg25?name=chatty&speed=max")
    # A gyro whose frames have readable lines between: the lines alone would pass as a device.
    lines = parse_profile(
        """
        schema = 1
        [device]
        name = "lines"
        kind = "imu"
        [port]
        baud = [115200]
        [line]
        prefix = "$T,"
        columns = ["a", "b"]
        """,
        "lines.toml",
    )
    with Device(lambda _right: rig.produce(6) + b"\r\n$T,1,2\r\n") as device:
        assert scan([device.port], [lines], listen_s=0.5).found
        report = scan([device.port], [lines, PROFILES["cvgx48"]])
        (found,) = report.found
        assert found.profile.id == "cvgx48"
        assert 0.9 < found.share < 1.0


def test_refusals_have_their_reasons_and_do_not_stop_the_scan():
    url = "sim://cvg25?name=after-refusals"
    busy = "sim://cvg25?name=busy-while-scanned"
    holder = open_port(busy)
    began = time.monotonic()
    report = scan(["/dev/tty_calrig_none", os.devnull, busy, url], PROFILES.values())
    holder.close()
    assert [found.url for found in report.found] == [url]
    reasons = [error.why for error in report.refused]
    assert "no such port" in reasons[0]
    assert "no serial port" in reasons[1]
    assert "busy" in reasons[2]
    assert time.monotonic() - began < 3.0


def test_port_that_vanishes_while_it_is_listened_to():
    url = "sim://cvg25?name=vanishing&drop=1"
    timer = threading.Timer(0.2, rig_of(url).unplug)
    timer.start()
    report = scan([url], PROFILES.values())
    timer.join()
    (error,) = report.refused
    assert "vanished" in error.why


def test_cancel_and_progress():
    cancel = threading.Event()
    steps = []

    def progress(step):
        steps.append(step)
        if len(steps) == 3:
            cancel.set()

    few = [PROFILES["inertiallabs_ahrs"]]
    with Device(noise(2)) as device:
        began = time.monotonic()
        report = scan([device.port], few, listen_s=0.2, cancel=cancel, progress=progress)
        assert time.monotonic() - began < 1.0
    assert report.found == ()
    assert [(step.done, step.total, step.url) for step in steps] == [
        (done, 7, device.port) for done in range(3)
    ]
    assert steps[0].baud == 115200
