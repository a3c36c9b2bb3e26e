import os
import random
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from core.errors import FormatError, StorageError
from core.plans.plan import Step
from core.records.legacy.reader import read_legacy
from core.records.run_file import read_run
from core.records.session.events import RawRange
from core.records.session.record import JOURNAL_NAME, read_session
from core.records.session.store import Session

ROOT = Path(__file__).parents[4]


@pytest.fixture
def session(tmp_path, start, clock):
    with Session.create(tmp_path / "s", start, now=clock) as session:
        yield session


def steps_of(session):
    return session.record.start.plan.steps


def legacy_of(session):
    assert session.legacy_path is not None
    return read_legacy(session.legacy_path)


def test_positions_are_on_disk_when_accept_returns(session, means):
    for place, step in enumerate(steps_of(session), start=1):
        position = session.accept(step, means(100.0 * place), raw=RawRange("a.calrec", 0, 500))
        assert (position.id, position.attempt) == (place, 1)
        stored = read_session(session.folder)
        assert len(stored.positions) == place
        last = stored.positions[-1]
        assert last.step == step
        assert last.raw == RawRange("a.calrec", 0, 500)
        np.testing.assert_array_equal(last.accumulation.mean, position.accumulation.mean)
        legacy = legacy_of(session)
        assert len(legacy) == place
        np.testing.assert_allclose(
            legacy.column("acc_x")[-1], position.accumulation.mean[1], atol=0.005
        )
    assert session.legacy_path.name == "OpticalDividingHead_202405140930.txt"
    assert session.legacy_error is None


def test_a_session_is_continued_where_it_stood(session, means, clock):
    steps = steps_of(session)
    session.accept(steps[0], means(1.0))
    session.close()
    with Session.open(session.folder, now=clock) as again:
        assert [position.step.number for position in again.positions] == [steps[0].number]
        second = again.accept(steps[1], means(2.0))
        assert second.id == 2
        assert again.record.notes == ()
        assert again.record.start.plan == session.record.start.plan
    assert [p.id for p in read_session(session.folder).positions] == [1, 2]


def test_repeat_discard_and_undo_are_events(session, means):
    one, two, *_ = steps_of(session)
    first = session.accept(one, means(1.0))
    other = session.accept(two, means(2.0))
    repeat = session.accept(one, means(3.0), supersedes=(first.id,))
    assert repeat.attempt == 2
    assert [p.id for p in session.positions] == [other.id, repeat.id]
    assert len(legacy_of(session)) == 2
    session.discard(other.id, reason="the table shook")
    assert [p.id for p in session.positions] == [repeat.id]
    session.restore(other.id)
    session.restore(first.id, instead_of=(repeat.id,))
    assert [p.id for p in session.positions] == [first.id, other.id]
    assert legacy_of(session).column("position number").tolist() == [0, 1]
    stored = read_session(session.folder)
    assert [event.kind for event in stored.events] == [
        "accepted", "accepted", "accepted", "discarded", "restored", "restored",
    ]  # fmt: skip
    assert stored.events[3].reason == "the table shook"
    assert [p.id for p in stored.attempts] == [1, 2, 3]


def test_a_rejected_attempt_is_kept_and_can_be_taken_in(session, means):
    one = steps_of(session)[0]
    rejected = session.reject(one, means(1.0), "looks like position 3")
    assert session.positions == ()
    assert not session.legacy_path.exists()
    session.restore(rejected.id, reason="it was right")
    assert [p.id for p in session.positions] == [rejected.id]
    assert session.accept(one, means(1.0)).attempt == 2


def test_everything_discarded_leaves_an_empty_legacy_file(session, means):
    position = session.accept(steps_of(session)[0], means(1.0))
    session.discard(position.id)
    assert session.legacy_path.read_bytes() == b""
    assert session.positions == ()


def test_finish_writes_the_run_file(session, means, clock):
    for step in steps_of(session):
        session.accept(step, means(50.0 * step.number))
    run = session.run()
    path = session.finish()
    assert path == session.folder / "PW09.run.csv"
    back = read_run(path)
    np.testing.assert_array_equal(back.y, run.y)
    np.testing.assert_array_equal(back.y_se, run.y_se)
    assert back.mount == run.mount
    assert read_session(session.folder).is_finished
    with Session.open(session.folder, now=clock) as again:
        assert not again.record.is_finished
        assert again.record.events[-1].kind == "reopened"
        assert again.finish() == path


