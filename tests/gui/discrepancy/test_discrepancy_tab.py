"""The tab through its buttons and keys."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton, QToolButton
from pytestqt.qtbot import QtBot

from core.records.run_file import write_run
from gui.discrepancy.tab import DiscrepancyTab
from tests.core.discrepancy.hidden import APART, head_run
from tests.gui.discrepancy.conftest import bent

_LONG = 60_000


def _press(qtbot: QtBot, tab: DiscrepancyTab, key: str) -> None:
    qtbot.mouseClick(tab.view.action_bar.button(key), Qt.MouseButton.LeftButton)


def _opened(qtbot: QtBot, tab: DiscrepancyTab, *paths: Path) -> None:
    tab.presenter.open([str(path) for path in paths])
    qtbot.waitUntil(lambda: tab.presenter.story is not None, timeout=_LONG)


def _backs(tab: DiscrepancyTab) -> list[QToolButton]:
    """Buttons that take a rung back."""
    return [b for b in tab.view.ladder.findChildren(QToolButton) if b.isVisible()]


def _idle(qtbot: QtBot, tab: DiscrepancyTab) -> None:
    qtbot.waitUntil(lambda: not tab.presenter.state.busy, timeout=_LONG)


@pytest.mark.timeout(240)
def test_from_the_file_to_the_closed_gap_and_back(
    qtbot: QtBot, tab: DiscrepancyTab, bent_file: Path
):
    assert "Load Data" in tab.view.hint.text()
    assert not tab.view.action_bar.button("find").isEnabled()
    _opened(qtbot, tab, bent_file)
    state = tab.presenter.state
    assert "rejected" in state.verdict
    assert state.proposals == ()
    assert state.picture is not None
    assert not tab.view.action_bar.button("add").isEnabled()

    tab.view.setFocus()
    tab.view.activateWindow()
    qtbot.waitUntil(tab.view.isActiveWindow)
    qtbot.keyClick(tab.view, Qt.Key.Key_Space)
    assert tab.presenter.state.busy
    _idle(qtbot, tab)
    first, second = tab.view.findings.candidates[:2]
    assert tab.presenter.state.chosen == first.key == "second_order_nonlinearity"
    qtbot.mouseClick(second, Qt.MouseButton.LeftButton)
    assert tab.presenter.state.chosen == second.key == "head_eccentricity"
    assert tab.presenter.state.detail is not None
    assert tab.presenter.state.detail.name == "Head eccentricity"
    qtbot.mouseClick(first, Qt.MouseButton.LeftButton)

    _press(qtbot, tab, "add")
    _idle(qtbot, tab)
    state = tab.presenter.state
    assert [rung.proposed for rung in state.rungs] == [False, False]
    assert state.rungs[1].gap < 1.3 < 4.0 < state.rungs[0].gap
    assert state.after
    assert tab.view.plots is not None
    assert tab.view.plots.after.isVisible()
    tab.view.plots.after.click()
    assert not tab.presenter.state.after

    _press(qtbot, tab, "play")
    assert "simulated rig" in tab.presenter.state.busy
    _idle(qtbot, tab)
    assert tab.presenter.state.picture is not None
    assert len(tab.presenter.state.picture.again) == 96
    assert len(tab.presenter.state.picture.played) == 96
    _press(qtbot, tab, "play")
    assert len(tab.presenter.state.picture.again) == 0

    _press(qtbot, tab, "undo")
    assert len(tab.presenter.state.rungs) == 2
    assert tab.presenter.state.rungs[1].proposed
    _press(qtbot, tab, "all")
    assert not tab.presenter.state.rungs[1].proposed
    qtbot.waitUntil(lambda: len(_backs(tab)) == 1)
    (back,) = _backs(tab)
    qtbot.mouseClick(back, Qt.MouseButton.LeftButton)
    assert tab.presenter.state.rungs[1].proposed
    assert not tab.view.action_bar.button("undo").isEnabled()


def test_the_regressor_is_chosen_in_the_list(qtbot: QtBot, tab: DiscrepancyTab, bent_file: Path):
    _opened(qtbot, tab, bent_file)
    keys = [row.key for row in tab.presenter.state.regressors]
    assert {"head_deg", "a_z", "t_s", "temperature_c"} <= set(keys)
    tab.view.regressors.setCurrentRow(keys.index("t_s"))
    picture = tab.presenter.state.picture
    assert picture is not None
    assert picture.x_label == "Time, s"
    assert tab.view.plots is not None
    assert "Time: " in tab.view.plots.title.text()


def test_the_next_measurement_is_handed_over_as_a_plan(
    qtbot: QtBot, tab: DiscrepancyTab, bent_file: Path
):
    tab.load(bent_file)
    qtbot.waitUntil(lambda: bool(tab.presenter.state.following), timeout=_LONG)
    _idle(qtbot, tab)
    tab.view.findings.pages.setCurrentIndex(1)
    buttons = [
        button
        for button in tab.view.findings.findChildren(QPushButton)
        if button.isVisible() and button.text() == "Open this plan"
    ]
    assert len(buttons) == len(tab.presenter.state.following)
    qtbot.mouseClick(buttons[0], Qt.MouseButton.LeftButton)
    (plan,) = tab.opened
    assert plan.test == "dividing_head"
    assert plan.steps
    qtbot.mouseClick(buttons[0], Qt.MouseButton.LeftButton)
    assert tab.messages.current is not None
    assert "No tab" in tab.messages.current.what


def test_the_proposed_series_decides(qtbot: QtBot, tab: DiscrepancyTab, bent_file: Path):
    second = bent_file.with_name("more.run.csv")
    write_run(head_run(hidden=bent, rows=APART, seed=6), second)
    _opened(qtbot, tab, bent_file, second)
    tab.presenter.find()
    _idle(qtbot, tab)
    (card,) = tab.presenter.state.proposals
    assert [row.key for row in card.tied] == ["second_order_nonlinearity"]
    assert "named" in tab.presenter.state.verdict


def test_report_results_and_model_are_written(qtbot: QtBot, tab: DiscrepancyTab, bent_file: Path):
    tab.load(bent_file)
    qtbot.waitUntil(lambda: bool(tab.presenter.state.proposals), timeout=_LONG)
    _idle(qtbot, tab)
    folder = bent_file.parent
    for key in ("html", "pdf", "json", "model"):
        proposed = Path(tab.exporting.propose(key))
        assert proposed.parent == folder
        tab.exporting.export(key, f"out.{key}")
    text = (folder / "out.html").read_text(encoding="utf-8")
    for words in (
        "The ladder",
        "Second-order nonlinearity K2",
        "What to measure next",
        "image/png",
    ):
        assert words in text
    assert (folder / "out.pdf").read_bytes().startswith(b"%PDF")
    assert json.loads((folder / "out.json").read_text(encoding="utf-8"))["verdict"] == "ambiguous"
    assert json.loads((folder / "out.model").read_text(encoding="utf-8"))["device"] == "A1"
    _press(qtbot, tab, "report")
    assert list(folder.glob("A1_*_model_vs_data.pdf"))


def test_a_file_of_another_kind_is_refused_in_words(
    qtbot: QtBot, tab: DiscrepancyTab, tmp_path: Path
):
    path = tmp_path / "notes.txt"
    path.write_text("nothing measured\n", encoding="utf-8")
    tab.presenter.open([str(path)])
    qtbot.waitUntil(lambda: tab.messages.current is not None, timeout=_LONG)
    assert "cannot be compared" in tab.messages.current.what
    assert str(path) in tab.messages.current.meaning
    assert tab.presenter.story is None
    assert not tab.presenter.state.busy


def test_too_few_rows_get_a_sentence_instead_of_a_guess(
    qtbot: QtBot, tab: DiscrepancyTab, tmp_path: Path
):
    path = tmp_path / "few.run.csv"
    write_run(head_run(hidden=bent).rows(range(4)), path)
    _opened(qtbot, tab, path)
    assert tab.presenter.state.verdict == "Too few rows to tell"
    assert not tab.view.action_bar.button("find").isEnabled()
    assert tab.presenter.state.picture is None
