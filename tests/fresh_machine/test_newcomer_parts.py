"""The parts of the newcomer's walk that need no screen."""

from pathlib import Path

from tests.fresh_machine.newcomer import Done, complaints, leftovers
from tests.fresh_machine.screen import NEEDED, missing_packages


def test_what_a_program_without_faults_prints_is_no_complaint():
    said = (
        "bootstrap: installing the runtime packages\n"
        'qt.accessibility.atspi: applicationInterface does not implement "Get" "/root"\n'
    )
    assert complaints(said) == []
    wrong = "Traceback (most recent call last):\n  File x\nKeyError: 'a'\n"
    assert complaints(said + wrong)[-1] == "KeyError: 'a'"
    assert complaints("QPainter::begin: Paint device returned engine == 0\n")


def test_half_written_files_and_locks_are_told(tmp_path: Path):
    (tmp_path / "s").mkdir()
    for name in ("s/positions.jsonl", "s/session.lock", "a.json.tmp"):
        (tmp_path / name).write_text("12", "utf-8")
    (tmp_path / "free.lock").touch()
    assert leftovers(tmp_path) == ["a.json.tmp", "s/session.lock"]


def test_missing_packages_are_named_as_debian_does():
    assert missing_packages(lambda _name: True) == []
    assert missing_packages(lambda name: name != "import") == ["imagemagick"]
    assert missing_packages(lambda _name: False) == list(NEEDED.values())


def test_a_step_that_was_missed_stands_in_the_table():
    assert Done("The window opens", 1.25).line().endswith("1.2 s  ok")
    assert Done("The window opens", 1.0, "MISSED: nothing").line().endswith("MISSED: nothing")
