"""The Thermal tab as an operator uses it."""

import csv
import gzip
import json
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.plans.plan import load_plans
from core.records.run_file import write_run
from core.samples.run import Conditions, Run
from gui.thermal.state import Settings
from gui.thermal.tab import ThermalTab
from gui.thermal.working import CycleOutcome, RecordOutcome, computed, simulated
from tests.gui.thermal.conftest import cycle

DATA = Path(__file__).parents[2] / "data"


def add(tab: ThermalTab, qtbot: QtBot, *paths: Path) -> None:
    tab.presenter.add([str(path) for path in paths])
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)


def decide(tab: ThermalTab, qtbot: QtBot, **changes: object) -> None:
    tab.presenter.decide(replace(tab.library.settings, **changes))
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)


def titles(tab: ThermalTab) -> list[str]:
    return [view._title.text() for view in tab.view.page.findings.tables]


def table(tab: ThermalTab, start: str) -> tuple[tuple[str, ...], ...]:
    findings = tab.presenter.state.page.findings
    assert findings is not None
    return next(one for one in findings.tables if one.title.startswith(start)).rows


def test_the_empty_tab_tells_what_to_do(tab: ThermalTab, qtbot: QtBot) -> None:
    assert "Last Cycle (Space)" in tab.view.page.hint.text()
    tab.presenter.act("last")
    qtbot.waitUntil(lambda: tab.messages.current is not None)
    assert tab.messages.current.what == "There is no cycle yet"


def test_a_folder_of_nine_files_is_one_cycle(tab: ThermalTab, qtbot: QtBot, folder: Path) -> None:
    add(tab, qtbot, folder)
    assert len(tab.presenter.state.page.rows) == 9
    assert titles(tab) == [
        "Parameters over temperature",
        "Hysteresis: heating less cooling, 95 %",
        "Largest error of roll or pitch, °",
        "Six positions at 27 °C",
        "The same at each temperature",
        "Orders, rms at temperatures left out",
    ]
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    x = outcome.thermal.channels[0]
    assert x.fit.value("scale_factor_t1") == pytest.approx(0.16, abs=0.01)
    assert x.largest_hysteresis == pytest.approx(6.0, abs=2.0)
    rows = {row[0]: row for row in table(tab, "Largest error")}
    before, after = (float(rows["all"][place]) for place in (1, 2))
    assert before > 5.0 * after
    assert rows["−40 °C"][3] == "took part"
    assert rows["50 °C"][3] == ""
    split = table(tab, "The same")
    assert [row[0] for row in split[:6]] == ["k X", "k Y", "k Z", "α yz", "α zy", "α zx"]
    assert len(split[0]) == 2 + 9


def test_every_quantity_is_drawn_with_its_hysteresis(
    tab: ThermalTab, qtbot: QtBot, folder: Path
) -> None:
    add(tab, qtbot, folder)
    plots = tab.view.plots
    assert plots is not None
    assert len(plots.plots) == 3
    assert "hysteresis 6.68 ± 0.99 code at 27 °C" in tab.presenter.state.plots[0].title
    assert "heated" in plots.legend.text()
    names = [points.name for points in tab.presenter.state.plots[0].points]
    assert names == ["first", "heated", "cooled"]
    for quantity, count in ((1, 3), (2, 2)):
        plots.choice.setCurrentIndex(quantity)
        plots.choice.activated.emit(quantity)
        assert len(plots.plots) == count
        assert tab.presenter.state.quantity == quantity
    before, after = tab.presenter.state.plots[1].points
    assert np.abs(before.y).max() > 5.0 * np.abs(after.y).max()


