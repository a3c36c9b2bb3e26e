"""What goes into the tables comes out of them."""

import math
from pathlib import Path

import pytest

from core.archive import search
from core.archive.entry import Entry, Found, Quantity
from core.archive.store import Archive
from core.archive.tables import MIGRATIONS, TABLES, VERSION


def put(archive: Archive, *found: Found) -> None:
    with archive._writing() as connection:
        search.store(connection, archive.place.id, [("", "s", one) for one in found])


def test_entries_come_back_as_they_went_in(archive: Archive) -> None:
    entry = Entry("calibration", "a/b.cal.json", "Ц-17", sensor="gyro", what="q", count=3)
    quantities = (
        Quantity("x", "bias", "U0", "code", 1.25e-17, 3.0, 4.5),
        Quantity("x", "scale_factor", "k", "code", -2.0, math.nan, math.inf),
    )
    put(archive, Found(entry, quantities))
    found = archive.search().entries[0]
    assert (found.serial, found.sensor, found.count, found.place) == (
        "Ц-17",
        "gyro",
        3,
        archive.place.id,
    )
    assert math.isnan(found.temperature_c)
    again = archive.quantities(found)
    assert again[0] == quantities[0]
    assert math.isnan(again[1].u)
    assert math.isinf(again[1].dof)


@pytest.mark.parametrize("text", ["100%", "a_b", "x\\y"])
def test_signs_of_patterns_are_searched_as_they_stand(archive: Archive, text: str) -> None:
    put(
        archive,
        Found(Entry("run", "1", f"unit {text}")),
        Found(Entry("run", "2", "unit 100 axb xzy")),
    )
    assert [entry.path for entry in archive.search(text).entries] == ["1"]


def test_a_zero_character_and_a_doubled_name_do_no_harm(archive: Archive) -> None:
    twice = Quantity("x", "bias", "U0", "code", 1.0, 1.0)
    put(archive, Found(Entry("run", "1", "PW\0 09"), (twice, twice)))
    found = archive.search("pw 09").entries[0]
    assert found.serial == "PW 09"
    assert len(archive.quantities(found)) == 1


def test_quantities_go_with_their_entry(archive: Archive, root: Path) -> None:
    put(archive, Found(Entry("run", "1", "A"), (Quantity("x", "b", "b", "V", 1.0, 1.0),)))
    assert len(archive.readings("A", "b", "x")) == 1
    archive.rebuild()
    assert archive.readings("A", "b", "x") == ()


def test_a_calibration_that_was_exported_counts_once(archive: Archive) -> None:
    found = (Quantity("x", "bias", "U0", "code", 1.0, 1.0),)
    same = {"serial": "A", "sha256": "ab"}
    put(archive, *(Found(Entry("calibration", path, **same), found) for path in ("1", "2")))
    other = Entry("calibration", "3", **{**same, "sha256": "cd"})
    put(archive, Found(other, found), Found(Entry("run", "4", **same)))
    assert sorted(entry.path for entry in archive.search().entries) == ["1", "3", "4"]
    assert archive.search().total == 3
    assert len(archive.readings("A", "bias", "x")) == 2


def test_every_earlier_version_has_its_migration() -> None:
    assert set(MIGRATIONS) == set(range(1, VERSION))
    assert all(table.startswith("archive_") for table in TABLES.tables)
