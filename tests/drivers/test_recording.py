"""Opening records: torn tails, damage inside, records of bytes alone, what is no record."""

import numpy as np
import pytest

from core.errors import FormatError
from drivers.framing import BlockWriter
from drivers.profile import load_profiles
from drivers.rawlog import RawLog
from drivers.recorder import HEAD, Recorder, RecordLayout
from drivers.recording import read_recording
from drivers.virtual.address import rig_of
from tests.drivers.links import CVG
from tests.drivers.test_recorder import HEADER, TWO, block, recorder

ANY_LINES = load_profiles()["generic_csv"]


@pytest.fixture
def whole(tmp_path):
    path = tmp_path / "whole.calrec"
    writer = recorder(path)
    for first in range(0, 400, 40):
        writer.say(block(first, 40))
        writer.take(bytes([first % 256]) * 100, 0.0)
        writer.flush()
    writer.close()
    return path


def test_every_cut_leaves_a_readable_record_of_right_numbers(whole, tmp_path):
    content = whole.read_bytes()
    header = 512
    rng = np.random.default_rng(2)
    for cut in rng.integers(header + 1300, len(content) - 1, 40).tolist():
        torn = tmp_path / f"torn{cut}.calrec"
        torn.write_bytes(content[:cut])
        record = read_recording(torn)
        index, data = record.samples()
        assert np.array_equal(index, np.arange(len(index)))
        assert np.array_equal(data[:, 0], index / 3.0)
        assert not record.ended


def test_a_torn_tail_is_told(whole, tmp_path):
    torn = tmp_path / "torn.calrec"
    torn.write_bytes(whole.read_bytes()[:-20])
    assert [note.subject for note in read_recording(torn).notes] == ["torn_tail"]


def test_damage_inside_is_a_gap_and_is_told(whole):
    content = bytearray(whole.read_bytes())
    place = content.index(b"BLK0", len(content) // 2) + 60
    content[place] ^= 0xFF
    whole.write_bytes(content)
    record = read_recording(whole)
    assert len(record) == 360
    assert [gap.count for gap in record.gaps] == [40]
    assert [note.subject for note in record.notes] == ["damaged"]


def test_chunks_are_bounded_and_add_up(tmp_path):
    path = tmp_path / "long.calrec"
    writer = recorder(path)
    writer.say(block(0, 200_000))
    writer.close()
    parts = list(read_recording(path).chunks())
    assert max(len(part.index) for part in parts) <= 1 << 16
    assert np.array_equal(np.concatenate([part.index for part in parts]), np.arange(200_000))


def test_a_log_of_bytes_alone_is_decoded(tmp_path):
    url = "sim://cvg25?name=bytes_alone&speed=max"
    log = RawLog(tmp_path / "raw.calrec", {"device": "25-143", "profile_text": CVG.text})
    for _ in range(10):
        log.write(rig_of(url).produce(20), 0.0)
    log.close()
    record = read_recording(tmp_path / "raw.calrec")
    assert len(record) == 200
    assert record.rate == 200.0
    assert [channel.name for channel in record.channels][:2] == ["GyroOut", "Temperature"]


def test_a_resumed_record_decodes_with_its_gap(tmp_path):
    url = "sim://cvg25?name=resumed&speed=max"
    log = RawLog(tmp_path / "raw.calrec", {"profile_text": CVG.text})
    zero = log._zero
    log.write(rig_of(url).produce(20), zero + 0.1)
    log.mark("link lost")
    log.mark("reconnected")
    log.write(rig_of(url).produce(20), zero + 2.1)
    log.close()
    record = read_recording(tmp_path / "raw.calrec")
    assert [(gap.first, gap.count) for gap in record.gaps] == [(20, 380)]


def test_an_interruption_is_a_gap_also_where_only_the_clock_tells_the_rate(tmp_path):
    log = RawLog(tmp_path / "raw.calrec", {"profile_text": ANY_LINES.text})
    zero = log._zero

    def second(begin):
        for number in range(10):
            lines = "".join(f"{number},{k},1.5\n" for k in range(5))
            log.write(lines.encode(), zero + begin + 0.1 * number)

    second(0.1)
    log.mark("link lost")
    log.mark("reconnected")
    second(11.0)
    log.close()
    record = read_recording(tmp_path / "raw.calrec")
    assert record.rate == pytest.approx(50.0)
    (gap,) = record.gaps
    assert gap.count == 495


def test_an_interruption_of_unknown_length_is_refused(tmp_path):
    log = RawLog(tmp_path / "raw.calrec", {"profile_text": ANY_LINES.text})
    for begin in (0.1, 5.0):
        log.write(b"1,2,3\n" * 30, log._zero + begin)
        log.mark("link lost")
    log.close()
    with pytest.raises(FormatError, match="interrupted"):
        read_recording(tmp_path / "raw.calrec")


@pytest.mark.parametrize(
    ("header", "words"),
    [
        ({"content": "something"}, "expected a raw log"),
        ({"content": "raw"}, "no profile"),
        ({"content": "raw", "profile_text": CVG.text}, "no samples"),
    ],
)
def test_what_is_no_record_is_refused(tmp_path, header, words):
    writer = BlockWriter(tmp_path / "no.calrec", header)
    writer.append(b"RAW0", bytes(8) + b"noise")
    writer.close()
    with pytest.raises(FormatError, match=words):
        read_recording(tmp_path / "no.calrec")


def test_an_empty_record_says_so(tmp_path):
    Recorder(tmp_path / "e.calrec", HEADER, RecordLayout(TWO, 100.0)).close()
    with pytest.raises(FormatError, match="no profile"):
        read_recording(tmp_path / "e.calrec")


@pytest.mark.parametrize(
    "payload",
    [
        b"short",
        HEAD.pack(0, 1, 3, 5) + bytes(15),
        HEAD.pack(1 << 62, 1, 2, 8) + bytes(16),
        HEAD.pack(-1, 1, 2, 8) + bytes(15),
    ],
)
def test_samples_that_cannot_be_are_damage(tmp_path, payload):
    path = tmp_path / "a.calrec"
    header = {"content": "recording", "rate_hz": 100.0, "channels": [{"name": "a"}, {"name": "b"}]}
    writer = BlockWriter(path, header)
    writer.append(b"BLK0", HEAD.pack(5, 1, 2, 8) + bytes(16))
    writer.append(b"BLK0", payload)
    writer.append(b"BLK0", HEAD.pack(9, 1, 2, 8) + bytes(16))
    writer.append(b"EVT0", b'{"t": 1.0, "kind": "mark", "number": "many"}')
    writer.close()
    record = read_recording(path)
    assert record.index().tolist() == [5, 9]
    assert [note.subject for note in record.notes] == ["damaged"]
    assert record.marks[0].number == 10


@pytest.mark.parametrize(
    ("header", "why"),
    [
        ({"rate_hz": 100.0, "channels": [1]}, "names no channels"),
        ({"rate_hz": "100", "channels": [{"name": "a"}]}, "rate of its samples"),
        ({"rate_hz": float("inf"), "channels": [{"name": "a"}]}, "rate of its samples"),
    ],
)
def test_a_header_without_sense_is_told(tmp_path, header, why):
    path = tmp_path / "a.calrec"
    writer = BlockWriter(path, {"content": "recording", **header})
    writer.append(b"BLK0", HEAD.pack(0, 1, 1, 8) + bytes(8))
    writer.close()
    with pytest.raises(FormatError, match=why):
        read_recording(path)