def test_a_session_without_positions_can_be_finished(session):
    assert session.finish() is None
    assert read_session(session.folder).is_finished


def test_misuse_is_refused_and_changes_nothing(session, means):
    step = steps_of(session)[0]
    other = means(1.0)
    with pytest.raises(ValueError, match="other channels"):
        session.accept(step, type(other)(**{**_members(other), "channels": other.channels[::-1]}))
    with pytest.raises(ValueError, match="no positions"):
        session.discard(7)
    with pytest.raises(ValueError, match="no positions"):
        session.accept(step, means(1.0), supersedes=(7,))
    assert read_session(session.folder).events == ()


def _members(accumulation):
    return {name: getattr(accumulation, name) for name in type(accumulation).__slots__}


def test_two_programs_on_one_session(session, start):
    with pytest.raises(StorageError, match=f"another program .*process {os.getpid()}"):
        Session.open(session.folder)
    with pytest.raises(StorageError, match="already holds a session"):
        Session.create(session.folder, start)
    session.close()
    Session.open(session.folder).close()


def test_folders_that_are_no_sessions(tmp_path, start):
    with pytest.raises(FormatError, match=r"holds no session\.json"):
        Session.open(tmp_path)
    file = tmp_path / "file"
    file.write_text("x")
    with pytest.raises(StorageError, match="nothing has been measured"):
        Session.create(file / "s", start)


def test_a_set_temperature_that_clbacc_needs(tmp_path, start, means):
    board = type(start)(**{**_members(start), "legacy": "clbacc"})
    with Session.create(tmp_path / "s", board) as session:
        step = Step(1, "", "X_from", 7.5)
        with pytest.raises(ValueError, match="set temperature"):
            session.accept(step, means(1.0))
        session.accept(step, means(1.0), set_temperature_c=-40.0, temperature_c=-38.5)
        file = legacy_of(session)
        assert file.column("set temperature").tolist() == [-40.0]
        assert file.column("head angle").tolist() == [7.5]
        assert session.run().temperature_c.tolist() == [-38.5]


def test_no_legacy_file_where_none_is_wanted(tmp_path, start, means):
    plain = type(start)(**{**_members(start), "legacy": ""})
    with Session.create(tmp_path / "s", plain) as session:
        session.accept(start.plan.steps[0], means(1.0))
        assert session.legacy_path is None
        assert not list(session.folder.glob("*.txt"))


# --- the legacy text follows the journal ---------------------------------------------------------


def test_a_position_that_the_legacy_layout_cannot_hold_is_stored_all_the_same(session, means):
    session.accept(Step(99, "", "Z_from", 45.0), means(1.0))
    assert "no position for mount 'Z_from'" in str(session.legacy_error)
    assert len(read_session(session.folder).positions) == 1
    session.discard(1)
    assert session.legacy_error is None


def test_a_legacy_text_left_behind_by_a_crash_is_made_anew(session, means, clock):
    for step in steps_of(session)[:3]:
        session.accept(step, means(1.0))
    session.close()
    whole = session.legacy_path.read_bytes()
    session.legacy_path.write_bytes(whole[:-20])
    with Session.open(session.folder, now=clock) as again:
        assert again.record.notes == ()
    assert session.legacy_path.read_bytes() == whole


def test_an_edited_legacy_text_is_kept_beside(session, means, clock):
    session.accept(steps_of(session)[0], means(1.0))
    session.close()
    session.legacy_path.write_text("edited by hand")
    with Session.open(session.folder, now=clock) as again:
        (note,) = again.record.notes
        assert note.subject == "legacy_differs"
    (kept,) = session.folder.glob("*.kept")
    assert kept.read_text() == "edited by hand"
    assert len(legacy_of(session)) == 1


# --- crashes and full disks ----------------------------------------------------------------------


def test_a_torn_last_line_is_told_once_and_stays(session, means, clock):
    one, two, *_ = steps_of(session)
    session.accept(one, means(1.0))
    session.accept(two, means(2.0))
    session.close()
    journal = session.folder / JOURNAL_NAME
    torn = journal.read_bytes()[:-40]
    journal.write_bytes(torn)
    session.legacy_path.write_bytes(session.legacy_path.read_bytes().splitlines(True)[0])
    with Session.open(session.folder, now=clock) as again:
        (note,) = again.record.notes
        assert note.subject == "torn_line"
        assert "line 2" in note.text
        assert [p.step for p in again.positions] == [one]
        again.accept(two, means(2.0))
        assert len(legacy_of(again)) == 2
    assert journal.read_bytes().startswith(torn)
    with Session.open(session.folder, now=clock) as third:
        assert third.record.notes == ()
        assert [p.step for p in third.positions] == [one, two]


