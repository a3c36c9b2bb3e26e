"""Raw logs: every byte that came, whatever the disk does, or word of how many are missing."""

import errno
import os
import time

import pytest

from core.errors import FormatError, StorageError
from drivers.framing import BlockWriter, Damage
from drivers.rawlog import Chunk, Mark, RawLog, rawlog_header, read_rawlog


class SmallDisk:
    """Lets `room` more bytes through, then none."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.room: float = float("inf")
        self._write = os.write
        monkeypatch.setattr(os, "write", self._limited)

    def _limited(self, fd: int, data: bytes) -> int:
        if self.room <= 0:
            raise OSError(errno.ENOSPC, "No space left on device")
        taken = self._write(fd, data[: int(min(self.room, len(data)))])
        self.room -= taken
        return taken


def test_what_came_comes_back_with_its_time(tmp_path):
    path = tmp_path / "run.calrec"
    log = RawLog(path, {"port": "COM4", "profile": "schema = 1\n# Привіт"})
    zero = time.monotonic()
    log.write(b"\xaa\x55first", zero + 0.1)
    log.mark("link lost", why="unplugged")
    log.write(b"second", zero + 2.5)
    log.close()
    header = rawlog_header(path)
    assert header["port"] == "COM4"
    assert header["profile"] == "schema = 1\n# Привіт"
    assert str(header["started_utc"]).endswith("+00:00")
    first, mark, second = read_rawlog(path)
    assert isinstance(first, Chunk)
    assert isinstance(second, Chunk)
    assert isinstance(mark, Mark)
    assert (first.data, second.data) == (b"\xaa\x55first", b"second")
    assert first.t == pytest.approx(0.1, abs=0.05)
    assert second.t - first.t == pytest.approx(2.4, abs=1e-9)
    assert (mark.kind, mark.fields) == ("link lost", {"why": "unplugged"})


def test_bytes_are_on_disk_before_the_next_read(tmp_path):
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    log.write(b"now", time.monotonic())
    assert [part.data for part in read_rawlog(path) if isinstance(part, Chunk)] == [b"now"]
    log.sync()
    log.close()
    log.sync()


def test_synced_once_a_second(tmp_path, monkeypatch):
    synced = []
    monkeypatch.setattr(BlockWriter, "sync", lambda _self: synced.append(1))
    log = RawLog(tmp_path / "run.calrec", {})
    synced.clear()
    for step in range(100):
        log.write(b"x", time.monotonic() + step * 0.05)
    assert 4 <= len(synced) <= 5
    log.close()


def test_a_disk_that_recovers_costs_nothing(tmp_path, monkeypatch):
    disk = SmallDisk(monkeypatch)
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    sent = [bytes([k]) * 400 for k in range(30)]
    for k, data in enumerate(sent):
        if k == 10:
            disk.room = 1000
        if k == 20:
            disk.room = float("inf")
        log.write(data, time.monotonic())
        assert (log.error is not None) == (12 <= k < 20)
    log.close()
    assert log.error is None
    assert [part.data for part in read_rawlog(path) if isinstance(part, Chunk)] == sent


def test_a_full_disk_is_told_and_what_is_lost_is_counted(tmp_path, monkeypatch):
    monkeypatch.setattr("drivers.rawlog._SPOOL_BYTES", 5000)
    disk = SmallDisk(monkeypatch)
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    sent = [bytes([k]) * 400 for k in range(60)]
    for k, data in enumerate(sent):
        if k == 10:
            disk.room = 0
            log.write(data, time.monotonic())
            assert isinstance(log.error, StorageError)
            assert "No space left" in str(log.error)
            with pytest.raises(StorageError, match="No space left"):
                log.sync()
            continue
        if k == 50:
            disk.room = float("inf")
        log.write(data, time.monotonic())
    assert log.error is None
    log.sync()
    log.close()
    parts = list(read_rawlog(path))
    (note,) = [part for part in parts if isinstance(part, Mark)]
    assert note.kind == "not stored"
    kept = [part.data for part in parts if isinstance(part, Chunk)]
    missing = len(sent) - len(kept)
    assert missing == sum(data not in kept for data in sent) > 0
    assert note.fields["count"] == missing * 400
    assert kept == [data for data in sent if data in kept]


def test_a_failed_sync_stays_said(tmp_path, monkeypatch):
    log = RawLog(tmp_path / "run.calrec", {})

    def fail(_self):
        raise StorageError("not safe on disk: Input/output error")

    with monkeypatch.context() as broken:
        broken.setattr(BlockWriter, "sync", fail)
        log.write(b"x", time.monotonic() + 2.0)
    log.write(b"y", time.monotonic() + 2.1)
    with pytest.raises(StorageError, match="Input/output"):
        log.sync()
    log.close()


def test_a_disk_full_to_the_end_leaves_word(tmp_path, monkeypatch):
    disk = SmallDisk(monkeypatch)
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    log.write(b"kept", time.monotonic())
    disk.room = 0
    log.write(b"not kept", time.monotonic())
    log.close()
    assert log.error is not None
    assert [part.data for part in read_rawlog(path) if isinstance(part, Chunk)] == [b"kept"]


def test_torn_tail_and_other_block_files(tmp_path):
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    log.write(b"one", time.monotonic())
    log.write(b"two", time.monotonic())
    log.close()
    path.write_bytes(path.read_bytes()[:-1])
    one, torn = read_rawlog(path)
    assert isinstance(one, Chunk)
    assert isinstance(torn, Damage)
    other = tmp_path / "other.calrec"
    BlockWriter(other, {"content": "samples"}).close()
    with pytest.raises(FormatError, match="expected a raw log"):
        list(read_rawlog(other))


@pytest.mark.parametrize(
    ("tag", "payload"),
    [
        (b"RAW0", b"short"),
        (b"EVT0", b"no JSON"),
        (b"EVT0", b"[]"),
        (b"EVT0", b'{"t": 1.0}'),
        (b"EVT0", b'{"t": true, "kind": "a"}'),
        (b"EVT0", b'{"t": 1' + b"0" * 400 + b', "kind": "a"}'),
    ],
)
def test_a_whole_block_that_holds_nothing_known_is_damage(tmp_path, tag, payload):
    path = tmp_path / "a.calrec"
    writer = BlockWriter(path, {"content": "raw"})
    writer.append(tag, payload)
    writer.append(b"EVT0", b'{"t": 1.5, "kind": "link lost"}')
    writer.close()
    assert list(read_rawlog(path)) == [Damage(512, 12 + len(payload)), Mark(1.5, "link lost", {})]
