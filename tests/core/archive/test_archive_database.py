"""The file of the index: damaged, newer, older, read-only, used by two programs, killed."""

import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest

from core.archive.store import Archive
from core.errors import StorageError
from core.procedures.calibration import Calibration
from tests.core.archive.conftest import calibrated

ROOT = Path(__file__).parents[3]

V1 = """
CREATE TABLE archive_meta (key VARCHAR(40) NOT NULL PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE archive_places (
    id VARCHAR(40) NOT NULL PRIMARY KEY, name TEXT NOT NULL, path TEXT NOT NULL, seen TEXT NOT NULL
);
CREATE TABLE archive_folders (
    place VARCHAR(40) NOT NULL REFERENCES archive_places (id) ON DELETE CASCADE,
    path TEXT NOT NULL, mtime BIGINT NOT NULL, PRIMARY KEY (place, path)
);
CREATE TABLE archive_entries (
    id INTEGER NOT NULL PRIMARY KEY,
    place VARCHAR(40) NOT NULL REFERENCES archive_places (id) ON DELETE CASCADE,
    folder TEXT NOT NULL, path TEXT NOT NULL, part TEXT NOT NULL, signature TEXT NOT NULL,
    kind VARCHAR(20) NOT NULL, serial TEXT NOT NULL, sensor VARCHAR(20) NOT NULL,
    what TEXT NOT NULL, operator TEXT NOT NULL, profile TEXT NOT NULL,
    measured VARCHAR(30) NOT NULL, temperature_c FLOAT, verdict VARCHAR(20) NOT NULL,
    count INTEGER NOT NULL, remark TEXT NOT NULL, sha256 VARCHAR(64) NOT NULL, words TEXT NOT NULL,
    CONSTRAINT archive_entries_once UNIQUE (place, path, part)
);
CREATE TABLE archive_quantities (
    entry INTEGER NOT NULL REFERENCES archive_entries (id) ON DELETE CASCADE,
    channel TEXT NOT NULL, name TEXT NOT NULL, symbol TEXT NOT NULL, unit TEXT NOT NULL,
    value FLOAT NOT NULL, u FLOAT, rank INTEGER NOT NULL, PRIMARY KEY (entry, channel, name)
);
INSERT INTO archive_meta VALUES ('schema', '1');
"""
"""The tables as the first version made them."""


@pytest.fixture
def filled(root: Path, triad: Calibration) -> Path:
    for number in range(3):
        calibrated(triad, root / f"s{number}", bias=float(number))
    with Archive(root) as archive:
        archive.refresh()
    return root


def test_a_damaged_index_is_set_aside_and_made_again(filled: Path) -> None:
    index = filled / "archive.db"
    index.write_bytes(b"no database at all" * 1000)
    with Archive(filled) as archive:
        assert [note.subject for note in archive.notes] == ["index_damaged"]
        archive.refresh()
        assert archive.search().total == 3
    aside = list(filled.glob("archive.db.damaged-*"))
    assert len(aside) == 1
    assert aside[0].read_bytes().startswith(b"no database")
    with Archive(filled) as archive:
        assert archive.notes == ()
        assert archive.refresh().taken == 0


