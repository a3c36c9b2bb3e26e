"""Recording: round trips, kill -9, a full disk, stop and resume, the same device coming back."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.errors import LinkError, StorageError
from core.records.cvgcom import CvgcomHead, read_cvgcom
from core.records.cvgcom_writer import CvgcomWriter
from core.samples.block import Channel, SampleBlock
from drivers.decoders import make_decoder
from drivers.events import BadChecksum, Lost
from drivers.profile import load_profiles
from drivers.reader import Reader
from drivers.recorder import DOUBLE, SINGLE, Recorder, RecordLayout, wire_item
from drivers.recording import Gap, read_recording
from drivers.virtual.address import rig_of
from tests.drivers.links import CVG, Letters, Script, samples, sim_reader, wait_for

ROOT = Path(__file__).resolve().parents[2]
TWO = (Channel("a", "V", "rate.z"), Channel("b", "degC", "temp"))
HEADER = {"device": "25-143", "settings": {"profile": 1}}


def block(first, count, channels=TWO, step=1):
    index = frozen_int(np.arange(first, first + count * step, step))
    return SampleBlock(channels, index, frozen(np.stack([index / 3.0, -index], axis=1)), 100.0)


def recorder(path, item=DOUBLE, text=None):
    return Recorder(path, HEADER, RecordLayout(TWO, 100.0, item), text)


def test_what_is_written_comes_back_with_gaps_marks_and_settings(tmp_path):
    path = tmp_path / "a.calrec"
    writer = recorder(path)
    for first in range(1000, 1500, 10):
        writer.say(block(first, 10))
    writer.mark(1234, "door opened")
    writer.say(Lost(7, 1507))
    writer.say(block(1507, 3))
    writer.say(BadChecksum(2))
    writer.close()
    writer.close()
    record = read_recording(path)
    index, data = record.samples()
    wanted = np.concatenate([np.arange(1000, 1500), np.arange(1507, 1510)])
    assert np.array_equal(index, wanted)
    assert np.array_equal(record.index(), wanted)
    assert np.array_equal(data, np.stack([wanted / 3.0, -wanted], axis=1))
    assert np.array_equal(record.column(1), -wanted)
    assert record.gaps == (Gap(1500, 7),)
    assert [(m.number, m.note) for m in record.marks] == [(1234, "door opened")]
    assert (record.device, record.rate, record.settings) == ("25-143", 100.0, {"profile": 1})
    assert record.channels == TWO
    assert record.ended
    assert record.notes == ()
    assert record.seconds == pytest.approx(5.1)
    assert [part.tolist() for part in [record.samples(1498, 1508)[0]]] == [[1498, 1499, 1507]]


def test_single_floats_are_stored_as_they_came(tmp_path):
    values = np.random.default_rng(1).normal(size=(50, 2)).astype(np.float32)
    writer = recorder(tmp_path / "s.calrec", SINGLE)
    writer.say(SampleBlock(TWO, frozen_int(np.arange(50)), frozen(values), 100.0))
    writer.close()
    record = read_recording(tmp_path / "s.calrec")
    assert record.stretches[0].data.dtype == np.float32
    assert np.array_equal(record.samples()[1], values)


@pytest.mark.parametrize(("profile", "item"), [("cvgx48", SINGLE), ("stim300", DOUBLE)])
def test_the_wire_decides_the_size_of_a_value(profile, item):
    assert wire_item(load_profiles()[profile]) == item


def test_a_reader_is_recorded_and_the_bytes_decode_to_the_same(tmp_path):
    reader = sim_reader("speed=20&seed=4&name=recorder&drop=0.01&bit_error=1e-5")
    decoder = make_decoder(CVG)
    writer = Recorder(
        tmp_path / "r.calrec",
        {"profile_text": CVG.text},
        RecordLayout(decoder.channels, 200.0, wire_item(CVG)),
    )
    reader.tap = writer
    reader.start()
    wait_for(lambda: writer.count > 3000)
    reader.close()
    writer.close()
    heard = samples(reader.drain())
    record = read_recording(tmp_path / "r.calrec")
    index, data = record.samples()
    assert np.array_equal(index, heard[0])
    assert np.array_equal(data, heard[1])
    assert record.gaps
    again = read_recording(tmp_path / "r.calrec", from_bytes=True)
    assert np.array_equal(again.samples()[0], heard[0])
    assert np.array_equal(again.samples()[1], heard[1])
    assert again.channels == record.channels


def test_stopped_and_resumed_is_one_record_with_a_gap(tmp_path):
    writer = recorder(tmp_path / "h.calrec")
    writer.say(block(0, 10))
    writer.hold()
    assert writer.held
    writer.say(block(10, 10))
    writer.take(b"not kept", time.monotonic())
    assert writer.flush()
    assert len(read_recording(tmp_path / "h.calrec")) == 10
    writer.go_on()
    writer.say(block(20, 10))
    writer.close()
    record = read_recording(tmp_path / "h.calrec")
    assert record.gaps == (Gap(10, 10),)
    assert [event.kind for event in record.events] == ["stopped", "resumed", "ended"]


def test_an_interruption_of_the_link_is_a_gap_with_its_reason(tmp_path):
    scripts = [Script([b"abc", LinkError("script", "unplugged")]), Script([0.2, b"de"])]
    opened = iter(scripts)
    reader = Reader(lambda: next(opened), Letters(rate=100.0), reopener=lambda: next(opened))
    layout = RecordLayout((Channel("letter"),), 100.0)
    writer = Recorder(tmp_path / "gap.calrec", {}, layout)
    reader.tap = writer
    reader.start()
    wait_for(lambda: writer.count == 5)
    reader.close()
    writer.close()
    record = read_recording(tmp_path / "gap.calrec")
    assert record.column(0).tolist() == [97, 98, 99, 100, 101]
    assert len(record.gaps) == 1
    assert record.gaps[0].count >= 100
    kinds = [event.kind for event in record.events]
    assert kinds == ["link lost", "reconnected", "lost", "link ended", "ended"]
    assert record.events[0].note == "unplugged"


def test_other_channels_in_mid_record_are_told_and_left_to_the_bytes(tmp_path):
    writer = recorder(tmp_path / "o.calrec")
    writer.say(block(0, 5))
    writer.say(block(5, 5, channels=(TWO[0], Channel("c"))))
    writer.close()
    record = read_recording(tmp_path / "o.calrec")
    assert len(record) == 5
    assert "other channels" in [event.kind for event in record.events]


def test_cvgcom_text_is_written_beside_it_and_its_fault_harms_nothing(tmp_path):
    text = CvgcomWriter(tmp_path / "t.txt", CvgcomHead(0.02, 0.024, TWO), frames=2)
    writer = recorder(tmp_path / "t.calrec", text=text)
    writer.say(block(0, 100))
    writer.flush()
    os.close(text._fd)  # as if the network folder had gone
    writer.say(block(100, 100))
    writer.close()
    assert isinstance(writer.text_error, StorageError)
    assert len(read_recording(tmp_path / "t.calrec")) == 200
    assert read_cvgcom(tmp_path / "t.txt").data[0].tolist() == [round(0.5 / 3, 9), -0.5]


def test_a_record_is_never_overwritten(tmp_path):
    recorder(tmp_path / "x.calrec").close()
    with pytest.raises(StorageError, match="cannot be created"):
        recorder(tmp_path / "x.calrec")


_VICTIM = """
import sys, time
from pathlib import Path
from tests.drivers.test_recorder import block, recorder
writer = recorder(Path(sys.argv[1]))
for first in range(0, 10**9, 50):
    writer.say(block(first, 50))
    if first % 5000 == 0:
        writer.flush()
        print(first + 50, flush=True)
    time.sleep(0.0005)
