"""The tab's widgets: what they show of a state, and what clicks ask for."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDoubleSpinBox
from pytestqt.qtbot import QtBot

from gui.dividing_head.settings import HeadSettings
from gui.dividing_head.settings_view import HeadForm
from gui.measuring.live_view import LiveTable
from gui.measuring.state import LiveRow, LiveState
from gui.measuring.view import MeasuringView
from tests.gui.desk import Desk


@pytest.fixture
def view_of(qtbot: QtBot) -> Callable[[Desk], MeasuringView]:
    def make(desk: Desk) -> MeasuringView:
        form = HeadForm(HeadSettings())
        form.angle_added.connect(desk.presenter.add_angle)
        view = MeasuringView(desk.presenter, form)
        view.resize(1280, 700)
        qtbot.addWidget(view)
        view.show()
        qtbot.waitExposed(view)
        return view

    return make


def labels(view: MeasuringView) -> set[str]:
    """Words of the settings that are shown."""
    return {label.text() for label, _ in view.settings._captions if label.isVisibleTo(view)}


def test_the_pointer_layout_has_its_words(desk: Desk, view_of: Callable[[Desk], MeasuringView]):
    view = view_of(desk)
    assert {"Accumulation Time, sec", "Base orientation", "Tilter", "Free angle"} <= labels(view)
    assert view.settings._thermo.text() == "Termo calibration"
    assert view.settings._thermo.isVisibleTo(view)
    assert [button.text() for button in view.settings._mode_buttons] == ["None", "Auto", "Manual"]
    buttons = [view.action_bar.button(key).text() for key in ("accumulate", "load", "process")]
    assert buttons == ["Accumulate Data", "Load Data", "Process Data"]


def test_the_clbacc_layout_has_temperatures_and_no_tilter(
    make_desk: Callable[..., Desk], view_of: Callable[[Desk], MeasuringView]
):
    view = view_of(make_desk("adc_board9", "accelerometer_8"))
    assert "Temperatures, °C" in labels(view)
    assert "Tilter" not in labels(view)
    assert "Base orientation" not in labels(view)
    texts = [
        view.settings._temperature.itemText(i) for i in range(view.settings._temperature.count())
    ]
    assert texts == ["+27", "−10", "−40", "−10", "+27", "+50", "+70", "+50", "+27"]
    desk_temperatures = view.settings._temperature
    desk_temperatures.setCurrentIndex(1)
    desk_temperatures.activated.emit(1)
    assert view._presenter.state.settings.visit == 1


def test_every_field_reaches_the_settings(
    desk: Desk, view_of: Callable[[Desk], MeasuringView], qtbot: QtBot
):
    view = view_of(desk)
    fields = view.settings
    fields._accumulation.setValue(12.5)
    fields._settle.setValue(4.0)
    fields._passes.setValue(3)
    fields._g.setValue(9.8155)
    fields._u_g.setValue(0.0002)
    fields._u_head.setValue(5.0)
    for place, value in enumerate((1.0, 2.0, 3.0, 4.0)):
        fields._base[place].setValue(value)
    qtbot.mouseClick(fields._mode_buttons[2], Qt.MouseButton.LeftButton)
    for place, value in enumerate((10.0, 20.0, 30.0)):
        fields._tilt[place].setValue(value)
    settings = desk.sitting.settings
    assert (settings.accumulation_s, settings.settle_s, settings.passes) == (12.5, 4.0, 3)
    assert (settings.g_mps2, settings.u_g_mps2, settings.head_u_arcsec) == (9.8155, 0.0002, 5.0)
    base = settings.base
    angles = (base.alpha_arcmin, base.beta_arcmin, base.gamma_deg, base.psi_deg)
    assert angles == (1.0, 2.0, 3.0, 4.0)
    assert settings.tilter.angles_deg == (10.0, 20.0, 30.0)
    assert fields._manual_row.isVisibleTo(view)


def test_the_thermal_cycle_can_be_edited(
    desk: Desk, view_of: Callable[[Desk], MeasuringView], qtbot: QtBot
):
    view = view_of(desk)
    fields = view.settings
    fields._thermo.setChecked(True)
    assert fields._temperature.isVisibleTo(view)
    qtbot.mouseClick(fields._thermo_settings, Qt.MouseButton.LeftButton)
    assert fields._cycle.isVisibleTo(view)
    fields._cycle.setText("20; -5,5 60")
    fields._cycle.editingFinished.emit()
    assert desk.sitting.settings.cycle_c == (20.0, -5.5, 60.0)
    fields._cycle.setText("20 warm")
    fields._cycle.editingFinished.emit()
    assert desk.sitting.settings.cycle_c == (20.0, -5.5, 60.0)


def test_what_belongs_to_the_session_is_locked_with_a_reason(
    desk: Desk, view_of: Callable[[Desk], MeasuringView]
):
    view = view_of(desk)
    assert view._plan.isEnabled()
    desk.measure()
    assert not view._plan.isEnabled()
    assert "New session" in view._plan.toolTip()
    assert not view.settings._base[0].isEnabled()
    assert view.settings._g.isEnabled()
    view._new.click()
    assert view._plan.isEnabled()


def test_a_plan_and_a_free_angle_are_chosen(desk: Desk, view_of: Callable[[Desk], MeasuringView]):
    view = view_of(desk)
    place = view._plan.findData("pointer_16")
    view._plan.setCurrentIndex(place)
    view._plan.activated.emit(place)
    assert len(desk.presenter.state.steps) == 16
    view.settings._free_mount.setCurrentIndex(2)
    view.settings._free_angle.setValue(33.0)
    view.settings._add.click()
    assert (desk.step.mount, desk.step.head_deg) == ("Y_from", 33.0)


def test_the_session_name_is_edited_before_it_begins(
    desk: Desk, view_of: Callable[[Desk], MeasuringView], qtbot: QtBot
):
    view = view_of(desk)
    view._session.selectAll()
    qtbot.keyClicks(view._session, "morning run")
    qtbot.keyClick(view._session, Qt.Key.Key_Return)
    desk.measure()
    assert (desk.root / "morning_run").is_dir()
    assert view._session.isReadOnly()


def test_results_stand_beside_or_below_the_stage_and_never_over_it(
    desk: Desk, view_of: Callable[[Desk], MeasuringView], qtbot: QtBot
):
    view = view_of(desk)
    for _ in range(8):
        desk.measure()
    desk.presenter.act("process")
    qtbot.waitUntil(lambda: desk.results.state is not None, timeout=10_000)
    view.results.render(desk.results.page)
    for width, beside in ((1700, True), (1000, False)):
        view.resize(width, 900)
        qtbot.wait(50)
        assert view.stage.isVisible()
        assert view.results.isVisible()
        stage = view.stage.rect().translated(view.stage.mapTo(view, view.stage.rect().topLeft()))
        page = view.results.rect().translated(
            view.results.mapTo(view, view.results.rect().topLeft())
        )
        assert not stage.intersects(page)
        assert (page.left() > stage.right()) is beside
    view.results.closed.emit()


def test_the_live_table_shows_what_is_there(qtbot: QtBot):
    table = LiveTable()
    qtbot.addWidget(table)
    table.resize(700, 200)
    table.show()
    row = LiveRow("X", "1.0", "0.5", "7963", "−517.0", "25365")
    table.render(LiveState((row,), std_unit="mg", has_others=True))
    texts = [table.horizontalHeaderItem(i).text() for i in range(table.columnCount())]
    assert texts[1] == "\nSTD (mg)"
    assert [table.item(0, i).text() for i in range(5)] == ["1.0", "0.5", "7963", "−517.0", "25365"]
    table.render(LiveState((replace(row, other_mean="", other_temp=""),)))
    assert table.columnCount() == 3
    table.render(LiveState())
    assert not table.isVisible()


def test_fields_do_not_change_under_the_wheel_of_a_scroll(
    desk: Desk, view_of: Callable[[Desk], MeasuringView]
):
    view = view_of(desk)
    fields = view.settings.findChildren(QDoubleSpinBox)
    assert fields
    assert all(field.focusPolicy() is not Qt.FocusPolicy.WheelFocus for field in fields)