def test_a_check_run_takes_no_part(tab: ThermalTab, qtbot: QtBot, tmp_path: Path) -> None:
    write_run(cycle(), tmp_path / "cycle.run.csv")
    write_run(cycle(7).rows(range(40, 56)), tmp_path / "check.run.csv")
    add(tab, qtbot, tmp_path / "cycle.run.csv")
    add(tab, qtbot, tmp_path / "check.run.csv")
    qtbot.mouseClick(tab.view.page.action_bar.button("check"), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not tab.library.busy)
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    assert len(outcome.run) == 72
    assert outcome.tilt.check
    assert "Errors of roll and pitch, °" in titles(tab)
    assert "check only" in tab.presenter.state.page.rows[1].detail
    qtbot.mouseClick(tab.view.page.action_bar.button("check"), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not tab.library.busy)
    assert len(tab.library.result.run) == 88


def test_a_check_beyond_the_temperatures_is_refused(
    tab: ThermalTab, qtbot: QtBot, tmp_path: Path
) -> None:
    write_run(cycle().rows(range(24)), tmp_path / "cold.run.csv")
    write_run(cycle(7).rows(range(48, 56)), tmp_path / "hot.run.csv")
    add(tab, qtbot, tmp_path / "cold.run.csv")
    add(tab, qtbot, tmp_path / "hot.run.csv")
    tab.presenter.act("check")
    qtbot.waitUntil(lambda: not tab.library.busy)
    notes = {note.subject: note.text for note in tab.presenter.state.page.findings.notes}
    assert "polynomials mean nothing outside" in notes["no_tilt"]


def test_the_public_record_of_a_chamber(tab: ThermalTab, qtbot: QtBot, tmp_path: Path) -> None:
    path = tmp_path / "imu_thermal.csv"
    packed = DATA / "tofupilot_imu_thermal" / "imu_thermal.csv.gz"
    path.write_bytes(gzip.decompress(packed.read_bytes()))
    add(tab, qtbot, path)
    decide(tab, qtbot, bias_order=3)
    outcome = tab.library.result
    assert isinstance(outcome, RecordOutcome)
    # The published R^2 of order 3.
    assert [row[2] for row in table(tab, "Before and after")] == ["0.570", "0.997", "0.535"]
    assert len(tab.presenter.state.plots) == 3
    assert tab.presenter.state.quantities == ("Outputs",)
    decide(tab, qtbot, outputs="acc_x, acc_y, acc_z")
    assert [row[2] for row in table(tab, "Before and after")] == ["0.982", "0.881", "0.945"]
    notes = [note.subject for note in tab.presenter.state.page.findings.notes]
    assert "one_orientation" in notes
    begun = time.process_time()
    computed([outcome.run], (), tab.library.settings)
    assert time.process_time() - begun < 0.05
    tab.exporting.export("c", str(tmp_path / "a.h"))
    qtbot.waitUntil(lambda: tab.messages.current is not None)
    assert "this orientation only" in tab.messages.current.meaning


def test_the_public_six_poses(tab: ThermalTab, qtbot: QtBot, tmp_path: Path) -> None:
    """No temperature was measured: twelve and nine parameters, and nothing over temperature."""
    path = tmp_path / "six.run.csv"
    write_run(six_poses(), path)
    add(tab, qtbot, path)
    assert titles(tab) == ["Six positions", "The same at each temperature"]
    published = json.loads(
        (DATA / "imucal_ferraris" / "example_cal.json").read_text(encoding="utf-8")
    )
    k = np.array(published["K_a"]) @ np.array(published["R_a"])
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    assert outcome.splits[0].six.triad.k == pytest.approx(k, rel=1e-9)
    notes = {note.subject for note in tab.presenter.state.page.findings.notes}
    assert "no_temperature" in notes
    assert "nothing to draw" in tab.view.page.hint.text()


