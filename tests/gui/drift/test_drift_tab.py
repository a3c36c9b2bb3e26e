"""The Drift tab as an operator uses it."""

import json
import shutil
import subprocess
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from gui.drift.state import ALL, Settings
from gui.drift.tab import DriftTab
from tests.gui.drift.conftest import columns, turn_on_run


def add(tab: DriftTab, qtbot: QtBot, *paths: Path) -> None:
    tab.presenter.add([str(path) for path in paths])
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)


def decide(tab: DriftTab, qtbot: QtBot, **changes: float) -> None:
    tab.presenter.decide(replace(tab.library.settings, **changes))
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)


def subjects(tab: DriftTab) -> list[str]:
    findings = tab.presenter.state.page.findings
    assert findings is not None
    return [note.subject for note in findings.notes]


def test_the_empty_tab_tells_what_to_do(tab: DriftTab) -> None:
    assert "5 minutes apart" in tab.view.page.hint.text()
    bar = tab.view.page.action_bar
    assert bar.button("add").isEnabled()
    assert not bar.button("export").isEnabled()
    assert not bar.button("reset").isEnabled()


def test_a_folder_gives_a_table_judged_on_what_it_has_not_seen(
    tab: DriftTab, qtbot: QtBot, folder: Path
) -> None:
    add(tab, qtbot, folder)
    state = tab.presenter.state
    assert [row.detail for row in state.page.rows] == [
        "4 turn-ons, 10 °C, 120 s",
        "4 turn-ons, 40 °C, 120 s",
        "4 turn-ons, −20 °C, 120 s",
    ]
    assert not tab.view.page.hint.isVisible()
    titles = [view._title.text() for view in tab.view.page.findings.tables]
    assert titles == [
        "Left on turn-ons that were not seen",
        "The table",
        "Temperature nodes, rms in °/h",
        "By number of knots",
    ]
    findings = state.page.findings
    assert findings is not None
    rms = {row[0]: float(row[1]) for row in findings.tables[0].rows}
    assert rms["this table"] < 0.4 * rms["quartic in time"]
    assert rms["this table"] < 1.15 * rms["mean curve (floor)"]
    assert "noise u = " in findings.source
    assert "bytes" in findings.title


def test_simulated_turn_ons_fill_the_tab(tab: DriftTab, qtbot: QtBot) -> None:
    qtbot.mouseClick(tab.view.page.action_bar.button("simulate"), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=30_000)
    state = tab.presenter.state
    assert state.page.rows[0].detail == "55 turn-ons, −40 … 60 °C, 120 s"
    assert len(state.temperatures) == 12
    assert state.picture is not None
    assert next(line.name for line in state.picture.left) == "no correction"
    # Every second node could be missing: the temperatures are near enough.
    findings = state.page.findings
    assert findings is not None
    for row in findings.tables[2].rows[1:-1]:
        assert float(row[5]) < 3.0 * float(row[4])


def test_one_temperature_is_looked_at(tab: DriftTab, qtbot: QtBot, folder: Path) -> None:
    add(tab, qtbot, folder)
    plots = tab.view.plots
    assert plots is not None
    plots.choice.setCurrentIndex(2)
    plots.choice.activated.emit(2)
    state = tab.presenter.state
    assert state.shown == 1
    assert state.picture is not None
    assert len(state.picture.turn_ons) == 4
    assert state.knots is not None
    assert len(state.knots.values) == 1
    assert state.page.findings is not None
    assert state.page.findings.tables[1].header[2:] == ("12 °C, °/h", "u (k = 1)")
    tab.presenter.show(ALL)
    assert tab.presenter.state.picture.turn_ons == ()


def test_a_knot_is_dragged_with_the_mouse_and_put_back(
    tab: DriftTab, qtbot: QtBot, folder: Path
) -> None:
    add(tab, qtbot, folder)
    plots = tab.view.plots
    assert plots is not None
    plot = plots.curves
    best = tab.library.result
    assert best is not None
    times = best.table.times_s
    box = plot._plot.getViewBox()

    def at(time_s: float) -> QPoint:
        y = float(np.mean(box.viewRange()[1]))
        return plot.mapFromScene(box.mapViewToScene(QPointF(time_s, y)))

    middle = 1 + int(np.argmax(np.diff(times)[1:-1]))
    view = plot.viewport()
    # The range follows with the next frame.
    view.repaint()
    target = float(times[middle]) + 0.4 * float(times[middle + 1] - times[middle])
    qtbot.mousePress(view, Qt.MouseButton.LeftButton, pos=at(float(times[middle])))
    qtbot.mouseMove(view, at(target))
    qtbot.waitUntil(lambda: "t = " in plots.reading.text())
    assert "cost" in plots.reading.text()
    qtbot.mouseRelease(view, Qt.MouseButton.LeftButton, pos=at(target))
    knots = tab.presenter.knots
    assert knots is not None
    assert knots.changed
    moved = float(knots.result.table.times_s[middle])
    assert moved == pytest.approx(target, abs=1.0)
    # Snapped to the edges of the blocks, which begin at 2 s.
    assert (moved - 2.0) % 1.0 == pytest.approx(0.0, abs=1e-9)
    assert knots.cost > knots.optimal_cost
    qtbot.mouseClick(tab.view.page.action_bar.button("reset"), Qt.MouseButton.LeftButton)
    assert not knots.changed
    assert knots.table.times_s.tolist() == times.tolist()


