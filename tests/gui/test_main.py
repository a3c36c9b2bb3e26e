"""What the command line chooses."""

import pytest

from core.version import VERSION
from gui.commands.table import COMMANDS
from gui.main import main


def test_a_name_of_the_table_runs_that_command(capsys: pytest.CaptureFixture[str]):
    assert main(["ports"]) == 0
    assert "sim://" in capsys.readouterr().out


def test_help_lists_every_command(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit) as end:
        main(["--help"])
    assert end.value.code == 0
    text = capsys.readouterr().out
    assert all(f"  {name} " in text and entry.help in text for name, entry in COMMANDS.items())


def test_an_unknown_command_is_told_what_there_is(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit) as end:
        main(["prots"])
    assert end.value.code == 2
    assert "there is no command 'prots'; there are: ports" in capsys.readouterr().err


def test_version(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit):
        main(["--version"])
    assert capsys.readouterr().out == f"calrig {VERSION}\n"
