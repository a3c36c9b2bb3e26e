"""Block files under damage: what was whole before stays whole, what is not is told."""

import errno
import os
import signal
import struct
import subprocess
import sys
import time
import zlib
from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError, StorageError
from drivers.framing import MAGIC, Block, BlockWriter, Damage, read_blocks, read_header, sync_file

HEADER = {"device": "Прилад 25-143", "rate": 200}


def payloads(rng: np.random.Generator, count: int) -> list[bytes]:
    return [rng.bytes(int(rng.integers(0, 300))) for _ in range(count)]


def written(path: Path, parts: list[bytes]) -> None:
    writer = BlockWriter(path, HEADER)
    for part in parts:
        writer.append(b"RAW0", part)
    writer.close()
    writer.close()


def whole_blocks(path: Path) -> list[Block]:
    """The blocks of a file in which nothing may be damaged."""
    blocks: list[Block] = []
    for part in read_blocks(path):
        assert isinstance(part, Block)
        blocks.append(part)
    return blocks


def test_round_trip(tmp_path):
    path = tmp_path / "a.calrec"
    parts = payloads(np.random.default_rng(1), 50)
    written(path, parts)
    assert read_header(path) == HEADER
    blocks = whole_blocks(path)
    assert [block.payload for block in blocks] == parts
    assert {block.tag for block in blocks} == {b"RAW0"}
    assert blocks[0].offset % 512 == 0


def test_every_cut_leaves_the_whole_blocks_before_it(tmp_path):
    path = tmp_path / "a.calrec"
    written(path, payloads(np.random.default_rng(2), 12))
    whole = path.read_bytes()
    blocks = whole_blocks(path)
    ends = [block.offset + 12 + len(block.payload) for block in blocks]
    for cut in range(blocks[0].offset, len(whole)):
        path.write_bytes(whole[:cut])
        found = list(read_blocks(path))
        intact = [block for block, end in zip(blocks, ends, strict=True) if end <= cut]
        last = ends[len(intact) - 1] if intact else blocks[0].offset
        torn = [Damage(last, cut - last)] if cut > last else []
        assert found == [*intact, *torn]


def test_a_changed_bit_costs_one_block(tmp_path):
    path = tmp_path / "a.calrec"
    written(path, payloads(np.random.default_rng(3), 12))
    whole = path.read_bytes()
    blocks = whole_blocks(path)
    rng = np.random.default_rng(4)
    for place in rng.integers(blocks[0].offset, len(whole), 200):
        bad = bytearray(whole)
        bad[place] ^= 1 << int(rng.integers(8))
        path.write_bytes(bad)
        found = list(read_blocks(path))
        good = [block for block in found if isinstance(block, Block)]
        assert len(good) == len(blocks) - 1
        assert set(good) < set(blocks)
        (damage,) = [part for part in found if isinstance(part, Damage)]
        assert damage.offset <= place < damage.offset + damage.count


def test_nothing_is_overwritten(tmp_path):
    path = tmp_path / "a.calrec"
    written(path, [b"first"])
    with pytest.raises(StorageError, match="cannot be created"):
        BlockWriter(path, HEADER)
    assert [block.payload for block in whole_blocks(path)] == [b"first"]
    with pytest.raises(StorageError, match="cannot be created"):
        BlockWriter(tmp_path / "none" / "a.calrec", HEADER)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"", "does not begin with CALREC1"),
        (b"OpticalDividingHead 1 2 3\n" * 50, "does not begin with CALREC1"),
        (b"CALREC1\n" + b"\xff" * 600, "header of the record is damaged"),
        (b"CALREC1\n" + b"\x05\0\0\0" + b"\0" * 600, "header of the record is damaged"),
    ],
)
def test_foreign_files_are_refused(tmp_path, content, why):
    path = tmp_path / "a.calrec"
    path.write_bytes(content)
    for reading in (read_header, lambda p: list(read_blocks(p))):
        with pytest.raises(FormatError, match=why):
            reading(path)
    with pytest.raises(FormatError, match="cannot be read"):
        read_header(tmp_path / "none")


def test_full_disk_leaves_whole_blocks(tmp_path, monkeypatch):
    path = tmp_path / "a.calrec"
    writer = BlockWriter(path, HEADER)
    writer.append(b"RAW0", b"before" * 100)
    real, room = os.write, [150]

    def small_disk(fd: int, data: bytes) -> int:
        if not room[0]:
            raise OSError(errno.ENOSPC, "No space left on device")
        taken = real(fd, data[: room[0]])
        room[0] -= taken
        return taken

    monkeypatch.setattr(os, "write", small_disk)
    with pytest.raises(StorageError, match="No space left"):
        writer.append(b"RAW0", b"during" * 100)
    monkeypatch.undo()
    writer.append(b"RAW0", b"after")
    writer.close()
    assert [block.payload for block in whole_blocks(path)] == [b"before" * 100, b"after"]


