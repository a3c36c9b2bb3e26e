"""What is remembered, and what a damaged file costs."""

from pathlib import Path

import pytest

from core.errors import StorageError
from gui.settings import Settings, number_of, text_of


def test_a_round_trip(tmp_path: Path):
    path = tmp_path / "new" / "settings.json"
    settings = Settings(path)
    settings.store("window", {"look": "dark", "size": [1, 2]})
    settings.save()
    again = Settings(path)
    assert again.section("window") == {"look": "dark", "size": [1, 2]}
    assert again.section("none") == {}
    assert again.doubt == ""


@pytest.mark.parametrize("text", ["{half", "[]", '{"window": 3}', "\xff"])
def test_a_damaged_file_gives_the_defaults(tmp_path: Path, text: str):
    path = tmp_path / "settings.json"
    path.write_text(text, encoding="latin-1")
    assert Settings(path).section("window") == {}


def test_values_are_checked_by_who_reads_them():
    section = {"g": 9.81, "flag": True, "text": "x", "far": 1e9}
    assert number_of(section, "g", 0.0, 9, 10) == 9.81
    assert number_of(section, "flag", 5.0, 0, 10) == 5.0
    assert number_of(section, "far", 5.0, 0, 10) == 5.0
    assert number_of(section, "text", 5.0, 0, 10) == 5.0
    assert text_of(section, "text") == "x"
    assert text_of(section, "g", "y") == "y"


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    settings = Settings(tmp_path / "file" / "settings.json")
    with pytest.raises(StorageError):
        settings.save()
