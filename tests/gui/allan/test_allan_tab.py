"""The Allan tab as an operator uses it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from pytestqt.qtbot import QtBot

from gui.allan.tab import AllanTab
from tests.gui.allan.conftest import SCALE, TRUTH, idle


def add(tab: AllanTab, qtbot: QtBot, *paths: Path) -> None:
    tab.presenter.add([str(path) for path in paths])
    qtbot.waitUntil(lambda: idle(tab), timeout=20_000)


def test_the_empty_tab_tells_what_to_do(tab: AllanTab) -> None:
    assert tab.view.hint.isVisible()
    assert "Add Records" in tab.view.hint.text()
    bar = tab.view.action_bar
    assert bar.button("add").isEnabled()
    assert not bar.button("live").isEnabled()
    assert "Properties" in bar.button("live").toolTip()
    assert not bar.button("export").isEnabled()


def test_a_simulated_cvg_gives_its_noise_back_on_the_screen(
    tab: AllanTab, qtbot: QtBot, records: list[Path]
) -> None:
    add(tab, qtbot, records[0])
    study = tab.library.studies[0]
    assert (study.unit, study.scale_factor) == ("deg/s", SCALE)
    rows = {row.symbol: row for row in study.published.rows if row.method == "likelihood"}
    for symbol, true in TRUTH.items():
        assert rows[symbol].lower < true < rows[symbol].upper
    assert not tab.view.hint.isVisible()
    quotes = tab.view.findings.tables[0]
    quotes.copy()
    lines = QGuiApplication.clipboard().text().splitlines()
    n = next(line.split("\t") for line in lines if line.startswith("N  two-sided"))
    assert float(n[1]) == pytest.approx(TRUTH["N"], rel=0.03)
    assert n[2] == "°/√s"
    shown = [view._title.text() for view in tab.view.findings.tables]
    assert shown == ["Noise coefficients, 95 %", "By method", "What a longer record would give"]


def test_several_records_are_overlaid_and_compared(
    tab: AllanTab, qtbot: QtBot, records: list[Path]
) -> None:
    add(tab, qtbot, *records)
    state = tab.presenter.state
    assert state.picture is not None
    assert [curve.name for curve in state.picture.curves] == ["25-143 GyroOut", "25-144 GyroOut"]
    assert len({row.colour for row in state.rows}) == 2
    assert state.findings is not None
    compared = state.findings.tables[-1]
    assert compared.header[2:] == ("25-143 GyroOut", "25-144 GyroOut")
    tab.presenter.choose(state.rows[0].key)
    chosen = tab.presenter.state.picture
    assert chosen is not None
    assert chosen.curves[-1].name == "25-143 GyroOut"
    tab.view.list.item(0).setCheckState(Qt.CheckState.Unchecked)
    picture = tab.presenter.state.picture
    assert picture is not None
    assert [curve.name for curve in picture.curves] == ["25-144 GyroOut"]


def test_regression_chosen_in_the_form_shows_before_and_after(
    tab: AllanTab, qtbot: QtBot, records: list[Path]
) -> None:
    add(tab, qtbot, records[1])
    form = tab.view.settings
    form.regressor.setCurrentIndex(form.regressor.findText("Temperature"))
    qtbot.waitUntil(lambda: tab.library.studies[0].after is not None, timeout=20_000)
    state = tab.presenter.state
    assert state.picture is not None
    before, after = state.picture.curves
    assert before.aside
    assert after.deviation[-1] < 0.5 * before.deviation[-1]
    found = tab.library.studies[0].regression
    assert found is not None
    assert found.values[0] == pytest.approx(0.05, abs=4.0 * found.u[0])


def test_a_scale_factor_and_a_channel_are_decided(
    tab: AllanTab, qtbot: QtBot, records: list[Path]
) -> None:
    add(tab, qtbot, records[0])
    first = tab.library.studies[0].published.row("random_walk").value
    tab.view.settings.scale.setValue(2.0 * SCALE)
    qtbot.waitUntil(lambda: idle(tab), timeout=20_000)
    assert tab.library.studies[0].published.row("random_walk").value == pytest.approx(first / 2.0)
    tab.presenter.decide(replace(tab.library.entries[0].request, channel="Temperature"))
    qtbot.waitUntil(lambda: idle(tab), timeout=20_000)
    assert tab.presenter.state.choices is not None
    assert tab.presenter.state.choices.channel == "Temperature"


def test_the_cursor_reads_the_curve(tab: AllanTab, qtbot: QtBot, records: list[Path]) -> None:
    add(tab, qtbot, records[0])
    plot = tab.view.plot
    assert plot is not None
    qtbot.keyClick(plot, Qt.Key.Key_Right)
    first = tab.library.studies[0].published.curve
    assert tab.view.reading.text().startswith("τ = 0.05000 s")
    assert f"{first.edf[0]:.3g} dof" in tab.view.reading.text()
    middle = QPoint(plot.width() // 2, plot.height() // 2)
    # A pointer that stands there already would not be told of.
    qtbot.mouseMove(plot.viewport(), middle + QPoint(5, 5))
    qtbot.mouseMove(plot.viewport(), middle)
    qtbot.waitUntil(lambda: not tab.view.reading.text().startswith("τ = 0.05000 s"))
    assert "slope" in tab.view.reading.text()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("3\n" * 400, "tell its sampling rate"),
        ("t,g\n" + "".join(f"{i / 10},5\n" for i in range(400)), "stuck or not connected"),
        ("t,g\n" + "".join(f"{i / 10},{i}\n" for i in range(5)), "record longer"),
        ("no numbers\n", "no row of numbers"),
    ],
)
def test_a_bad_record_is_said_in_words(
    tab: AllanTab, qtbot: QtBot, tmp_path: Path, content: str, words: str
) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(content, encoding="utf-8")
    add(tab, qtbot, path)
    assert words in tab.view.hint.text()
    findings = tab.presenter.state.findings
    assert findings is not None
    assert words in findings.notes[0].text
    assert tab.presenter.state.rows[0].detail == "cannot be used"
    tab.presenter.remove()
    assert tab.presenter.state.rows == ()


def test_a_rate_that_the_file_does_not_tell_can_be_stated(
    tab: AllanTab, qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "codes.txt"
    np.savetxt(path, np.random.default_rng(2).normal(size=3000), "%.6f")
    add(tab, qtbot, path)
    assert tab.library.studies == ()
    tab.view.settings.rate.setValue(50.0)
    qtbot.waitUntil(lambda: len(tab.library.studies) == 1, timeout=20_000)
    assert tab.library.studies[0].coefficients.curve.duration == 60.0


@pytest.mark.parametrize("key", ["svg", "png", "pdf", "coefficients", "curves", "kalibr", "matlab"])
def test_everything_is_exported(
    tab: AllanTab, qtbot: QtBot, records: list[Path], tmp_path: Path, key: str
) -> None:
    add(tab, qtbot, records[0])
    assert key in dict(tab.exporting.formats)
    path = tmp_path / "out" / Path(tab.exporting.propose(key)).name
    tab.exporting.export(key, str(path))
    qtbot.waitUntil(path.exists, timeout=10_000)
    assert "25-143" in path.name
    assert path.stat().st_size > 200


def test_another_deviation_is_drawn_dashed_and_told_in_a_table(
    tab: AllanTab, qtbot: QtBot, records: list[Path]
) -> None:
    add(tab, qtbot, records[0])
    beside = tab.view.settings.beside
    beside.setCurrentIndex(beside.findData("total"))
    qtbot.waitUntil(lambda: tab.library.studies[0].beside is not None, timeout=30_000)
    state = tab.presenter.state
    assert state.picture is not None
    assert [(curve.name, curve.aside) for curve in state.picture.curves] == [
        ("25-143 GyroOut, Total", True),
        ("25-143 GyroOut", False),
    ]
    assert state.findings is not None
    assert "Total deviation" in [table.title for table in state.findings.tables]
