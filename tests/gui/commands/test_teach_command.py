"""A recorded stream becomes a device file."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest

from drivers.profile import Profile, load_profile
from drivers.rawlog import RawLog
from gui.commands.table import run_command
from tests.drivers.teach.layouts import frames_of, invented


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """An invented board at 100 frames a second."""
    rng = np.random.default_rng(12)
    layout = invented(rng, checked=True)
    rows = frames_of(layout, rng, 0, 400)
    path = tmp_path / "strange.calrec"
    writer = RawLog(path, {"device": "?"})
    for n in range(0, 400, 10):
        writer.write(rows[n : n + 10].tobytes(), writer._zero + 0.1 * (n / 10 + 1))
    writer.close()
    return path


def test_a_raw_log_becomes_a_device_file(log: Path, tmp_path: Path, capsys):
    out = tmp_path / "strange.toml"
    assert run_command("teach", [str(log), "--out", str(out), "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["found"], told["share"]) == ("frames", 1.0)
    assert told["checksums"][0]["share"] == 1.0
    profile = load_profile(out)
    assert profile.text == told["device_file"]
    assert (profile.name, profile.stream.length) == ("strange", told["length"])
    assert profile.nominal_hz == pytest.approx(100.0, rel=0.03)


def fast_log(tmp_path: Path, tick: int, header: dict[str, object]) -> Path:
    """Frames of AA 55, a number that goes on by `tick`, two of noise; fifteen times too fast."""
    rng = np.random.default_rng(4)
    path = tmp_path / "fast.calrec"
    writer = RawLog(path, header)
    for n in range(0, 900, 10):
        rows = bytearray()
        for k in range(n, n + 10):
            body = struct.pack("<Ihh", 40_000 + tick * k, *rng.integers(-900, 900, 2).tolist())
            rows += b"\xaa\x55" + body + bytes([sum(body) & 0xFF])
        writer.write(bytes(rows), writer._zero + (n / 10 + 1) * 10 / 3020)
    writer.close()
    return path


def test_a_log_that_was_made_too_fast_writes_no_rate_and_says_why(tmp_path: Path, capsys):
    path = fast_log(tmp_path, 1, {"port": "sim://pointer?speed=max", "baud": 921600})
    assert run_command("teach", [str(path), "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert "nominal_hz" not in told["device_file"]
    assert told["rate_doubt"].startswith("sim://pointer?speed=max does not run in real time")
    assert "does not run in real time" in told["device_file"]
    assert load_text(tmp_path, told["device_file"]).nominal_hz == 0.0


def test_a_number_that_counts_microseconds_tells_the_rate_that_the_clock_does_not(
    tmp_path: Path, capsys
):
    path = fast_log(tmp_path, 5000, {"port": "/dev/ttyUSB0", "baud": 115200})
    assert run_command("teach", [str(path), "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["hz"] == 200.0
    assert "faster than 115200 baud can carry" in told["rate_doubt"]
    assert "is the time in microseconds" in told["rate_doubt"]
    assert load_text(tmp_path, told["device_file"]).nominal_hz == 200.0


def load_text(tmp_path: Path, text: str) -> Profile:
    path = tmp_path / "taught.toml"
    path.write_text(text, "utf-8")
    return load_profile(path)


def test_plain_bytes_and_text_are_taken(tmp_path: Path, capsys):
    path = tmp_path / "lines.bin"
    path.write_bytes(b"".join(b"%d;%d,5\r\n" % (5 * n, n * n % 97) for n in range(80)))
    assert run_command("teach", [str(path), "--name", "Student", "--kind", "accel"]) == 0
    printed = capsys.readouterr().out
    assert 'name = "Student"' in printed
    assert 'decimal = ","' in printed


def test_noise_is_refused_with_a_word_about_the_speed(tmp_path: Path, capsys):
    path = tmp_path / "noise.bin"
    path.write_bytes(np.random.default_rng(1).integers(0, 256, 5000, np.uint8).tobytes())
    assert run_command("teach", [str(path)]) == 1
    assert "baud rate" in capsys.readouterr().out


def test_a_missing_file_is_told(tmp_path: Path, capsys):
    assert run_command("teach", [str(tmp_path / "none")]) == 2
    assert "none" in capsys.readouterr().err