def six_poses() -> Run:
    with (DATA / "imucal_ferraris" / "static_accelerometer.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    # The poses of the plan's steps: Z up, Y down, Z down, Y up, X up, X down.
    parts = ("z_p", "y_a", "z_a", "y_p", "x_p", "x_a")
    y = np.array(
        [
            np.mean(
                [
                    [float(row[f"acc_{axis}"]) for axis in "xyz"]
                    for row in rows
                    if row["part"] == part
                ],
                axis=0,
            )
            for part in parts
        ]
    )
    steps = load_plans()["six_positions"].steps
    unknown = np.full(6, np.nan)
    return Run(
        "dividing_head",
        "accelerometer",
        "imucal",
        ("X", "Y", "Z"),
        ("x", "y", "z"),
        "code",
        y,
        np.full_like(y, np.nan),
        np.ones(6, dtype=np.int64),
        np.arange(6),
        tuple(step.mount for step in steps),
        np.array([step.head_deg for step in steps]),
        unknown,
        unknown,
        unknown,
        conditions=Conditions(g_mps2=9.81),
    )


def test_what_cannot_be_used_is_said(tab: ThermalTab, qtbot: QtBot, tmp_path: Path) -> None:
    write_run(cycle().rows(range(8)), tmp_path / "one.run.csv")
    add(tab, qtbot, tmp_path / "one.run.csv")
    notes = {note.subject: note.text for note in tab.presenter.state.page.findings.notes}
    assert "all rows were measured at" in notes["no_temperature"]
    bad = tmp_path / "bad.txt"
    bad.write_text("no numbers\n", encoding="utf-8")
    add(tab, qtbot, bad)
    assert tab.presenter.state.page.rows[1].trouble
    assert tab.library.result is not None
    assert tab.messages.current is not None
    other = replace(cycle(), unit="V")
    write_run(other, tmp_path / "volts.run.csv")
    add(tab, qtbot, tmp_path / "volts.run.csv")
    assert "differ in unit" in tab.view.page.hint.text()
    tab.presenter.act("remove")
    qtbot.waitUntil(lambda: not tab.library.busy)
    assert tab.library.result is not None


def test_g_that_no_file_states_is_assumed_and_said(
    tab: ThermalTab, qtbot: QtBot, tmp_path: Path
) -> None:
    write_run(replace(cycle(), conditions=Conditions()), tmp_path / "a.run.csv")
    add(tab, qtbot, tmp_path / "a.run.csv")
    decide(tab, qtbot, g_mps2=9.8)
    notes = {note.subject: note.text for note in tab.presenter.state.page.findings.notes}
    assert "g = 9.8 m/s^2 was assumed" in notes["assumed_g"]


def test_orders_and_reference_are_inputs(tab: ThermalTab, qtbot: QtBot) -> None:
    tab.presenter.simulate()
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    form = tab.view.settings
    form.bias_order.setValue(1)
    form.reference.setValue(20.0)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    outcome = tab.library.result
    assert isinstance(outcome, CycleOutcome)
    assert [one.bias_order for one in outcome.thermal.channels] == [1, 1, 1]
    assert outcome.thermal.reference_c == 20.0
    # At 20 degC the scale factor is 7 x 0.16 less than at 27.
    assert outcome.thermal.channels[0].fit.value("scale_factor") == pytest.approx(798.9, abs=0.3)


@pytest.mark.parametrize("key", ["json", "c", "csv", "svg", "png", "pdf"])
def test_everything_is_exported(
    tab: ThermalTab, qtbot: QtBot, folder: Path, tmp_path: Path, key: str
) -> None:
    add(tab, qtbot, folder)
    assert key in dict(tab.exporting.formats)
    path = tmp_path / "out" / Path(tab.exporting.propose(key)).name
    tab.exporting.export(key, str(path))
    qtbot.waitUntil(path.exists, timeout=10_000)
    assert "simulated_triad" in path.name
    assert path.stat().st_size > 300


def test_a_whole_cycle_is_computed_in_a_blink() -> None:
    run, settings = simulated(), Settings()
    computed([run], (), settings)
    begun = time.process_time()
    computed([run], (), settings)
    assert time.process_time() - begun < 0.5


def test_another_tab_hands_a_folder_over(tab: ThermalTab, qtbot: QtBot, folder: Path) -> None:
    tab.load(folder)
    qtbot.waitUntil(lambda: not tab.library.busy, timeout=20_000)
    assert tab.library.result is not None
