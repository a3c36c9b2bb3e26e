"""The page Means without a window: what was set, the run file, refusals."""

import time
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from core.arrays import frozen, frozen_int
from core.errors import FormatError
from core.records.cvgcom import channel_of
from core.records.means import RecordMean, mean_of
from core.records.run_file import read_run
from gui.jobs import Jobs
from gui.live.exporting import Exporting
from gui.live.means import POSITIONS, RATES, Means
from gui.live.means_view import MeansView
from gui.messages import Messages

CHANNELS = (channel_of("GyroOut"), channel_of("Temperature"))


def averaged(level: float, number: int) -> RecordMean:
    data = np.random.default_rng(number).normal([level, 26.0], [1e-3, 1e-2], size=(400, 2))
    name = f"25-143.exp({number:03d})_d_pr1.calrec"
    return mean_of(name, CHANNELS, frozen_int(np.arange(400)), frozen(data), 100.0)


@pytest.fixture
def means(qtbot: QtBot, tmp_path: Path) -> Means:
    del qtbot
    made = Means(Messages(QCoreApplication.instance()))
    made.take([averaged(0.24, 1), averaged(-0.24, 2)], tmp_path, "other")
    return made


def test_rates_make_a_run_of_the_rate_table(means: Means, tmp_path: Path) -> None:
    means.give(0, ["10,0", "−10"])
    assert [row[1] for row in means.state.rows] == ["10,0", "−10"]
    proposed = Path(means.state.file)
    assert (proposed.parent, proposed.name[:13]) == (tmp_path, "25-143_means_")
    means.hand_over(str(proposed))
    run = read_run(proposed)
    assert (run.test, run.sensor, run.device) == ("rate_table", "gyro", "25-143")
    assert run.set_rate_dps.tolist() == [10.0, -10.0]
    assert run.y[:, 0] == pytest.approx([0.24, -0.24], abs=1e-3)
    assert run.temperature_c == pytest.approx([26.0, 26.0], abs=0.01)
    assert means.state.file != str(proposed)


def test_positions_make_a_run_of_the_head(means: Means, tmp_path: Path) -> None:
    means.set_kind(POSITIONS)
    means.give(0, ["X_from:0", "X_from:90", "beyond the table"])
    means.hand_over("head.run.csv")
    run = read_run(tmp_path / "head.run.csv")
    assert (run.test, run.mount, run.head_deg.tolist()) == (
        "dividing_head",
        ("X_from", "X_from"),
        [0.0, 90.0],
    )


@pytest.mark.parametrize(
    ("kind", "given", "words"),
    [
        (RATES, ["10"], "has no set rate yet"),
        (RATES, ["10", "fast"], "'fast' is no number"),
        (POSITIONS, ["X_from:0", "90"], "write X_from:90"),
    ],
)
def test_what_is_missing_or_wrong_is_said(
    means: Means, tmp_path: Path, kind: str, given: list[str], words: str
) -> None:
    means.set_kind(kind)
    means.give(0, given)
    means.hand_over("a.run.csv")
    banner = means._messages.current
    assert banner is not None
    assert words in banner.meaning
    assert not (tmp_path / "a.run.csv").exists()


def test_a_run_file_is_never_overwritten(means: Means, tmp_path: Path) -> None:
    (tmp_path / "a.run.csv").write_text("mine", encoding="utf-8")
    means.give(0, ["1", "2"])
    means.hand_over("a.run.csv")
    assert (tmp_path / "a.run.csv").read_text("utf-8") == "mine"


def test_a_column_is_pasted_and_a_cell_edited(means: Means, qtbot: QtBot) -> None:
    view = MeansView()
    qtbot.addWidget(view)
    means.changed.connect(view.render)
    view.given.connect(means.give)
    view.handed_over.connect(means.hand_over)
    view.render(means.state)
    QGuiApplication.clipboard().setText("10\n20\n30\n")
    view.table.setCurrentIndex(view.table.means.index(0, 1))
    QTest.keySequence(view.table, QKeySequence(QKeySequence.StandardKey.Paste))
    assert [row[1] for row in means.state.rows] == ["10", "20"]
    view.table.means.setData(view.table.means.index(1, 1), "−20")
    assert [row[1] for row in means.state.rows] == ["10", "−20"]
    view.hand_over.click()
    assert means._messages.current is not None
    assert means._messages.current.what == "Run file written"


def test_files_are_written_one_after_another(qtbot: QtBot, tmp_path: Path) -> None:
    jobs, messages = Jobs(), Messages()
    exporting = Exporting(jobs, messages)
    running: list[int] = []
    most: list[int] = []
    came: list[Path] = []
    exporting.averaged.connect(lambda _, folder: came.append(folder))

    def make() -> list[RecordMean]:
        running.append(1)
        most.append(len(running))
        time.sleep(0.05)
        running.pop()
        return [averaged(0.1, 1)]

    folders = [tmp_path / name for name in "abc"]
    exporting.means(make, folders[0])
    exporting.means(make, folders[1])
    exporting.means(refuse, tmp_path / "none")
    exporting.means(make, folders[2])
    qtbot.waitUntil(lambda: came == folders)
    assert most == [1, 1, 1]
    assert messages.current is not None
    assert "no such record" in messages.current.meaning
    jobs.close()


def test_a_folder_that_cannot_be_made_is_told(qtbot: QtBot, tmp_path: Path) -> None:
    jobs, messages = Jobs(), Messages()
    exporting = Exporting(jobs, messages)
    (tmp_path / "file").touch()
    exporting.means(lambda: [averaged(0.1, 1)], tmp_path / "file" / "x")
    qtbot.waitUntil(lambda: messages.current is not None)
    assert messages.current is not None
    assert messages.current.what == "Not exported"
    assert "cannot be made" in messages.current.meaning
    jobs.close()


def refuse() -> list[RecordMean]:
    """A mean that cannot be made."""
    raise FormatError("x", "no such record")
