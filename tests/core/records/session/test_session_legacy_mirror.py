from dataclasses import replace

import pytest

from core.records.legacy.reader import read_legacy
from core.records.session.legacy_mirror import LegacyMirror
from core.records.session.store import Session


@pytest.fixture
def record(tmp_path, start, means, clock):
    """A session of three positions that has written no legacy text."""
    with Session.create(tmp_path / "s", replace(start, legacy=""), now=clock) as session:
        for step in start.plan.steps[:3]:
            session.accept(step, means(1.0))
        return session.record


def test_the_mirror_holds_the_rows_that_count(record, start):
    mirror = LegacyMirror(record.folder, start)
    mirror.append(record)
    assert mirror.path is not None
    whole = mirror.path.read_bytes()
    assert len(read_legacy(mirror.path)) == 3
    mirror.append(record)
    assert len(read_legacy(mirror.path)) == 4  # the newest row once more: it only appends
    mirror.rewrite(record)
    assert mirror.path.read_bytes() == whole
    assert mirror.check(record, "now") is None


def test_a_file_behind_is_made_anew_without_a_word(record, start):
    mirror = LegacyMirror(record.folder, start)
    assert mirror.check(record, "now") is None
    assert mirror.path is not None
    whole = mirror.path.read_bytes()
    mirror.path.write_bytes(whole[: len(whole) // 2])
    assert mirror.check(record, "now") is None
    assert mirror.path.read_bytes() == whole


def test_a_foreign_file_is_kept(record, start):
    mirror = LegacyMirror(record.folder, start)
    assert mirror.path is not None
    mirror.path.write_bytes(b"mine")
    note = mirror.check(record, "20240514093005")
    assert note is not None
    kept = record.folder / "OpticalDividingHead_202405140930.20240514093005.kept"
    assert kept.read_bytes() == b"mine"
    assert kept.name in note.text


def test_what_cannot_be_written_is_told_and_made_up_for(record, start):
    mirror = LegacyMirror(record.folder, start)
    assert mirror.path is not None
    mirror.path.mkdir()
    mirror.rewrite(record)
    assert "every position is stored" in str(mirror.error)
    mirror.path.rmdir()
    mirror.append(record)
    assert mirror.error is None
    assert len(read_legacy(mirror.path)) == 3


def test_no_layout_no_file(record):
    mirror = LegacyMirror(record.folder, record.start)
    mirror.append(record)
    mirror.rewrite(record)
    assert mirror.check(record, "now") is None
    assert mirror.path is None
    assert not list(record.folder.glob("*.txt"))