"""


@pytest.mark.parametrize("wait_s", [0.05, 0.4])
def test_kill_9_loses_nothing_that_was_acknowledged(tmp_path, wait_s):
    path = tmp_path / "killed.calrec"
    child = subprocess.Popen(
        [sys.executable, "-c", _VICTIM, str(path)], cwd=ROOT, stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    acknowledged = int(child.stdout.readline())
    time.sleep(wait_s)
    child.send_signal(signal.SIGKILL)
    told = [acknowledged, *map(int, child.communicate()[0].split())]
    record = read_recording(path)
    index, data = record.samples()
    assert len(index) >= told[-1]
    assert np.array_equal(index, np.arange(len(index)))
    assert np.array_equal(data[:, 0], index / 3.0)
    assert not record.ended


_LIMITED = """
import resource, signal, sys
from pathlib import Path
from tests.drivers.test_recorder import block, recorder
from drivers.recorder import DOUBLE
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, resource.RLIM_INFINITY))
writer = recorder(Path(sys.argv[1]))
for first in range(0, 20_000, 100):
    writer.say(block(first, 100))
    if first % 1000 == 0:
        writer.flush()
print(writer.error)
if len(sys.argv) > 2:
    resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
writer.close()
print(writer.error)
"""


@pytest.mark.parametrize("freed", [False, True])
def test_a_full_disk_is_told_and_what_was_written_stays_readable(tmp_path, freed):
    path = tmp_path / "full.calrec"
    told = subprocess.run(
        [sys.executable, "-c", _LIMITED, str(path), *(["freed"] if freed else [])],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()
    assert f"{path}: cannot be written: " in told[0]
    record = read_recording(path)
    index, data = record.samples()
    assert np.array_equal(data[:, 1], -index)
    if freed:
        assert told[1] == "None"
        assert len(index) == 20_000
    else:
        assert "cannot be written" in told[1]
        assert 1000 < len(index) < 3000
        assert np.array_equal(index, np.arange(len(index)))


def test_the_rig_has_a_device_whose_floats_are_single():
    assert rig_of("sim://cvg25?name=wire").profile.id == "cvgx48"


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_an_error_inside_the_recorder_is_told_and_costs_nothing_before(tmp_path, monkeypatch):
    writer = recorder(tmp_path / "a.calrec")
    writer.say(block(0, 100))
    assert writer.flush()

    def broken(*_) -> None:
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(writer, "_store", broken)
    writer.say(block(100, 100))
    wait_for(lambda: writer.closed)
    assert "error inside the program (ZeroDivisionError('a bug'))" in str(writer.error)
    writer.say(block(200, 100))
    assert writer._queue.empty(), "nothing piles up behind a thread that has ended"
    writer.close()
    assert len(read_recording(tmp_path / "a.calrec")) == 100


def test_a_disk_that_does_not_take_the_end_is_told(tmp_path, monkeypatch):
    writer = recorder(tmp_path / "a.calrec")
    free = threading.Event()
    monkeypatch.setattr("drivers.recorder._JOIN_S", 0.05)
    monkeypatch.setattr(writer, "_flush", free.wait)
    writer.close()
    assert not writer.closed
    assert "has not taken the end of the record" in str(writer.error)
    free.set()
    wait_for(lambda: writer.closed)