def test_disk_that_cannot_even_take_back_half_a_block(tmp_path, monkeypatch):
    path = tmp_path / "a.calrec"
    writer = BlockWriter(path, HEADER)
    writer.append(b"RAW0", b"before")
    real = os.write
    calls = []

    def breaking(fd: int, data: bytes) -> int:
        calls.append(1)
        if len(calls) > 1:
            raise OSError(errno.EIO, "Input/output error")
        return real(fd, data[:20])

    def unable(_fd: int, _size: int) -> None:
        raise OSError(errno.EIO, "Input/output error")

    monkeypatch.setattr(os, "write", breaking)
    monkeypatch.setattr(os, "ftruncate", unable)
    with pytest.raises(StorageError, match="Input/output error"):
        writer.append(b"RAW0", b"during" * 10)
    monkeypatch.undo()
    writer.append(b"RAW0", b"after")
    writer.close()
    before, damage, after = read_blocks(path)
    assert isinstance(before, Block)
    assert isinstance(damage, Damage)
    assert isinstance(after, Block)
    assert (before.payload, damage.count, after.payload) == (b"before", 20, b"after")


def test_disk_that_vanishes_at_the_end_is_said(tmp_path, monkeypatch):
    writer = BlockWriter(tmp_path / "a.calrec", HEADER)

    def unable(_fd: int) -> None:
        raise OSError(errno.EIO, "Input/output error")

    monkeypatch.setattr(os, "fdatasync", unable)
    with pytest.raises(StorageError, match="not safe on disk"):
        writer.close()
    writer.close()


def test_sync_of_a_file_that_is_gone(tmp_path):
    with pytest.raises(StorageError, match="not safe on disk"):
        sync_file(tmp_path / "none")


WRITER = """
import sys
from pathlib import Path
from drivers.framing import BlockWriter
writer = BlockWriter(Path(sys.argv[1]), {})
number = 0
while True:
    writer.append(b"RAW0", number.to_bytes(8, "little") * 20)
    number += 1
    if number % 50 == 0:
        sys.stdout.write(f"{number}\\n")
        sys.stdout.flush()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_killed_writer_loses_nothing_that_it_has_written(tmp_path):
    for run in range(4):
        path = tmp_path / f"{run}.calrec"
        process = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(path)], stdout=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        acknowledged = 0
        until = time.monotonic() + 0.05 * (run + 1)
        while acknowledged == 0 or time.monotonic() < until:
            acknowledged = int(process.stdout.readline())
        process.send_signal(signal.SIGKILL)
        acknowledged = int((process.stdout.read().split() or [acknowledged])[-1])
        process.wait()
        process.stdout.close()
        blocks = [part for part in read_blocks(path) if isinstance(part, Block)]
        assert len(blocks) >= acknowledged
        for number, block in enumerate(blocks):
            assert block.payload == number.to_bytes(8, "little") * 20


def test_a_block_that_could_not_be_taken_back_costs_no_later_one(tmp_path, monkeypatch):
    path = tmp_path / "a.calrec"
    writer = BlockWriter(path, HEADER)
    real = os.write

    def torn(fd: int, data: bytes) -> int:
        if len(data) <= 50:
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(fd, data[:50])

    def never(fd: int, size: int) -> None:
        raise OSError(errno.EIO, "Input/output error")

    with monkeypatch.context() as patch:
        patch.setattr(os, "write", torn)
        patch.setattr(os, "ftruncate", never)
        with pytest.raises(StorageError):
            writer.append(b"RAW0", b"x" * 60)
    writer.append(b"RAW0", b"between")
    with monkeypatch.context() as patch:
        patch.setattr(os, "write", torn)
        with pytest.raises(StorageError):
            writer.append(b"RAW0", b"y" * 60)
    writer.close()
    assert list(read_blocks(path)) == [Damage(512, 50), Block(b"RAW0", b"between", 562)]


@pytest.mark.parametrize("text", [b"[1, 2]", b"{", b"\xff\xff", b"[" * 5000])
def test_a_header_that_is_no_object_is_damage(tmp_path, text):
    path = tmp_path / "a.calrec"
    path.write_bytes(MAGIC + struct.pack("<II", len(text), zlib.crc32(text)) + text)
    with pytest.raises(FormatError, match="the header of the record is damaged"):
        read_header(path)
