import os
from pathlib import Path

from core.records.session.find import default_root, newest_session, unfinished
from core.records.session.store import Session


def test_unfinished_sessions_are_found_newest_first(tmp_path, start, means, clock):
    names = ("20240501_a", "20240502_b", "20240503_c")
    for name in names:
        session = Session.create(tmp_path / name, start, now=clock)
        session.accept(start.plan.steps[0], means(1.0))
        if name.endswith("b"):
            session.finish()
        session.close()
    (tmp_path / "20240504_d").mkdir()
    (tmp_path / "20240504_d" / "session.json").write_text("{")
    (tmp_path / "notes").mkdir()
    found = unfinished(tmp_path)
    assert [one.folder.name for one in found] == ["20240504_d", "20240503_c", "20240501_a"]
    assert "damaged JSON" in found[0].problem
    assert [one.done for one in found] == [0, 1, 1]
    assert found[1].record is not None


def test_there_is_nothing_where_there_is_no_root(tmp_path):
    assert unfinished(tmp_path / "none") == ()


def test_the_root_is_in_the_home_folder():
    assert default_root() == Path.home() / "CalRig"


def test_the_newest_session_of_a_test_with_positions(tmp_path, start, means, clock):
    assert newest_session(tmp_path / "none", "dividing_head") is None
    for place, name in enumerate(("b", "a", "empty")):
        session = Session.create(tmp_path / name, start, now=clock)
        if name != "empty":
            session.accept(start.plan.steps[0], means(1.0))
        session.close()
        os.utime(tmp_path / name / "session.json", (place, place))
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "session.json").write_text("{")
    assert newest_session(tmp_path, "dividing_head") == tmp_path / "a"
    assert newest_session(tmp_path, "rate_table") is None
