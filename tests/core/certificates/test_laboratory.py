"""The laboratory's file, and the pattern of its numbers."""

from dataclasses import replace
from pathlib import Path

import pytest

from core.certificates.laboratory import (
    FILE,
    Laboratory,
    read_laboratory,
    write_laboratory,
)
from core.errors import FormatError


def test_it_comes_back_as_it_was_written(laboratory: Laboratory, tmp_path: Path):
    write_laboratory(laboratory, tmp_path / FILE)
    assert read_laboratory(tmp_path / FILE) == laboratory


def test_without_a_file_nothing_is_stated_and_everything_is_asked_for(tmp_path: Path):
    empty = read_laboratory(tmp_path / FILE)
    assert empty == Laboratory()
    assert len(empty.missing()) == 4


def test_what_is_stated_is_not_asked_for(laboratory: Laboratory):
    assert laboratory.missing() == ()
    assert replace(laboratory, standards=()).missing() == ("standards and their traceability",)


def test_all_that_is_missing_is_told_at_once(tmp_path: Path):
    document = '"schema": "calrig-laboratory", "schema_version": 1, "name": "L", "place": 5'
    (tmp_path / FILE).write_text(f'{{{document}, "standards": [{{"name": "head"}}]}}', "utf-8")
    with pytest.raises(FormatError) as told:
        read_laboratory(tmp_path / FILE)
    assert told.value.why.startswith(
        "not stated: address, accreditation, logo, authorised_by, position, number, statement,"
        " standards[0].serial, standards[0].certificate, standards[0].valid_until,"
        " standards[0].traceable_to; what does not apply stays an empty text"
    )
    assert told.value.why.endswith("place must be a text, found 5")


def test_another_file_is_refused_by_name(tmp_path: Path):
    (tmp_path / FILE).write_text('{"schema": "calrig-session"}', encoding="utf-8")
    with pytest.raises(FormatError, match=r"laboratory\.json.*is no calrig-laboratory"):
        read_laboratory(tmp_path / FILE)


def test_the_pattern_fills_year_and_number(laboratory: Laboratory):
    assert laboratory.number_of(2026, 7) == "2026-0007"
    assert replace(laboratory, number="K{n}/{year}").number_of(2026, 12) == "K12/2026"


@pytest.mark.parametrize("pattern", ["{year}", "{year}-{m}", "{n:q}", "{"])
def test_a_pattern_that_cannot_number_is_refused(laboratory: Laboratory, pattern: str):
    with pytest.raises(FormatError, match="pattern"):
        replace(laboratory, number=pattern).number_of(2026, 1)
