"""The whole story as a file, without a window."""

from pathlib import Path

import pytest

from gui.commands.table import run_command


def test_explain_writes_the_report_beside_its_words(
    bent_file: Path, qapp: object, capsys: pytest.CaptureFixture[str]
):
    page, paper = bent_file.with_name("story.html"), bent_file.with_name("story.pdf")
    assert run_command("explain", [str(bent_file), "--report", str(page)]) == 0
    assert f"report in {page}" in capsys.readouterr().out
    text = page.read_text(encoding="utf-8")
    assert "Second-order nonlinearity K2" in text
    assert "Cannot be told from: Head eccentricity" in text
    assert run_command("explain", [str(bent_file), "--report", str(paper)]) == 0
    assert paper.read_bytes().startswith(b"%PDF")


def test_a_report_of_another_kind_is_refused(bent_file: Path, capsys: pytest.CaptureFixture[str]):
    assert run_command("explain", [str(bent_file), "--report", str(bent_file)]) != 0
    assert ".html or .pdf" in capsys.readouterr().err
