"""Load Data shows the practicum's tables and refuses in words what it cannot read."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from gui.dividing_head.tab import HeadTab
from tests.gui.window_driver import Driver

LEGACY = Path(__file__).parents[2] / "data" / "legacy"
TABLE_1_2 = LEGACY / "OpticalDividingHead_202405131405.txt"
TABLE_2_2 = LEGACY / "OpticalDividingHead_202405140930.txt"
TABLE_2_4 = LEGACY / "Accuracy_202405141110.txt"


@pytest.fixture
def head(open_app: Callable[[], Driver]) -> HeadTab:
    return open_app().tab


def load(tab: HeadTab, path: Path, qtbot: QtBot) -> None:
    tab.load(path)
    qtbot.waitUntil(lambda: not tab.results.busy, timeout=10000)


def test_table_2_2_and_the_attitude_of_table_2_4(head: HeadTab, qtbot: QtBot) -> None:
    load(head, TABLE_2_2, qtbot)
    state = head.results.state
    assert state is not None
    triad = state.calibration.triad()
    np.testing.assert_allclose(triad.k[0], [-1334.9887, -12.821846, -72.560802], rtol=5e-8)
    np.testing.assert_allclose(triad.bias, [-378.7525, -194.9475, -229.76375], rtol=1e-9)
    np.testing.assert_allclose(triad.q[2], [1.0246036e-6, 8.0438174e-6, 7.4906201e-4], rtol=5e-8)
    load(head, TABLE_2_4, qtbot)
    state = head.results.state
    assert state is not None
    cells = [cell for table in state.tables for row in table.rows for cell in row]
    for pitch in ("30.02", "60.05"):  # golden 30.026704 and 60.058997, rounded by their u
        assert any(str(cell).startswith(pitch) for cell in cells), cells


def test_table_1_2_says_that_its_pairs_contradict(head: HeadTab, qtbot: QtBot) -> None:
    load(head, TABLE_1_2, qtbot)
    state = head.results.state
    assert state is not None
    (fit,) = state.calibration.fits
    np.testing.assert_allclose(fit.values, [59.79, 1328.0691, -56.908344], rtol=1e-7)
    assert any("14.8 mg" in note.text for note in state.notes)


def test_what_cannot_be_read_loses_nothing(head: HeadTab, qtbot: QtBot, tmp_path: Path) -> None:
    load(head, TABLE_2_2, qtbot)
    before = head.results.state
    damaged = tmp_path / "damaged.txt"
    damaged.write_bytes(TABLE_2_2.read_bytes().replace(b"12942.89", b"12942x89"))
    load(head, damaged, qtbot)
    assert head.results.state is before