WRITER = """
import sys
from datetime import datetime
from pathlib import Path
import numpy as np
from core.plans.plan import load_plans
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel
channels = tuple(Channel(f"A{a}", "code", f"acc.{a}") for a in "xyz")
plan = load_plans()["pointer_16"]
folder = Path(sys.argv[1])
if (folder / "session.json").exists():
    session = Session.open(folder)
else:
    start = SessionStart("PW09", "accelerometer", channels, 100.0, plan,
                         "2024-05-14T09:30:05+03:00", legacy="pointer")
    session = Session.create(folder, start)
rng = np.random.default_rng(1)
print("ready", flush=True)
while True:
    for step in plan.steps:
        data = rng.normal(step.number, 1.0, (64, 3))
        position = session.accept(step, accumulation_of(channels, np.arange(64) / 100, data))
        print(position.id, repr(float(position.accumulation.mean[0])), flush=True)
"""


def test_kill_9_loses_no_acknowledged_position(tmp_path):
    rng = random.Random(20240514)
    folder = tmp_path / "s"
    acknowledged: dict[int, str] = {}
    for _ in range(4):
        writer = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(folder)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert writer.stdout is not None
        with writer.stdout as output:
            assert output.readline() == "ready\n"
            time.sleep(rng.uniform(0.02, 0.4))
            writer.kill()
            told = [line.split() for line in output if line.endswith("\n")]
        assert writer.wait() != 0
        assert told
        acknowledged.update((int(number), mean) for number, mean in told)
        record = read_session(folder)
        stored = {p.id: repr(float(p.accumulation.mean[0])) for p in record.positions}
        assert acknowledged.items() <= stored.items()
        assert len(stored) <= len(acknowledged) + 1 + len(acknowledged) // 1000
        # At most the line that was being written when each writer died.
        assert all(note.subject == "torn_line" for note in record.notes)
        acknowledged = stored
    with Session.open(folder) as session:
        assert session.legacy_error is None
        assert len(legacy_of(session)) == len(session.positions)


FULL = """
import resource, sys
from pathlib import Path
import numpy as np
from core.errors import StorageError
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
session = Session.open(Path(sys.argv[1]))
channels = session.record.start.channels
steps = session.record.start.plan.steps
size = (session.folder / "positions.jsonl").stat().st_size
resource.setrlimit(resource.RLIMIT_FSIZE, (size + 400, resource.RLIM_INFINITY))
data = np.random.default_rng(1).normal(5.0, 1.0, (64, len(channels)))
mean = accumulation_of(channels, np.arange(64) / 100, data)
try:
    session.accept(steps[1], mean)
except StorageError as error:
    print(error)
else:
    raise SystemExit("the limit did not hold")
assert len(session.positions) == 1
resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY,) * 2)
session.accept(steps[1], mean)
"""

if sys.platform != "win32":  # Windows has no limit on the size of a file

    def test_a_full_disk_loses_nothing_that_was_accepted(session, means):
        session.accept(steps_of(session)[0], means(1.0))
        session.close()
        done = subprocess.run(
            [sys.executable, "-c", FULL, str(session.folder)],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert "all positions accepted before are stored, this one is not" in done.stdout
        assert "free some disk space" in done.stdout
        record = read_session(session.folder)
        assert len(record.positions) == 2
        assert record.notes == ()


def test_a_session_that_could_not_begin_leaves_the_folder_free(tmp_path, start, monkeypatch):
    def full(*_) -> None:
        raise StorageError("the disk is full")

    with monkeypatch.context() as patch:
        patch.setattr("core.records.session.store.write_text_atomic", full)
        with pytest.raises(StorageError, match="the disk is full"):
            Session.create(tmp_path / "s", start)
    with Session.create(tmp_path / "s", start) as session:
        assert session.positions == ()


def test_the_name_of_the_folder_is_on_the_disk(tmp_path, start, monkeypatch):
    synced = []
    monkeypatch.setattr("core.records.session.store.sync_folder", synced.append)
    Session.create(tmp_path / "root" / "s", start).close()
    assert synced == [tmp_path / "root"]
