"""How every subcommand runs: its answer, its JSON, its errors."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from gui.commands.table import COMMANDS, REFUSED, Entry, run_command

ROOT = Path(__file__).resolve().parents[3]

COMMAND = '''
"""Weighs what it is given."""

from core.errors import FormatError
from gui.commands.answer import Answer


def add_arguments(parser):
    parser.add_argument("what")


def run(args):
    if args.what == "broken.txt":
        raise FormatError("broken.txt", "'12,x' is no number", line=3, column=8)
    if args.what == "interrupted":
        raise KeyboardInterrupt
    if args.what == "bug":
        raise ZeroDivisionError("a fault of ours")
    if args.what == "light":
        return Answer({"grams": 1}, "light", code=1)
    with open(args.what, encoding="utf-8") as file:
        return Answer({"grams": len(file.read())}, "Вага: 5 µg")
'''


@pytest.fixture
def weigh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A subcommand of its own, found by the table as any other."""
    (tmp_path / "weighing_command.py").write_text(COMMAND, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setitem(COMMANDS, "weigh", Entry("weighing_command", "weigh a file"))
    monkeypatch.chdir(tmp_path)
    Path("stone").write_text("12345", encoding="utf-8")
    yield "weigh"
    sys.modules.pop("weighing_command", None)


def test_the_text_goes_to_standard_output(weigh: str, capsys: pytest.CaptureFixture[str]):
    assert run_command(weigh, ["stone"]) == 0
    assert capsys.readouterr().out == "Вага: 5 µg\n"


def test_json_on_standard_output_is_nothing_but_json(
    weigh: str, capsys: pytest.CaptureFixture[str]
):
    assert run_command(weigh, ["stone", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out) == {"grams": 5}


def test_json_in_a_file_stands_beside_the_text(weigh: str, capsys: pytest.CaptureFixture[str]):
    Path("out.json").write_text("old", encoding="utf-8")
    assert run_command(weigh, ["stone", "--json", "out.json"]) == 0
    assert json.loads(Path("out.json").read_text(encoding="utf-8")) == {"grams": 5}
    assert "5" in capsys.readouterr().out
    assert [path.name for path in Path().glob(".*")] == []


def test_a_result_of_no_gives_its_own_exit_code(weigh: str, capsys: pytest.CaptureFixture[str]):
    assert run_command(weigh, ["light"]) == 1
    assert capsys.readouterr().err == ""


def test_an_unreadable_file_is_one_line_that_says_where(
    weigh: str, capsys: pytest.CaptureFixture[str]
):
    assert run_command(weigh, ["broken.txt", "--json", "out.json"]) == 2
    message = capsys.readouterr()
    assert message.err == "calrig weigh: broken.txt, line 3, column 8: '12,x' is no number\n"
    assert message.out == ""
    assert not Path("out.json").exists()


def test_a_missing_file_is_named(weigh: str, capsys: pytest.CaptureFixture[str]):
    assert run_command(weigh, ["feather"]) == 2
    assert capsys.readouterr().err == "calrig weigh: feather: No such file or directory\n"


def test_an_output_that_cannot_be_written_is_named(weigh: str, capsys: pytest.CaptureFixture[str]):
    assert run_command(weigh, ["stone", "--json", "nowhere/out.json"]) == 2
    assert capsys.readouterr().err.startswith("calrig weigh: nowhere/out.json: cannot be written")


def test_ctrl_c_leaves_no_traceback(weigh: str, capsys: pytest.CaptureFixture[str]):
    assert run_command(weigh, ["interrupted"]) == 130
    assert capsys.readouterr().err == "calrig weigh: interrupted\n"


def test_a_fault_of_ours_is_not_hidden(weigh: str):
    with pytest.raises(ZeroDivisionError):
        run_command(weigh, ["bug"])


def test_wrong_arguments_end_with_the_usage_of_that_command(
    weigh: str, capsys: pytest.CaptureFixture[str]
):
    with pytest.raises(SystemExit) as end:
        run_command(weigh, [])
    assert end.value.code == 2
    assert "usage: calrig weigh" in capsys.readouterr().err


def test_a_console_of_another_code_page_still_gets_every_line():
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONPATH": str(ROOT)}
    program = (
        "from gui.commands.answer import Answer; from gui.commands import table;"
        "table._give(Answer({}, '5 µg'), None)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], env=environment, capture_output=True, check=False
    )
    assert done.stdout.split() == [b"5", rb"\xb5g"]
    assert done.returncode == 0


def test_a_reader_that_goes_away_leaves_no_traceback(weigh: str):
    program = (
        "import sys; from gui.commands.table import COMMANDS, Entry, run_command;"
        "COMMANDS['weigh'] = Entry('weighing_command', 'weigh a file');"
        "sys.exit(run_command('weigh', ['stone']))"
    )
    read_end, write_end = os.pipe()
    os.close(read_end)
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(Path.cwd())])},
        stdout=write_end,
        stderr=subprocess.PIPE,
        check=False,
    )
    os.close(write_end)
    assert b"Traceback" not in done.stderr
    assert done.returncode == REFUSED


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_of_the_table_explains_itself(name: str, capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit) as end:
        run_command(name, ["--help"])
    assert end.value.code == 0
    text = capsys.readouterr().out
    assert f"usage: calrig {name}" in text
    assert "--json OUT" in text
