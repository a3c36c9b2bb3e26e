"""Folders of old files come into the archive, each once."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from core.archive.importing import DAMAGED_FILE, KNOWN, TAKEN, UNKNOWN, FileReport, import_folder
from core.archive.store import Archive
from core.errors import StorageError
from core.procedures.calibration import Calibration
from tests.core.archive.conftest import calibrated, measured

Copy = Callable[[Path], list[Path]]


def outcomes(reports: tuple[FileReport, ...]) -> dict[str, str]:
    return {report.path.name: report.outcome for report in reports}


def test_a_folder_is_taken_whole_and_told_file_by_file(
    archive: Archive, tmp_path: Path, specimens: Copy, triad: Calibration
) -> None:
    source = tmp_path / "old disk"
    specimens(source / "2024")
    measured(source / "sessions" / "20240514_PW09")
    calibrated(triad, source / "sessions" / "20240514_PW09")
    (source / "notes.txt").write_text("buy screws\n", "utf-8")
    (source / "RotationTable_202405151001.txt").write_text("torn", "utf-8")
    before = {path: path.stat().st_mtime_ns for path in source.rglob("*")}
    told: list[tuple[int, int]] = []
    reports = import_folder(archive, source, lambda done, of: told.append((done, of)))
    assert sorted(outcomes(reports).values()) == sorted([TAKEN] * 7 + [UNKNOWN, DAMAGED_FILE])
    assert outcomes(reports)["notes.txt"] == UNKNOWN
    assert told[-1] == (9, 9)
    assert archive.search().total == 8, "a session brings its calibration with it"
    clbacc = archive.search("colibrys").entries[0]
    assert clbacc.path == "imported/Colibrys/OpticalDividingHead_202405131405.txt"
    copy = archive.path_of(clbacc)
    assert copy.read_bytes() == (source / "2024" / copy.name).read_bytes()
    assert {path: path.stat().st_mtime_ns for path in source.rglob("*")} == before
    assert archive.rebuild().taken == 8, "the index can be made again from the copies"


def test_what_is_there_is_not_taken_twice(
    archive: Archive, tmp_path: Path, specimens: Copy
) -> None:
    specimens(tmp_path / "one")
    import_folder(archive, tmp_path / "one")
    shutil.copytree(tmp_path / "one", tmp_path / "two" / "renamed")
    for path in (tmp_path / "two" / "renamed").iterdir():
        path.rename(path.with_name(f"copy_{path.name}"))
    again = import_folder(archive, tmp_path / "two")
    assert set(outcomes(again).values()) == {KNOWN}
    assert archive.search().total == 6


def test_another_file_of_the_same_name_gets_a_number(
    archive: Archive, tmp_path: Path, specimens: Copy
) -> None:
    path = specimens(tmp_path / "one")[2]
    other = tmp_path / "two" / path.name
    other.parent.mkdir()
    lines = path.read_text("utf-8").splitlines(keepends=True)
    other.write_text("".join(lines[:-1]), "utf-8")
    import_folder(archive, tmp_path / "one")
    (report,) = import_folder(archive, tmp_path / "two")
    assert report.copy is not None
    assert report.copy.name == path.name.replace(".txt", "_2.txt")


def test_large_records_are_told_apart_by_their_bytes(archive: Archive, tmp_path: Path) -> None:
    for folder, tail in (("one", "1"), ("two", "1"), ("three", "2")):
        path = tmp_path / folder / "25-143.exp(001)_s_pr1.txt"
        path.parent.mkdir()
        path.write_text(f"FileVersion 1\n{tail}\n", "utf-8")
    found = [import_folder(archive, tmp_path / name)[0] for name in ("one", "two", "three")]
    assert [report.outcome for report in found] == [TAKEN, KNOWN, TAKEN]
    assert archive.search("25-143").total == 2


def test_folders_that_make_no_sense_are_refused(archive: Archive, tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="no such folder"):
        import_folder(archive, tmp_path / "none")
    (archive.place.root / "a").mkdir()
    with pytest.raises(StorageError, match="archive itself"):
        import_folder(archive, archive.place.root / "a")
    with pytest.raises(StorageError, match="holds the archive"):
        import_folder(archive, tmp_path)


def test_a_copy_is_on_the_disk_before_it_is_called_taken(
    archive: Archive, tmp_path: Path, specimens: Copy, monkeypatch: pytest.MonkeyPatch
) -> None:
    specimens(tmp_path / "old")
    measured(tmp_path / "old" / "session")
    synced: set[tuple[int, int]] = set()
    real = os.fsync

    def fsync(handle: int) -> None:
        stat = os.fstat(handle)
        synced.add((stat.st_dev, stat.st_ino))
        real(handle)

    monkeypatch.setattr(os, "fsync", fsync)
    reports = import_folder(archive, tmp_path / "old")
    copies = [report.copy for report in reports if report.copy is not None]
    files = [file for copy in copies for file in (copy, copy.parent, *copy.rglob("*"))]
    assert len(files) > 10
    missed = [one for one in files if (one.stat().st_dev, one.stat().st_ino) not in synced]
    assert (missed == []) or os.name == "nt"
