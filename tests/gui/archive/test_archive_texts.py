"""Numbers, dates and openings of the archive."""

from datetime import datetime
from pathlib import Path

import pytest

from core.archive.compare import Difference
from core.archive.entry import Entry
from core.archive.limits import Limit
from gui.archive.date_ticks import date_ticks
from gui.archive.opening import opening_of
from gui.archive.raw import RAW_READERS
from gui.archive.texts import compared_row, degrees, limits_text, local, table
from tests.core.archive.conftest import measured

DAY = 86400.0


def at(*date: int) -> float:
    return datetime(*date).timestamp()


@pytest.mark.parametrize(
    ("low", "high", "words"),
    [
        ((2019, 5, 1), (2024, 2, 1), ["2020", "2021", "2022", "2023", "2024"]),
        ((2024, 1, 10), (2024, 6, 10), ["2024-02", "2024-03", "2024-04", "2024-05", "2024-06"]),
        ((2024, 1, 10, 3), (2024, 1, 15), ["2024-01-11", "2024-01-12", "2024-01-13", "2024-01-14"]),
        ((2024, 1, 10, 3), (2024, 1, 10, 6), ["01-10 03:00", "01-10 04:00", "01-10 05:00"]),
        ((1950, 1, 1), (2050, 1, 2), ["1960", "1980", "2000", "2020", "2040"]),
    ],
)
def test_ticks_stand_on_whole_dates(
    low: tuple[int, ...], high: tuple[int, ...], words: list[str]
) -> None:
    ticks = date_ticks(at(*low), at(*high))
    found = [text for _, text in ticks]
    assert [text for text in found if text in words] == words
    assert len(found) <= 7
    assert all(at(*low) <= moment <= at(*high) for moment, _ in ticks)


@pytest.mark.parametrize("days", [0.01, 0.5, 3.0, 40.0, 400.0, 4000.0, 400000.0])
def test_there_are_never_too_many(days: float) -> None:
    low = at(1975, 3, 1)
    ticks = date_ticks(low, low + days * DAY, 4)
    assert 1 <= len(ticks) <= 5


def test_an_empty_axis_has_none() -> None:
    assert date_ticks(5.0, 5.0) == []


def test_limits_read_as_they_are_meant() -> None:
    assert limits_text(Limit("bias", "code", -5.0, 1e6)) == "\N{MINUS SIGN}5 … 1e+06"
    assert limits_text(Limit("bias", "code", high=2.5)) == "≤ 2.5"
    assert limits_text(Limit("bias", "code", low=2.5)) == "≥ 2.5"


def test_unknown_numbers_are_left_out() -> None:
    assert degrees(float("nan")) == ""
    assert local("") == ""
    row = Difference("x", "cross_axis_y", "k", "V", 1.0, 2.0, 1.0, float("nan"))
    assert compared_row(row)[1:4] == ("cross axis y", "", "—")


def test_a_table_stands_in_columns() -> None:
    assert table(("a", "b"), [("long", "1"), ("x", "22")]) == "a     b\nlong  1\nx     22"


def test_every_entry_opens_where_it_belongs(tmp_path: Path) -> None:
    session = measured(tmp_path / "s")
    calibration = session / "a.cal.json"
    assert opening_of(Entry("session", "s", "A"), session) == ("Dividing head", session)
    assert opening_of(Entry("calibration", "c", "A"), calibration) == ("Dividing head", session)
    assert opening_of(Entry("calibration", "c", "A"), tmp_path / "a.cal.json") is None
    path = tmp_path / "x.txt"
    old = Entry("legacy", "x", "A", sensor="gyro", what="rotation_table")
    assert opening_of(old, path) == ("Rate table", path)
    assert opening_of(Entry("run", "x", "A", what="accuracy"), path) == ("Accuracy", path)
    assert opening_of(Entry("record", "x", "A"), path) == ("Allan", path)
    assert opening_of(Entry("noise", "x", "A"), path) is None
    assert opening_of(Entry("session", "x", "A", verdict="damaged"), session) is None


def test_raw_logs_are_known_by_their_header(tmp_path: Path) -> None:
    from drivers.rawlog import RawLog

    path = tmp_path / "x.calrec"
    log = RawLog(path, {"device": "PW09", "profile": "pw09_raw"})
    log.close()
    (found,) = RAW_READERS[".calrec"](path)
    assert (found.entry.serial, found.entry.what, found.entry.profile) == (
        "PW09",
        "raw",
        "pw09_raw",
    )
    assert found.entry.when is not None
