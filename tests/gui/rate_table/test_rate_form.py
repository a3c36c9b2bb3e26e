"""The form of the rate-table tab: what is shown for the table and for the head, free lists."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QLineEdit
from pytestqt.qtbot import QtBot

from gui.measuring.view import MeasuringView
from gui.rate_table.free import MOUNTINGS, free_steps
from gui.rate_table.settings import RateSettings
from gui.rate_table.settings_view import RateForm
from tests.gui.desk import Desk


@pytest.fixture
def view(rate_desk: Desk, qtbot: QtBot) -> MeasuringView:
    made = RateForm(RateSettings())
    made.rates_set.connect(
        lambda rates, mounts, both: rate_desk.presenter.set_steps(
            free_steps(rates, mounts, both_ways=both)
        )
    )
    view = MeasuringView(rate_desk.presenter, made)
    view.resize(1280, 800)
    qtbot.addWidget(view)
    view.show()
    qtbot.waitExposed(view)
    return view


@pytest.fixture
def form(view: MeasuringView) -> RateForm:
    assert isinstance(view.settings, RateForm)
    return view.settings


def shown(form: RateForm) -> set[str]:
    """Words of the fields that are shown."""
    view = form.window()
    labels = {label.text() for label, _ in form._captions if label.isVisibleTo(view)}
    buttons = {b.text() for b in form.findChildren(QAbstractButton) if b.isVisibleTo(view)}
    return labels | buttons


def test_the_table_and_the_head_have_their_own_fields(form: RateForm, rate_desk: Desk):
    table = {"u(rate), deg/s", "Whole turns of the table", "Rates of your own, deg/s"}
    head = {"u(head angle), arcsec", "Azimuth, deg"}
    common = {"Accumulation Time, sec", "Termo calibration", "Latitude, deg"}
    assert table | common <= shown(form)
    assert not head & shown(form)
    rate_desk.presenter.set_plan("g_sensitivity_4")
    assert head | common <= shown(form)
    assert not table & shown(form)


def test_every_field_reaches_the_settings(form: RateForm, rate_desk: Desk):
    form._u_rate.setValue(0.02)
    form._u_ppm.setValue(150.0)
    form._full_scale.setValue(300.0)
    form._latitude.setValue(50.45)
    form._whole.setChecked(True)
    settings = rate_desk.sitting.settings
    assert (settings.rate_u_dps, settings.rate_u_ppm) == (0.02, 150.0)
    assert (settings.full_scale_dps, settings.latitude_deg) == (300.0, 50.45)
    assert settings.whole_turns
    form._latitude.setValue(-91.0)
    assert rate_desk.sitting.settings.latitude_deg is None
    assert form._latitude.text() == "not stated"
    rate_desk.presenter.set_plan("g_sensitivity_4")
    form._azimuth_known.setChecked(True)
    form._azimuth.setValue(30.0)
    form._u_head.setValue(5.0)
    settings = rate_desk.sitting.settings
    assert (settings.azimuth_known, settings.base.psi_deg) == (True, 30.0)
    assert settings.head_u_arcsec == 5.0


def test_a_free_list_becomes_the_plan_and_a_bad_one_cannot_be_set(
    form: RateForm, rate_desk: Desk, qtbot: QtBot
):
    line: QLineEdit = form._rates
    qtbot.keyClicks(line, "10 10")
    assert not form._set.isEnabled()
    line.clear()
    qtbot.keyClicks(line, "-30; 0 12,5")
    form._mounts.setCurrentIndex(list(MOUNTINGS).index("X, Y, Z"))
    qtbot.mouseClick(form._set, Qt.MouseButton.LeftButton)
    steps = rate_desk.sitting.plan.steps
    assert [step.rate_dps for step in steps] == [-30.0, 0.0, 12.5] * 3
    assert [step.mount for step in steps[::3]] == ["X_from", "Y_from", "Z_from"]
    assert [step.number for step in steps] == list(range(1, 10))
    assert rate_desk.presenter.state.stage.headline == "Turn at −30 deg/s"


def test_what_belongs_to_the_session_is_locked(
    form: RateForm, rate_desk: Desk, make_rate_desk: Callable[..., Desk]
):
    rate_desk.measure()
    assert not form._set.isEnabled()
    assert "New session" in form._set.toolTip()
    assert form._u_rate.isEnabled()
