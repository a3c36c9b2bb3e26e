"""The Live tab in the real window, on the simulated CVG."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from core.errors import StorageError
from core.records.cvgcom import read_cvgcom
from drivers.recording import read_recording
from gui.live.state import Phase
from gui.widgets.strip_view import Follow

FOLDER = ".Gyro_Data"


def live_of(driver):
    tab = driver.tab
    return tab, tab.presenter, tab.view


def press(driver, key):
    _, _, view = live_of(driver)
    driver.until(lambda: view.action_bar.button(key).isEnabled())
    driver.click(view.action_bar.button(key))


def record(driver, samples=1000):
    _, presenter, _ = live_of(driver)
    press(driver, "start")
    assert presenter.phase is Phase.RECORDING
    driver.until(lambda: presenter.trace.history.end - presenter.trace.history.first >= samples)


def test_record_stop_resume_stop_and_load(driver, tmp_path):
    tab, presenter, view = live_of(driver)
    name = presenter.state.file
    assert name.endswith(".exp(001)_s_pr1")
    record(driver)
    assert tab.why_busy()
    press(driver, "stop")
    assert presenter.phase is Phase.STOPPED
    assert driver.app.messages.current.actions[0].key == "resume"
    recorder = tab.keeper.recorder
    assert recorder.flush()
    stopped = recorder.count
    driver.bot.wait(100)
    assert recorder.count == stopped
    driver.answer("Resume")
    driver.until(lambda: recorder.count > stopped + 400)
    press(driver, "stop")
    driver.bot.wait(100)
    trace = presenter.trace
    index, data = trace.excerpt([(0.0, trace.seconds)]).samples()
    press(driver, "watch")
    recorder.close()
    stored = read_recording(recorder.path)
    assert stored.path.parent.parent == tmp_path / "data" / FOLDER
    assert stored.ended
    # What was on the screen is what is on the disk, gap and all.
    assert np.array_equal(stored.index(), index)
    assert np.array_equal(stored.samples()[1], data)
    assert len(stored.gaps) == 1
    text = read_cvgcom(recorder.path.with_suffix(".txt"))
    assert text.head.rate == 100.0
    assert text.data[0] == pytest.approx(data[:2].mean(axis=0), abs=1e-9)
    assert presenter.state.file.endswith(".exp(002)_s_pr1")
    tab.loading.load(recorder.path)
    driver.until(lambda: presenter.phase is Phase.LOADED)
    assert presenter.trace.seconds == pytest.approx(stored.seconds)
    assert view.charts.charts.follow is Follow.ALL


def test_marks_cursors_statistics_and_clipboard(driver):
    tab, presenter, view = live_of(driver)
    record(driver)
    view.charts.note.setText("door opened")
    driver.bot.keyClick(view.charts.note, Qt.Key.Key_Return)
    press(driver, "stop")
    driver.bot.wait(100)
    path = tab.keeper.recorder.path
    view.charts.charts.set_cursors(1.0, 3.0)
    table = presenter.state.statistics
    trace = presenter.trace
    _, data = trace.excerpt([(1.0, 3.005)]).samples()
    assert len(table.rows) == len(trace.channels)
    assert int(table.rows[0][2]) == len(data)
    assert float(table.rows[1][3].replace("−", "-")) == pytest.approx(data[:, 1].mean(), abs=5.1e-6)
    assert "B − A = 2.000 s" in table.equation
    view.statistics.copy()
    assert "GyroOut\tV" in QGuiApplication.clipboard().text()
    press(driver, "watch")
    driver.until(lambda: read_recording(path).ended)
    assert [mark.note for mark in read_recording(path).marks] == ["door opened"]


def test_a_record_whose_end_found_no_room_is_told(driver, monkeypatch):
    tab, _, _ = live_of(driver)
    record(driver, 200)
    press(driver, "stop")

    def refuse() -> None:
        raise StorageError("the disk is full")

    monkeypatch.setattr(tab.keeper.recorder._log._file, "close", refuse)
    press(driver, "watch")
    told = "The end of the record is not stored"
    driver.until(lambda: getattr(driver.app.messages.current, "what", "") == told)


def test_discard_puts_the_record_aside(driver):
    tab, presenter, _ = live_of(driver)
    record(driver, 200)
    press(driver, "stop")
    path = tab.keeper.recorder.path
    driver.answer("Discard")
    driver.until(lambda: (path.parent / "discarded" / path.name).exists())
    assert not path.exists()
    assert presenter.phase is Phase.WATCHING


def test_pause_and_hiding_channels_concern_the_display_alone(driver):
    tab, presenter, view = live_of(driver)
    record(driver, 200)
    driver.click(view.charts.buttons["pause"])
    window = view.charts.charts.window_s
    view.settings.channels.item(3).setCheckState(Qt.CheckState.Unchecked)
    assert 3 not in presenter.shown()
    count = tab.keeper.recorder.count
    driver.until(lambda: tab.keeper.recorder.count > count + 2000)
    assert view.charts.charts.window_s == window
    driver.click(view.charts.buttons["pause"])
    press(driver, "stop")
    assert tab.keeper.recorder.flush()
    assert len(read_recording(tab.keeper.recorder.path).channels) == 11


def test_intervals_means_and_exports(driver, tmp_path):
    tab, presenter, view = live_of(driver)
    record(driver, 2000)
    press(driver, "stop")
    driver.bot.wait(100)
    driver.click(view.charts.buttons["edit"])
    presenter.measures.add_interval(1.0, 2.0)
    presenter.measures.add_interval(3.0, 4.0)
    assert [one.selected for one in presenter.state.intervals] == [True, True]
    driver.click(view.charts.buttons["means"])
    driver.until(lambda: view.pages.currentWidget() is view.means)
    assert [row[2] for row in tab.means.state.rows] == ["200", "200"]
    folder = tab.keeper.recorder.path.parent
    assert (folder / "means.dat").exists()
    for key in ("csv", "excel", "mat", "svg", "png", "pdf"):
        press(driver, "export")
        view.format.setCurrentIndex(view.format.findData(key))
        view.format.activated.emit(view.format.currentIndex())
        name = tmp_path / f"out_{key}{tab.exporting.suffix(key)}"
        view.export_name.setText(str(name))
        driver.click(view.export_button)
        driver.until(name.exists)
    rows = (tmp_path / "out_csv.csv").read_text("utf-8").splitlines()
    assert rows[0].startswith("index,t [s],GyroOut [V],Temperature [degC]")
    assert len(rows) == 401
    assert (tmp_path / "out_excel.csv").read_text("utf-8-sig").splitlines()[1].count(",") >= 9
    driver.click(view.charts.buttons["deselect_all"])
    assert not any(one.selected for one in presenter.state.intervals)
    driver.click(view.charts.buttons["remove"])
    assert presenter.state.intervals == ()


def test_table_has_the_newest_on_top_and_overlay_lies_beneath(driver):
    tab, presenter, view = live_of(driver)
    record(driver, 500)
    press(driver, "stop")
    driver.bot.wait(100)
    path = tab.keeper.recorder.path
    view.pages.setCurrentWidget(view.table)
    model, trace = view.table.samples, presenter.trace
    top = model.data(model.index(0, 2))
    assert float(top.replace("−", "-")) == pytest.approx(
        trace.history.value(1, trace.newest), abs=1e-9
    )
    view.tools.decimation.setValue(10)
    assert model.rowCount() == -(-(trace.history.end - trace.history.first) // 10)
    press(driver, "watch")
    driver.until(lambda: read_recording(path).ended)
    presenter.load(path, beneath=True)
    driver.until(lambda: len(presenter.overlays) == 1)
    view.pages.setCurrentWidget(view.charts)
    driver.click(view.charts.buttons["no_overlay"])
    assert presenter.state.overlays == ()


def test_settings_come_back_and_lock_while_recording(driver):
    _, presenter, view = live_of(driver)
    view.settings.kind.setCurrentIndex(1)
    view.settings.kind.activated.emit(1)
    view.settings.profile.setValue(4)
    assert presenter.state.file.endswith("_d_pr4")
    view.settings.file.setFocus()
    view.settings.file.clear()
    driver.bot.keyClicks(view.settings.file, "mine")
    driver.bot.keyClick(view.settings.file, Qt.Key.Key_Return)
    assert presenter.state.file == "mine"
    record(driver, 100)
    assert presenter.trace.name == "mine"
    assert not view.settings.kind.isEnabled()
    assert driver.app.settings.section("live")["profile"] == 4
    press(driver, "stop")


def test_a_record_that_cannot_begin_says_why(driver):
    tab, presenter, _ = live_of(driver)
    folder = tab.keeper.folder(presenter.serial)
    folder.parent.mkdir(parents=True, exist_ok=True)
    folder.write_text("a file where the folder should be", encoding="utf-8")
    press(driver, "start")
    assert presenter.phase is Phase.WATCHING
    assert driver.app.messages.current.what == "The record cannot begin"


def test_space_starts_from_anywhere_but_a_text_field(driver):
    _, presenter, view = live_of(driver)
    assert view.charts.charts._canvas.hasFocus()
    driver.bot.keyClick(view.charts.charts._canvas, Qt.Key.Key_Space)
    driver.until(lambda: presenter.phase is Phase.RECORDING)
    driver.bot.keyClick(view.charts.charts._canvas, Qt.Key.Key_Escape)
    driver.until(lambda: presenter.phase is Phase.STOPPED)


def test_closing_the_window_ends_the_record(driver):
    tab, _, _ = live_of(driver)
    record(driver, 300)
    path = tab.keeper.recorder.path
    driver.app.close()
    assert read_recording(path).ended
