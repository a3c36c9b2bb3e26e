"""Records of every kind by one way in."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest

from core.arrays import frozen
from core.errors import FormatError
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of
from core.records.cvgcom_writer import write_cvgcom
from drivers.framing import BlockWriter
from drivers.profile import load_profiles
from drivers.rawlog import RawLog
from drivers.recorder import HEAD, SAMPLES
from drivers.recording import read_recording
from drivers.series import of_recording, read_series

DATA = np.random.default_rng(1).normal(size=(50, 2))


def recorded(path: Path, firsts: tuple[int, int] = (0, 25)) -> Path:
    header = {
        "content": "recording",
        "device": "25-143",
        "rate_hz": 200.0,
        "channels": [
            {"name": "GyroOut", "unit": "V", "role": "rate.z"},
            {"name": "Temperature", "unit": "degC", "role": "temp"},
        ],
        "settings": {"scale_factor": 0.5},
        "started_utc": "2024-05-13T14:05:00.000+00:00",
    }
    writer = BlockWriter(path, header)
    for first, part in zip(firsts, (DATA[:25], DATA[25:]), strict=True):
        writer.append(SAMPLES, HEAD.pack(first, 25, 2, 8) + part.astype("<f8").tobytes())
    ended = {"t": 1.0, "kind": "ended"}
    writer.append(b"EVT0", json.dumps(ended).encode())
    writer.close()
    return path


def test_a_recording_gives_its_columns_scale_and_rate(tmp_path: Path) -> None:
    series = read_series(recorded(tmp_path / "a.calrec"))
    assert (series.device, series.rate, series.n, series.scale_factor) == ("25-143", 200.0, 50, 0.5)
    np.testing.assert_array_equal(series.columns[0], DATA[:, 0])
    assert [len(column) for column in series.columns[:2]] == [50, 50]
    taken = series.sampled(series.main)
    assert taken.unit == "deg/s"
    assert taken.index is None
    np.testing.assert_array_equal(taken.values, DATA[:, 0] / 0.5)


def test_a_gap_of_a_recording_is_a_gap(tmp_path: Path) -> None:
    series = read_series(recorded(tmp_path / "a.calrec", (0, 40)))
    assert series.index is not None
    assert (series.index[24], series.index[25]) == (24, 40)


def test_a_raw_log_without_samples_is_decoded(tmp_path: Path) -> None:
    profile = load_profiles()["cvgx48"]
    path = tmp_path / "raw.calrec"
    log = RawLog(path, {"device": "25-143", "profile": "cvgx48", "profile_text": profile.text})
    for number in range(40):
        values = [0.01 * number, 25.0, *([1.0] * 9)]
        body = struct.pack("<11f", *values)
        checksum = sum(struct.unpack("<22H", body)) % 65536
        log.write(b"\xaa\x55" + body + struct.pack("<H", checksum), 1.0 + number / 200.0)
    log.close()
    series = read_series(path)
    assert series.rate == 200.0
    assert series.channels[series.main].role == "rate.z"
    assert series.n >= 38


def test_a_file_of_cvgcom_by_its_content(tmp_path: Path) -> None:
    channels = (channel_of("GyroOut"), channel_of("Temperature"))
    path = tmp_path / "25-143.exp(001)_s_pr1.txt"
    head = CvgcomHead(0.01, 0.03, channels)
    write_cvgcom(CvgcomFile(path, head, frozen(DATA), None, ()), path)
    series = read_series(path)
    assert (series.device, series.scale_factor) == ("25-143", 0.03)
    assert series.sampled(series.main).rate == pytest.approx(100.0)


def test_columns_of_text(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text("t_s,rate_dps\n" + "".join(f"{i / 10},{i % 3}\n" for i in range(20)))
    assert read_series(path).sampled(0).rate == pytest.approx(10.0)


def test_what_cannot_be_read_says_so(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="cannot be read"):
        read_series(tmp_path / "nothing.txt")


def test_an_empty_recording_holds_no_samples_yet(tmp_path: Path) -> None:
    path = recorded(tmp_path / "a.calrec")
    whole = read_recording(path)
    with pytest.raises(FormatError, match="no samples yet"):
        of_recording(type(whole)(path, whole.header, whole.channels, 200.0, ()))