def test_the_arrow_keys_move_a_knot_and_neighbours_stop_it(
    tab: DriftTab, qtbot: QtBot, folder: Path
) -> None:
    add(tab, qtbot, folder)
    plots, knots = tab.view.plots, tab.presenter.knots
    assert plots is not None
    assert knots is not None
    plots.snap.click()
    assert not tab.presenter.state.snap
    first = float(knots.table.times_s[1])
    qtbot.keyClick(plots.curves, Qt.Key.Key_Right)
    assert knots.table.times_s[1] == pytest.approx(first + 1.0)
    qtbot.keyClick(plots.curves, Qt.Key.Key_PageUp)
    for _ in range(300):
        tab.presenter.drag(2, 500.0)
    assert knots.table.times_s[2] == pytest.approx(knots.table.times_s[3] - 1.0)
    assert np.all(np.diff(knots.table.times_s) > 0.99)


def test_a_frame_of_a_drag_is_quick(tab: DriftTab, qtbot: QtBot) -> None:
    tab.presenter.simulate()
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=30_000)
    plots, knots = tab.view.plots, tab.presenter.knots
    assert plots is not None
    assert knots is not None
    start = float(knots.table.times_s[4])
    spent = []
    for step in range(30):
        begun = time.thread_time()
        tab.presenter.drag(4, start + 0.1 * step)
        QApplication.processEvents()
        spent.append(time.thread_time() - begun)
    assert np.median(spent) < 0.016


def test_memory_and_number_of_knots_are_inputs(tab: DriftTab, qtbot: QtBot, folder: Path) -> None:
    add(tab, qtbot, folder)
    form = tab.view.settings
    form.memory.setValue(50)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    assert tab.library.result is not None
    # 2 (5 + 3 + 5 x 3) = 46 bytes; six knots would take 54.
    assert len(tab.library.result.table.times_s) == 5
    assert tab.presenter.state.page.findings.title.endswith("46 bytes of 50")
    decide(tab, qtbot, memory=0, knots=9)
    assert len(tab.library.result.table.times_s) == 9
    decide(tab, qtbot, memory=10)
    assert "10 bytes hold no table of 3 temperatures" in tab.view.page.hint.text()


def test_files_that_tell_no_temperature_take_that_stated(
    tab: DriftTab, qtbot: QtBot, tmp_path: Path
) -> None:
    paths = [
        columns(tmp_path / f"{ambient}_{n}.csv", ambient, n) for ambient in (0, 30) for n in (1, 2)
    ]
    add(tab, qtbot, *paths)
    assert tab.library.result is not None
    assert tab.library.result.table.temperatures_c == pytest.approx([1.6, 31.6], abs=0.6)
    key = tab.presenter.state.page.rows[0].key
    tab.presenter.choose(key)
    form = tab.view.settings
    assert form.ambient.isEnabled()
    form.ambient.setValue(-30.0)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    assert tab.presenter.state.page.rows[0].detail.startswith("1 turn-on, −30 °C")


def test_what_is_doubtful_is_said(tab: DriftTab, qtbot: QtBot, tmp_path: Path) -> None:
    add(tab, qtbot, turn_on_run(tmp_path / "one.run.csv", 20.0, 1))
    assert {"one_temperature", "no_repetition"} <= set(subjects(tab))
    assert tab.presenter.state.picture.left == ()
    assert not tab.view.plots._below.isVisible()
    short = turn_on_run(tmp_path / "short.run.csv", 40.0, 2, rows=1800)
    add(tab, qtbot, short)
    assert "differ in length" in tab.view.page.hint.text()
    assert subjects(tab) == ["drift"]
    decide(tab, qtbot, horizon_s=90.0)
    assert tab.view.page.hint.text() == ""
    assert tab.library.result.table.times_s[-1] == 90.0


def test_a_file_that_is_no_turn_on_is_refused_and_the_others_stay(
    tab: DriftTab, qtbot: QtBot, folder: Path
) -> None:
    bad = folder / "bad.txt"
    bad.write_text("no numbers\n", encoding="utf-8")
    add(tab, qtbot, folder)
    rows = tab.presenter.state.page.rows
    refused = [row for row in rows if row.trouble]
    assert [row.title for row in refused] == ["bad.txt"]
    assert tab.library.result is not None
    assert tab.messages.current is not None
    tab.presenter.choose(refused[0].key)
    tab.presenter.act("remove")
    qtbot.waitUntil(lambda: not tab.library.busy)
    assert tab.messages.current is None


def test_the_exported_header_holds_the_dragged_table(
    tab: DriftTab, qtbot: QtBot, folder: Path, tmp_path: Path
) -> None:
    add(tab, qtbot, folder)
    tab.presenter.nudge(2, 1)
    knots = tab.presenter.knots
    assert knots is not None
    out = tmp_path / "out"
    for key in dict(tab.exporting.formats):
        path = out / Path(tab.exporting.propose(key)).name
        tab.exporting.export(key, str(path))
        qtbot.waitUntil(path.exists, timeout=10_000)
        assert path.stat().st_size > 200
    read = json.loads(next(out.glob("*.json")).read_text(encoding="utf-8"))
    assert read["times_s"] == knots.table.times_s.tolist()
    assert read["values"] == knots.table.values.tolist()
    header = next(out.glob("*.h"))
    compiler = shutil.which("cc")
    assert compiler is not None
    strict = ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-fsyntax-only", "-x", "c"]
    subprocess.run([compiler, *strict, str(header)], check=True, capture_output=True)


def test_the_newest_wish_is_the_one_that_is_shown(
    tab: DriftTab, qtbot: QtBot, folder: Path
) -> None:
    tab.presenter.add([str(folder)])
    for knots in (3, 4, 5, 6):
        tab.presenter.decide(Settings(knots=knots))
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    assert len(tab.library.result.table.times_s) == 6


def test_another_tab_hands_a_folder_over(tab: DriftTab, qtbot: QtBot, folder: Path) -> None:
    tab.load(folder)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    assert tab.library.result is not None
