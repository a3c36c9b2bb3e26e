"""Each fault a few times, in real processes where it matters; the long run does the same often.

Nothing that was accepted on the screen may be missing on the disk, no good frame may be there
twice or be made up, and what cannot be kept must be told.
"""

import random
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.reliability import disks, nursery
from tests.reliability.fault import Found
from tests.reliability.killed import record_kept, session_kept
from tests.reliability.matrix import FAULTS

pytestmark = [pytest.mark.slow]

QUIET = ("times",)
"""Faults of which nothing has to be said, as nothing comes of them."""


@pytest.fixture
def place() -> Iterator[Path]:
    """A folder that every user may reach, unlike pytest's own."""
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


@pytest.mark.parametrize("name", [name for name, fault in FAULTS.items() if fault.few])
def test_nothing_is_lost(name: str, place: Path):
    fault = FAULTS[name]
    found = fault.run(place, random.Random(name), fault.few)
    assert (found.trials, found.lost) == (fault.few, 0)
    assert bool(found.message) == (name not in QUIET)


@pytest.mark.parametrize("room", [0, 3_000, 40_000])
def test_a_full_disk_loses_nothing_and_is_told(place: Path, room: int):
    found = disks.on_a_full_disk(place / "disk", room, disks.WORDS)
    assert [one.lost for one in found] == [0] * len(disks.WORDS)
    words = ("cannot be written", "cannot be kept", "disk")
    assert all(any(word in one.message for word in words) for one in found), found


def test_files_that_may_not_grow_where_nothing_can_be_mounted(
    place: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(disks, "can_mount", lambda: False)
    found = disks.on_a_full_disk(place / "disk", 2_000, disks.WORDS)
    assert [one.lost for one in found] == [0] * len(disks.WORDS)


def test_a_read_only_folder_is_told_and_stays_as_it_is(place: Path):
    found = disks.in_a_read_only_folder(place / "folder", disks.WORDS)
    assert [one.lost for one in found] == [0] * len(disks.WORDS)
    words = ("Permission denied", "may not be written to")
    assert all(any(word in one.message for word in words) for one in found), found


# ---- the matrix itself must be able to fail


def test_a_promise_that_was_not_kept_is_counted(place: Path):
    victims = nursery.nursery()
    for name, check in (("measure", session_kept), ("record", record_kept)):
        folder = place / name
        folder.mkdir()
        victim = victims.start(name, folder, place / f"{name}.txt")
        victim.wait_for(3)
        told = victim.kill(random.Random(1), 0.01)
        assert check(folder, told).lost == 0
        more = "9999 1.0" if name == "measure" else "99999999"
        assert check(folder, [*told, more]).lost > 0


def test_outcomes_add_up():
    assert Found(1, 0, "a") + Found(2, 3, "longer") == Found(3, 3, "longer")
