"""Which folders have changed since the last look."""

import os
from pathlib import Path

from core.archive.scan import QUIET_S, UNSETTLED, Changes, scan

NOW = 1_900_000_000.0


def known(changes: Changes) -> dict[str, int]:
    return {folder.path: folder.mtime for folder in changes.folders}


def names(changes: Changes) -> dict[str, list[str]]:
    return {folder.path: sorted(item.path for item in folder.items) for folder in changes.folders}


def test_only_changed_folders_are_listed_again(tmp_path: Path) -> None:
    for name in ("a", "b/deep"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "x.txt").write_text("1", "utf-8")
    first = scan(tmp_path, {}, NOW)
    assert names(first) == {"": [], "a": ["a/x.txt"], "b": [], "b/deep": ["b/deep/x.txt"]}
    assert scan(tmp_path, known(first), NOW) == Changes((), ())
    (tmp_path / "b" / "deep" / "y.txt").write_text("1", "utf-8")
    os.utime(tmp_path / "b" / "deep", ns=(5, 5))
    assert names(scan(tmp_path, known(first), NOW)) == {"b/deep": ["b/deep/x.txt", "b/deep/y.txt"]}
    (tmp_path / "a" / "x.txt").unlink()
    (tmp_path / "a").rmdir()
    gone = scan(tmp_path, known(first), NOW).gone
    assert gone == ("a",)


def test_where_something_was_just_written_is_looked_at_again(tmp_path: Path) -> None:
    path = tmp_path / "growing.txt"
    path.write_text("1", "utf-8")
    os.utime(path, (NOW, NOW))
    soon = scan(tmp_path, {}, NOW + 1.0)
    assert known(soon) == {"": UNSETTLED}
    path.write_text("12", "utf-8")
    os.utime(path, (NOW, NOW))
    again = scan(tmp_path, known(soon), NOW + 1.0)
    assert again.folders[0].items != soon.folders[0].items
    assert known(scan(tmp_path, {}, NOW + QUIET_S + 1.0))[""] != UNSETTLED


def test_a_session_is_one_item_and_its_copies_are_none(tmp_path: Path) -> None:
    for name in ("session.json", "positions.jsonl", "a.run.csv", "OpticalDividingHead_1.txt"):
        (tmp_path / name).write_text("1", "utf-8")
    (tmp_path / "calibration.cal.json").write_text("1", "utf-8")
    assert names(scan(tmp_path, {}, NOW)) == {"": ["", "calibration.cal.json"]}


def test_the_index_drafts_and_hidden_folders_are_no_items(tmp_path: Path) -> None:
    for name in ("archive.db", "archive.db-wal", "archive.json", ".draft.tmp"):
        (tmp_path / name).write_text("1", "utf-8")
    for name in (".git", ".Gyro_Data"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "x.txt").write_text("1", "utf-8")
    assert names(scan(tmp_path, {}, NOW)) == {"": [], ".Gyro_Data": [".Gyro_Data/x.txt"]}
