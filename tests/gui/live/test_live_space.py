"""Room on the disk and interrupted records, without a window."""

import os
import time
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.errors import StorageError
from gui.jobs import Jobs
from gui.live.interrupted import LEAVE, OPEN, Interrupted, interrupted_in
from gui.live.space import Room, enough, lasting, megabytes, room, warning
from gui.messages import Messages
from gui.settings import Settings
from tests.drivers.test_recorder import block, recorder


def test_a_disk_is_looked_at_before_the_folder_exists(tmp_path: Path) -> None:
    found = room(tmp_path / "not" / "yet", 1000.0)
    assert found.free > 0
    assert found.seconds == pytest.approx(found.free / 1000.0)


def test_a_disk_that_lasts_a_minute_is_refused_and_an_hour_told_of(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match=r"1 MB left, which last 10 s at 100.0 kB/s"):
        enough(Room(tmp_path, 1_000_000, 1e5))
    enough(Room(tmp_path, 100_000_000, 1e5))
    banner = warning(Room(tmp_path, 100_000_000, 1e5))
    assert banner is not None
    assert banner.what == "The disk lasts 10 min more"
    assert warning(Room(tmp_path, 1_000_000_000, 1e5)) is None
    assert warning(Room(tmp_path, 1_000_000_000, 0.0)) is None


def test_times_and_sizes_in_words() -> None:
    assert [lasting(x) for x in (40, 130, 9000, 3e5)] == ["40 s", "2 min", "2 h", "3 d"]
    assert [megabytes(x) for x in (3e6, 2.5e9)] == ["3 MB", "2.5 GB"]


def crashed(folder: Path, name: str, age_s: float) -> Path:
    """A record that was never ended."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    writer = recorder(path)
    writer.say(block(0, 100))
    assert writer.flush()
    whole = path.read_bytes()
    writer.close()
    path.write_bytes(whole)
    os.utime(path, (time.time() - age_s,) * 2)
    return path


def test_only_what_was_not_ended_and_is_not_being_written_is_found(tmp_path: Path) -> None:
    folder = tmp_path / ".Gyro_Data" / "25-143"
    older, newer = crashed(folder, "a.calrec", 500.0), crashed(folder, "b.calrec", 100.0)
    crashed(folder, "running.calrec", 0.0)
    ended = recorder(folder / "ended.calrec")
    ended.say(block(0, 10))
    ended.close()
    os.utime(folder / "ended.calrec", (0, 0))
    (folder / "none.calrec").write_bytes(b"nothing of ours")
    os.utime(folder / "none.calrec", (0, 0))
    assert interrupted_in(tmp_path, set()) == [newer, older]
    assert interrupted_in(tmp_path, {str(newer)}) == [older]


@pytest.mark.parametrize("key", [OPEN, LEAVE])
def test_it_is_offered_once(qtbot: QtBot, tmp_path: Path, key: str) -> None:
    path = crashed(tmp_path / ".Gyro_Data" / "25-143", "a.calrec", 100.0)
    before = path.read_bytes()
    jobs, messages, settings = Jobs(), Messages(), Settings(tmp_path / "set.json")
    made = Interrupted(jobs, messages, settings)
    chosen: list[object] = []
    made.chosen.connect(chosen.append)
    made.look(tmp_path)
    qtbot.waitUntil(lambda: messages.current is not None)
    assert messages.current is not None
    assert messages.current.what == "A record was interrupted: a.calrec"
    messages.press(key)
    assert chosen == ([path] if key == OPEN else [])
    assert messages.current is None
    assert path.read_bytes() == before
    again = Interrupted(jobs, messages, settings)
    again.look(tmp_path)
    jobs.close()
    qtbot.wait(50)
    assert messages.current is None
