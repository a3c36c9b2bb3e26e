"""An archive of another schema, a folder that moves, a second program: what the window says."""

import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.errors import Severity
from core.procedures.calibration import Calibration
from gui.archive.tab import ArchiveTab
from gui.widgets.states import BannerState
from tests.core.archive.conftest import calibrated
from tests.core.archive.test_archive_database import FILLER, V1
from tests.gui.archive.conftest import settle, show

SOURCES = Path(__file__).parents[3]


@pytest.fixture
def other_program(filled: Path) -> "Iterator[subprocess.Popen[str]]":
    """Another CalRig that makes the index of the same folder anew, again and again."""
    program = subprocess.Popen(
        [sys.executable, "-c", FILLER, str(filled), "10000"],
        cwd=SOURCES,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert program.stdout is not None
    assert program.stdout.readline() == "open\n"
    yield program
    program.kill()
    program.communicate()


def banner(tab: ArchiveTab) -> BannerState:
    shown = tab.presenter._messages.current
    assert shown is not None
    return shown


def act(tab: ArchiveTab, qtbot: QtBot, key: str) -> None:
    qtbot.mouseClick(tab.view.action_bar.button(key), Qt.MouseButton.LeftButton)
    settle(tab, qtbot)


def test_an_index_of_a_newer_program_is_shown_and_the_banner_says_what_to_do(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, triad: Calibration
) -> None:
    show(tab, qtbot)
    tab.library.close()
    tab.library._closing = False
    with sqlite3.connect(filled / "archive.db") as connection:
        connection.execute("UPDATE archive_meta SET value = '9' WHERE key = 'schema'")
    connection.close()
    calibrated(triad, filled / "later")
    act(tab, qtbot, "refresh")
    assert tab.presenter.state.status == "7 found"
    told = banner(tab)
    assert told.severity is Severity.WARNING
    assert "made by a newer CalRig (schema 9" in told.meaning
    assert told.remedy.startswith("Update CalRig on this computer")
    act(tab, qtbot, "rebuild")
    refused = banner(tab)
    assert refused.what == "The index cannot be made"
    assert "update CalRig" in refused.meaning
    assert refused.remedy.startswith("The sessions are untouched")
    assert tab.presenter.state.status == "7 found"


def test_an_index_of_an_older_program_is_brought_up_to_date_without_a_word(
    tab: ArchiveTab, qtbot: QtBot, filled: Path
) -> None:
    with sqlite3.connect(filled / "archive.db") as connection:
        connection.executescript(V1)
    connection.close()
    show(tab, qtbot)
    assert tab.presenter.state.status == "7 found"
    assert tab.presenter._messages.current is None
    with sqlite3.connect(filled / "archive.db") as connection:
        query = "SELECT value FROM archive_meta WHERE key = 'schema'"
        assert connection.execute(query).fetchone() != ("1",)
    connection.close()


def test_a_folder_that_was_moved_is_found_again_with_its_entries(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    show(tab, qtbot)
    row = next(row for row in tab.presenter.state.rows if row.cells[1] == "calibration")
    elsewhere = filled.parent / "disk D"
    shutil.move(filled, elsewhere)
    act(tab, qtbot, "refresh")
    lost = banner(tab)
    assert "no longer there" in lost.meaning or "no such folder" in lost.meaning
    assert "Refresh" in lost.remedy
    assert not filled.exists(), "the window makes no empty folder where the sessions were"
    monkeypatch.setattr(tab.library, "_root", lambda: elsewhere)
    act(tab, qtbot, "refresh")
    assert tab.presenter._messages.current is None
    assert tab.presenter.state.status == "7 found"
    assert row.id in [one.id for one in tab.presenter.state.rows]
    tab.presenter.choose([row.id])
    settle(tab, qtbot)
    assert tab.presenter.state.findings is not None
    assert str(elsewhere) in tab.presenter.state.findings.source


def test_while_another_program_writes_the_list_stays_and_the_wait_is_told(
    tab: ArchiveTab, qtbot: QtBot, filled: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("core.archive.database._WAIT_S", 0.2)
    show(tab, qtbot)
    other = sqlite3.connect(filled / "archive.db", isolation_level=None)
    other.execute("BEGIN IMMEDIATE")
    act(tab, qtbot, "rebuild")
    told = banner(tab)
    assert "another program has been writing to it" in told.meaning
    assert "Refresh (Ctrl+R)" in told.remedy
    assert tab.presenter.state.status == "7 found"
    other.execute("ROLLBACK")
    other.close()
    act(tab, qtbot, "rebuild")
    assert tab.presenter._messages.current is None
    assert tab.presenter.state.status == "7 found"


def test_a_second_program_that_remakes_the_index_takes_no_choice_away(
    tab: ArchiveTab, qtbot: QtBot, other_program: "subprocess.Popen[str]"
) -> None:
    show(tab, qtbot)
    for _ in range(5):
        act(tab, qtbot, "refresh")
    other_program.kill()
    other_program.wait()
    act(tab, qtbot, "refresh")
    assert tab.presenter.state.status == "7 found"
    stale = max(row.id for row in tab.presenter.state.rows) + 1000
    tab.presenter.choose([stale])
    settle(tab, qtbot)
    told = banner(tab)
    assert told.what == "The entry cannot be shown"
    assert "choose the entry once more" in told.remedy
