"""The laboratory as a text file written by hand."""

import tomllib
from pathlib import Path

import pytest

from core.certificates.laboratory import Laboratory, Standard, write_laboratory
from core.certificates.laboratory_file import TEMPLATE, open_laboratory, write_template
from core.errors import FormatError, StorageError


def test_the_template_states_nothing_and_is_asked_for_everything(tmp_path: Path):
    path = tmp_path / "laboratory.toml"
    write_template(path)
    assert open_laboratory(path) == Laboratory()
    assert len(open_laboratory(path).missing()) == 4


def test_its_comments_filled_in_are_a_whole_laboratory(tmp_path: Path):
    path = tmp_path / "laboratory.toml"
    head, _, block = TEMPLATE.partition("# [[standards]]")
    examples = "\n".join(line.removeprefix("# ") for line in f"[[standards]]{block}".splitlines())
    stated = head.replace('name = ""', 'name = "Laboratory"', 1)
    stated = stated.replace('address = ""', 'address = "Kyiv"')
    stated = stated.replace('authorised_by = ""', 'authorised_by = "O. P."')
    path.write_text(stated + examples, "utf-8")
    found = open_laboratory(path)
    assert found.missing() == ()
    assert found.standards == (
        Standard("optical dividing head", "114", "UA/24/0118", "2027-03-01", "national institute"),
    )
    assert set(tomllib.loads(TEMPLATE)) == set(Laboratory.__slots__) - {"standards"}


def test_what_does_not_apply_may_be_left_out(tmp_path: Path):
    path = tmp_path / "lab.toml"
    path.write_text('name = "L"\n[[standards]]\nname = "head"\nvalid_until = 2027-03-01\n', "utf-8")
    found = open_laboratory(path)
    assert (found.name, found.number) == ("L", "{year}-{n:04d}")
    assert found.standards == (Standard("head", valid_until="2027-03-01"),)


def test_everything_that_is_wrong_is_told_at_once(tmp_path: Path):
    path = tmp_path / "lab.toml"
    path.write_text('nmae = "L"\n[[standards]]\nserail = "1"\n', "utf-8")
    with pytest.raises(FormatError, match=r"nmae, standards\[0\]\.serail; known are name, address"):
        open_laboratory(path)
    path.write_text("name = 5\naddress = true\n[[standards]]\n", "utf-8")
    with pytest.raises(FormatError) as told:
        open_laboratory(path)
    assert "not stated: standards[0].name" in told.value.why
    assert "name must be a text, found 5" in told.value.why
    assert "address must be a text, found True" in told.value.why
    path.write_text("name = ", "utf-8")
    with pytest.raises(FormatError, match="is no TOML"):
        open_laboratory(path)


def test_the_window_s_file_is_taken_too(laboratory: Laboratory, tmp_path: Path):
    path = tmp_path / "laboratory.json"
    write_laboratory(laboratory, path)
    assert open_laboratory(path) == laboratory
    with pytest.raises(FormatError, match="--template"):
        open_laboratory(tmp_path / "none.json")


def test_the_template_writes_over_nothing(tmp_path: Path):
    path = tmp_path / "laboratory.toml"
    path.write_text('name = "mine"', "utf-8")
    with pytest.raises(StorageError, match="is there already"):
        write_template(path)
    assert path.read_text("utf-8") == 'name = "mine"'
    with pytest.raises(FormatError, match=r"name it lab\.toml"):
        write_template(tmp_path / "lab.json")
