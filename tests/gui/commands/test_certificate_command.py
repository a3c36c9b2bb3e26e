"""``calrig certificate``: numbers, files, what is missing."""

import json
from pathlib import Path

import pytest

from core.certificates.laboratory import Laboratory, Standard, write_laboratory
from core.certificates.register import Register
from gui.commands.table import REFUSED, run_command

SPECIMENS = Path(__file__).parents[2] / "data" / "legacy"
HEAD = str(SPECIMENS / "OpticalDividingHead_202405140930.txt")
ORDER = """
[order]
customer = "Plant"
contact = "O. Ivanenko"
item = "inclinometer"
condition = "as new"
calibrated = 2026-11-20
issued = 2026-11-22
[surroundings]
temperature_c = 22.5
[[conformity.limit]]
parameter = "bias"
limit = 1e9
"""


@pytest.fixture
def arguments(tmp_path: Path) -> list[str]:
    standards = (Standard("head", "1", "UA-1", "2027-01-01", "institute"),)
    laboratory = Laboratory("Laboratory", "Kyiv", authorised_by="O. P.", standards=standards)
    write_laboratory(laboratory, tmp_path / "lab.json")
    (tmp_path / "order.toml").write_text(ORDER, encoding="utf-8")
    return [
        *("--laboratory", str(tmp_path / "lab.json")),
        *("--out", str(tmp_path / "out")),
    ]


def test_a_complete_certificate_is_issued(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    order = ["--order", str(tmp_path / "order.toml"), "--json", str(tmp_path / "answer.json")]
    assert run_command("certificate", [HEAD, *arguments, *order]) == 0
    assert "No. 2026-0001" in capsys.readouterr().out
    answer = json.loads((tmp_path / "answer.json").read_text(encoding="utf-8"))
    assert answer["verdict"] == "pass"
    assert answer["missing"] == []
    assert all(Path(path).is_file() for path in answer["files"])
    html = Path(answer["files"][2]).read_text(encoding="utf-8")
    assert "Plant, O. Ivanenko" in html
    assert "Decision rule" in html
    assert run_command("certificate", [HEAD, *arguments, *order]) == 0
    numbers = [one.number for one in Register(tmp_path / "out").entries()]
    assert numbers == ["2026-0002", "2026-0001"]


def test_what_is_missing_is_told_and_a_draft_takes_no_number(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    assert run_command("certificate", [HEAD, *arguments, "--draft"]) == 1
    assert "missing: customer" in capsys.readouterr().out
    assert Register(tmp_path / "out").entries() == ()
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "draft.html",
        "draft.pdf",
    ]


def test_a_limit_that_is_not_kept_ends_with_1(arguments: list[str], tmp_path: Path):
    text = ORDER.replace("1e9", "1e-9")
    (tmp_path / "order.toml").write_text(text, encoding="utf-8")
    order = ["--order", str(tmp_path / "order.toml")]
    assert run_command("certificate", [HEAD, *arguments, *order]) == 1


def test_a_template_filled_in_is_the_laboratory(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path = tmp_path / "laboratory.toml"
    assert run_command("certificate", ["--template", str(path)]) == 0
    assert "to be filled in" in capsys.readouterr().out
    text = path.read_text("utf-8").replace('name = ""', 'name = "Laboratory Nine"', 1)
    path.write_text(text, "utf-8")
    out = tmp_path / "out"
    stated = ["--laboratory", str(path), "--out", str(out), "--draft"]
    assert run_command("certificate", [HEAD, *stated]) == 1
    told = capsys.readouterr().out
    assert "missing: address of the laboratory" in told
    assert "missing: name of the laboratory" not in told
    assert "Laboratory Nine" in (out / "draft.html").read_text("utf-8")


def test_what_cannot_be_is_refused(
    arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    assert run_command("certificate", [HEAD, "--laboratory", str(tmp_path / "no.json")]) == REFUSED
    assert "is not there" in capsys.readouterr().err
    assert run_command("certificate", []) == REFUSED
    assert "give FILE and --laboratory, or --template" in capsys.readouterr().err
    missing = str(tmp_path / "nothing.txt")
    assert run_command("certificate", [missing, *arguments]) == REFUSED
    assert not (tmp_path / "out").exists()
