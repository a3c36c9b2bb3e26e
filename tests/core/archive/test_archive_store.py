"""The archive follows its folder: what is new, changed, moved, gone, damaged."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from core.archive.entry import DAMAGED, FINISHED, OPEN
from core.archive.place import same_place
from core.archive.store import Archive
from core.errors import StorageError
from core.procedures.calibration import Calibration
from core.records.session.store import Session
from tests.core.archive.conftest import calibrated, measured, old


def paths(archive: Archive) -> set[str]:
    return {entry.path for entry in archive.search().entries}


def test_sessions_calibrations_and_old_files_are_found_by_what_is_known_of_them(
    archive: Archive,
    root: Path,
    triad: Calibration,
    specimens: Callable[[Path], list[Path]],
) -> None:
    measured(root / "20240514_0930_PW09")
    calibrated(triad, root / "20240514_0930_PW09", when="2024-05-14T06:30:05+00:00")
    measured(root / "20240601_PW10", device="PW10", operator="Іван", finish=False)
    specimens(root / "old")
    assert archive.refresh().taken == 3 + 6
    hits = archive.search("pw09 олена")
    assert [entry.kind for entry in hits.entries] == ["calibration", "session"]
    assert hits.total == 2
    session = hits.entries[1]
    assert (session.serial, session.what, session.count) == ("PW09", "pointer_8", 2)
    assert (session.verdict, session.profile) == (FINISHED, "pw09_raw")
    assert session.measured == "2024-05-14T06:30:05+00:00"
    assert session.temperature_c == pytest.approx(26.0)
    assert archive.search("ІВАН").entries[0].verdict == OPEN
    assert {entry.serial for entry in archive.search(kinds=["legacy"]).entries} >= {"Colibrys"}
    assert archive.search("2024-05-14 pointer session").total == 2
    assert archive.search("100%").total == 0
    assert archive.search(limit=2).total == 9


def test_a_second_look_reads_nothing_again(
    archive: Archive, root: Path, triad: Calibration
) -> None:
    calibrated(triad, root / "a")
    measured(root / "b")
    first = archive.refresh()
    assert (first.taken, first.removed) == (2, 0)
    before = [entry.id for entry in archive.search().entries]
    assert archive.refresh().taken == 0
    assert [entry.id for entry in archive.search().entries] == before


def test_a_quiet_folder_is_known_by_its_time_alone(
    archive: Archive, root: Path, triad: Calibration
) -> None:
    path = calibrated(triad, root / "a")
    old(root)
    archive.refresh()
    inside = path.read_text("utf-8")
    path.write_text(inside.replace("PW09", "PW77"), "utf-8")
    os.utime(path.parent, (path.parent.stat().st_atime, path.parent.stat().st_mtime))
    archive.refresh()
    assert archive.search("PW77").total == 0, "a folder that lies still is not listed"
    calibrated(triad, root / "a", device="PW78")
    archive.refresh()
    assert [entry.serial for entry in archive.search().entries] == ["PW78"]


def test_a_session_that_goes_on_is_followed(archive: Archive, root: Path) -> None:
    folder = measured(root / "s", finish=False)
    archive.refresh()
    session = Session.open(folder)
    session.finish()
    session.close()
    archive.refresh()
    found = archive.search().entries
    assert [(entry.kind, entry.verdict) for entry in found] == [("session", FINISHED)]


def test_what_is_gone_is_forgotten_and_comes_back_from_the_files(
    archive: Archive, root: Path, triad: Calibration, tmp_path: Path
) -> None:
    calibrated(triad, root / "a")
    calibrated(triad, root / "deep" / "b")
    archive.refresh()
    shutil.move(root / "deep", tmp_path / "deep")
    assert archive.refresh().removed == 1
    assert paths(archive) == {"a/calibration.cal.json"}
    shutil.move(tmp_path / "deep", root / "deep")
    archive.refresh()
    assert paths(archive) == {"a/calibration.cal.json", "deep/b/calibration.cal.json"}
    again = archive.rebuild()
    assert again.taken == 2


def test_the_folder_can_be_moved(root: Path, triad: Calibration, tmp_path: Path) -> None:
    calibrated(triad, root / "a")
    with Archive(root) as archive:
        archive.refresh()
        before = archive.search().entries
    moved = tmp_path / "elsewhere" / "Records"
    moved.parent.mkdir()
    shutil.move(root, moved)
    with Archive(moved) as archive:
        assert archive.search().entries == before
        assert archive.refresh().removed == 0
        assert archive.path_of(before[0]) == moved / "a" / "calibration.cal.json"


def test_a_damaged_calibration_is_listed_with_its_reason(
    archive: Archive, root: Path, triad: Calibration
) -> None:
    path = calibrated(triad, root / "a")
    path.write_text(path.read_text("utf-8")[:300], "utf-8")
    damaged = archive.refresh().damaged
    assert [entry.path for entry in damaged] == ["a/calibration.cal.json"]
    entry = archive.search("damaged").entries[0]
    assert entry.verdict == DAMAGED
    assert "line" in entry.remark


def test_a_file_that_is_gone_or_a_number_that_is_none_is_told(
    archive: Archive, root: Path, triad: Calibration
) -> None:
    path = calibrated(triad, root / "a")
    archive.refresh()
    entry = archive.search().entries[0]
    assert archive.entry(entry.id) == entry
    path.unlink()
    with pytest.raises(StorageError, match="no longer there"):
        archive.path_of(entry)
    with pytest.raises(StorageError, match="nothing of the number 999"):
        archive.entry(999)


def test_a_folder_that_is_not_there_is_no_empty_archive(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="connect the disk"):
        Archive(tmp_path / "usb")


def test_progress_is_told_and_may_break_off_without_loss(root: Path, triad: Calibration) -> None:
    for number in range(450):
        calibrated(triad, root / f"s{number:03d}")
    told: list[tuple[int, int]] = []

    class EnoughError(Exception):
        pass

    def enough(done: int, of: int) -> None:
        told.append((done, of))
        raise EnoughError

    with Archive(root) as archive:
        with pytest.raises(EnoughError):
            archive.refresh(enough)
        assert told == [(200, 451)]
        before = archive.search().total
        assert 199 <= before <= 200
        assert archive.refresh(lambda *_: None).taken == 450 - before
        assert archive.search().total == 450


def test_a_folder_that_is_gone_or_another_one_is_not_forgotten(
    root: Path, triad: Calibration
) -> None:
    calibrated(triad, root / "a")
    moved = root.parent / "moved"
    with Archive(root) as archive:
        archive.refresh()
        number = archive.search().entries[0].id
        root.rename(moved)
        assert not same_place(archive.place)
        with pytest.raises(StorageError, match="connect the disk"):
            archive.refresh()
        root.mkdir()
        (root / "archive.json").write_text(
            (moved / "archive.json").read_text("utf-8").replace(archive.place.id, "another"),
            "utf-8",
        )
        with pytest.raises(StorageError, match="another archive stands there now"):
            archive.refresh()
        assert archive.search().total == 1
    with Archive(moved) as archive:
        assert archive.refresh().taken == 0
        assert archive.search().entries[0].id == number