def test_damage_in_the_middle_of_the_index_is_noticed(filled: Path) -> None:
    index = filled / "archive.db"
    content = bytearray(index.read_bytes())
    for page in range(1, len(content) // 4096):
        content[page * 4096 : page * 4096 + 64] = b"\xff" * 64
    index.write_bytes(bytes(content))
    with Archive(filled) as archive:
        assert [note.subject for note in archive.notes] == ["index_damaged"]
        assert archive.refresh().taken == 3


def test_a_newer_index_is_shown_and_not_changed(filled: Path, triad: Calibration) -> None:
    with sqlite3.connect(filled / "archive.db") as connection:
        connection.execute("UPDATE archive_meta SET value = '9' WHERE key = 'schema'")
    connection.close()
    calibrated(triad, filled / "s9")
    with Archive(filled) as archive:
        assert archive.read_only
        assert "newer CalRig (schema 9" in archive.notes[0].text
        assert archive.search().total == 3
        archive.refresh()
        assert archive.search().total == 3
        with pytest.raises(StorageError, match="update CalRig"):
            archive.rebuild()


def test_an_index_of_the_first_version_is_brought_up_to_date(
    root: Path, triad: Calibration
) -> None:
    calibrated(triad, root / "a")
    with Archive(root) as archive:
        archive.refresh()
        place = archive.place.id
        rows = [archive.search().entries[0]]
    for side in ("", "-wal", "-shm"):
        (root / f"archive.db{side}").unlink(missing_ok=True)
    with sqlite3.connect(root / "archive.db") as connection:
        connection.executescript(V1)
        connection.execute("INSERT INTO archive_places VALUES (?, 'rig', 'x', 'y')", (place,))
        connection.execute(
            "INSERT INTO archive_entries VALUES (1, ?, 'a', 'a/calibration.cal.json', '', 'old',"
            " 'calibration', 'PW09', '', '', '', '', '', NULL, 'good', 3, '', '', 'pw09')",
            (place,),
        )
        connection.execute("INSERT INTO archive_folders VALUES (?, 'a', 5)", (place,))
        connection.execute(
            "INSERT INTO archive_quantities VALUES (1, 'acc_x', 'bias', 'U0', 'code', 1.0, 2.0, 0)"
        )
    connection.close()
    with Archive(root) as archive:
        stale = archive.search().entries[0]
        assert archive.quantities(stale)[0].dof == float("inf")
        archive.refresh()
        entry = archive.search().entries[0]
        assert entry.sha256 == rows[0].sha256
        assert archive.quantities(entry)[0].dof == pytest.approx(3.99, abs=0.01)
    with Archive(root) as archive:
        assert archive.refresh().taken == 0


VISITOR = """
import os, sys
from pathlib import Path
from core.archive.store import Archive
own = Path(sys.argv[2])
for _ in range(2):  # imports all there is to import
    with Archive(own) as archive:
        archive.refresh()
if os.geteuid() == 0:
    os.setresuid(65534, 65534, 65534)  # root may write anywhere: be somebody else
with Archive(Path(sys.argv[1])) as archive:
    archive.refresh()
    print(archive.search().total, *(note.subject for note in archive.notes))
"""


def test_a_read_only_folder_is_searched_and_stays_as_it_is(filled: Path, tmp_path: Path) -> None:
    before = {path: path.read_bytes() for path in filled.rglob("*") if path.is_file()}
    (tmp_path / "own").mkdir()
    for path in [filled, *filled.rglob("*")]:
        path.chmod(0o555 if path.is_dir() else 0o444)
    for path in [tmp_path, *tmp_path.parents]:
        if path.stat().st_mode & 0o055 != 0o055:
            path.chmod(path.stat().st_mode | 0o055)
    try:
        done = subprocess.run(
            [sys.executable, "-c", VISITOR, str(filled), str(tmp_path / "own")],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.stdout.split() == ["3", "read_only_folder"], done.stderr
    finally:
        for path in [filled, *filled.rglob("*")]:
            path.chmod(0o755 if path.is_dir() else 0o644)
    assert {path: path.read_bytes() for path in filled.rglob("*") if path.is_file()} == before


FILLER = """
import sys
from pathlib import Path
from core.archive.store import Archive
with Archive(Path(sys.argv[1])) as archive:
    print("open", flush=True)
    for _ in range(int(sys.argv[2])):
        archive.rebuild()
    print(archive.search().total)
"""


def program(root: Path, times: int) -> "subprocess.Popen[str]":
    command = [sys.executable, "-c", FILLER, str(root), str(times)]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)


def test_two_programs_at_once_neither_double_nor_lose(filled: Path) -> None:
    both = [program(filled, 5), program(filled, 5)]
    outputs = [one.communicate(timeout=60)[0].split() for one in both]
    assert [one.returncode for one in both] == [0, 0]
    # Between the other's forgetting and reading the count may be less; never more.
    assert all(int(output[-1]) <= 3 for output in outputs)
    with Archive(filled) as archive:
        archive.refresh()
        assert archive.search().total == 3


def test_two_programs_make_the_archive_of_a_new_folder_together(
    root: Path, triad: Calibration
) -> None:
    calibrated(triad, root / "a")
    both = [program(root, 1), program(root, 1)]
    for one in both:
        one.communicate(timeout=60)
        assert one.returncode == 0
    with Archive(root) as archive:
        assert archive.refresh().removed == 0
        assert archive.search().total == 1


@pytest.mark.slow
def test_a_program_killed_while_it_writes_loses_nothing(filled: Path, triad: Calibration) -> None:
    for number in range(30):
        calibrated(triad, filled / f"t{number}")
    for trial in range(8):
        writer = program(filled, 1000)
        assert writer.stdout is not None
        writer.stdout.readline()
        time.sleep(0.03 + 0.02 * trial)
        writer.send_signal(signal.SIGKILL)
        writer.wait()
        writer.stdout.close()
        with Archive(filled) as archive:
            assert archive.notes == ()
            archive.refresh()
            assert archive.search().total == 33


def test_a_writer_that_never_ends_is_told(filled: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("core.archive.database._WAIT_S", 0.2)
    with Archive(filled) as archive:
        other = sqlite3.connect(filled / "archive.db", isolation_level=None)
        other.execute("BEGIN IMMEDIATE")
        with pytest.raises(StorageError, match="another program has been writing"):
            archive.rebuild()
        assert archive.search().total == 3, "reading goes on meanwhile"
        other.execute("ROLLBACK")
        other.close()
        assert archive.rebuild().taken == 3


@pytest.mark.parametrize("url", ["", "no address", "mysql://someone@there/db"])
def test_an_address_that_is_none_is_refused_without_repeating_it(root: Path, url: str) -> None:
    if not url:
        (root / "archive.json").write_text("{}", "utf-8")
        with pytest.raises(Exception, match="calrig-archive"):
            Archive(root)
        return
    with pytest.raises(StorageError) as told:
        Archive(root, url)
    assert "someone" not in str(told.value)


def test_damage_that_cannot_even_be_quoted_is_set_aside(filled: Path) -> None:
    index = filled / "archive.db"
    content = index.read_bytes()
    at = content.index(b"CREATE TABLE")
    index.write_bytes(content[:at] + b"CRE\xfe\xffE TABLE" + content[at + 12 :])
    with Archive(filled) as archive:
        assert [note.subject for note in archive.notes] == ["index_damaged"]
        archive.refresh()
        assert archive.search().total == 3
