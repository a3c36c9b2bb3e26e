"""Rates measured one by one: what is taken, what is doubted and why, free lists, both tests."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.records.open import read_any
from gui.rate_table.settings import RateSettings, settings_of, settings_of_session
from gui.rate_table.words import seconds_and_turns
from tests.gui.desk import Desk
from tests.gui.rate_table.conftest import SLOPE, ZERO, B, G

RATES = [-100.0, -80.0, -60.0, -40.0, -20.0, 0.0, 20.0, 40.0, 60.0, 80.0, 100.0]


def processed(desk: Desk, qtbot: QtBot) -> None:
    desk.presenter.act("process")
    qtbot.waitUntil(lambda: not desk.results.busy, timeout=10_000)


def test_eleven_rates_their_file_and_their_line(rate_desk: Desk, qtbot: QtBot):
    stage = rate_desk.presenter.state.stage
    assert stage.headline == "Turn at −100 deg/s"
    assert "clockwise seen from above" in stage.detail
    assert stage.pose is not None
    assert stage.pose.rate_dps == -100.0
    for _ in RATES:
        rate_desk.measure()
    assert rate_desk.rates == RATES
    assert rate_desk.presenter.state.stage.headline == "All rates done"
    session = rate_desk.sitting.keeper.session
    assert session is not None
    assert session.legacy_path is not None
    assert session.legacy_path.name.startswith("RotationTable_")
    assert read_any(session.legacy_path).set_rate_dps.tolist() == RATES
    processed(rate_desk, qtbot)
    state = rate_desk.results.state
    assert state is not None
    fit = state.calibration.fits[0]
    assert fit.value("scale_factor") == pytest.approx(SLOPE, rel=1e-4)
    assert fit.value("bias") == pytest.approx(ZERO + B[2] * G, abs=1.0)
    assert (session.folder / "calibration.cal.json").is_file()


def test_a_table_that_turns_the_wrong_way_is_told(rate_desk: Desk):
    for _ in range(3):
        rate_desk.measure()
    wrong = replace(rate_desk.step, rate_dps=40.0)
    rate_desk.measure(wrong)
    assert len(rate_desk.rates) == 3
    assert "the table was turned the wrong way" in rate_desk.what
    assert rate_desk.presenter.state.stage.headline == "Wrong rate"


def test_a_table_that_stands_is_told(rate_desk: Desk):
    for _ in range(3):
        rate_desk.measure()
    rate_desk.measure(replace(rate_desk.step, rate_dps=0.0))
    assert "the table stood still" in rate_desk.what


def test_a_table_that_stops_in_the_middle_is_told(rate_desk: Desk):
    for _ in range(3):
        rate_desk.measure()
    rate_desk.presenter.act("accumulate")
    rate_desk.connection.turn(rate_desk.step, 0.5)
    rate_desk.connection.turn(replace(rate_desk.step, rate_dps=0.0), 0.7)
    assert len(rate_desk.rates) == 3
    assert "stopped" in rate_desk.what + rate_desk.meaning
    assert "head" not in rate_desk.meaning


def test_an_output_at_the_end_of_its_range_is_told(rate_desk: Desk):
    rate_desk.connection.limit = 6000.0
    rate_desk.measure()
    assert rate_desk.rates == []
    assert "end of its range" in rate_desk.meaning


def test_hands_free_waits_for_the_table_and_walks_by_itself(rate_desk: Desk):
    rate_desk.presenter.set_hands_free(True)
    standing = replace(rate_desk.step, rate_dps=0.0)
    rate_desk.connection.turn(standing, 4.0)
    assert rate_desk.rates == []
    last = 0.0
    for step in rate_desk.sitting.plan.steps[:4]:
        rate_desk.connection.turn(replace(step, rate_dps=last), 0.6, to_dps=step.rate_dps)
        rate_desk.connection.turn(step, 3.5)
        last = step.rate_dps
    assert rate_desk.rates == RATES[:4]


def test_free_rates_both_ways_tell_hysteresis(rate_desk: Desk, qtbot: QtBot):
    from gui.rate_table.free import free_steps, usable

    assert not usable((20.0, 20.0))
    assert usable((-20.0, 0.0))
    rate_desk.presenter.set_steps(free_steps((-40, 0, 40), ("Z_from",), both_ways=True))
    assert [step.rate_dps for step in rate_desk.sitting.plan.steps] == [-40, 0, 40, 40, 0, -40]
    for _ in range(6):
        rate_desk.measure()
    assert len(rate_desk.rates) == 6, rate_desk.what
    processed(rate_desk, qtbot)
    page = rate_desk.results.page
    assert page is not None
    cells = [cell for table in page.tables for row in table.rows for cell in row]
    assert "Hysteresis, up less down" in cells


def test_two_rates_are_processed_with_a_warning(rate_desk: Desk, qtbot: QtBot):
    rate_desk.measure()
    rate_desk.measure()
    processed(rate_desk, qtbot)
    page = rate_desk.results.page
    assert page is not None
    assert any("two rates always lie on a line" in note.text for note in page.notes)


def test_one_rate_alone_is_refused_in_words(rate_desk: Desk, qtbot: QtBot):
    for _ in range(2):
        rate_desk.presenter.choose(0)
        rate_desk.measure()
    processed(rate_desk, qtbot)
    assert rate_desk.results.page is None
    assert "every row has the same rate" in rate_desk.meaning


def test_three_axes_by_remounting(make_rate_desk: Callable[..., Desk], qtbot: QtBot):
    desk = make_rate_desk("pw09_raw", "rate_table_xyz")
    headlines: list[str] = []
    while desk.presenter.state.stage.headline != "All rates done":
        headlines.append(desk.presenter.state.stage.headline)
        desk.connection.turn(desk.step, 0.3)
        desk.measure()
        desk.taking._end_flash()
    assert len(desk.rates) == 21
    assert "Re-mount, turn at −100 deg/s" in headlines
    processed(desk, qtbot)
    state = desk.results.state
    assert state is not None
    names = {name for fit in state.calibration.fits for name in fit.names}
    assert {"scale_factor", "cross_axis_x", "cross_axis_y", "cross_axis_z"} <= names


def test_static_positions_after_the_table_give_the_whole_model(
    make_rate_desk: Callable[..., Desk], qtbot: QtBot
):
    desk = make_rate_desk()
    for _ in RATES:
        desk.measure()
    processed(desk, qtbot)
    desk.presenter.new_session()
    desk.presenter.set_plan("g_sensitivity_8")
    desk.set(accumulation_s=1.0)
    desk.connection.on_head = True
    desk.taking._end_flash()
    assert desk.presenter.state.stage.headline == "Turn to 0°"
    for _ in range(8):
        desk.measure()
    processed(desk, qtbot)
    state = desk.results.state
    assert state is not None
    fit = state.calibration.fits[0]
    assert fit.value("g_sensitivity_y") == pytest.approx(B[1], abs=0.05)
    assert fit.value("scale_factor") == pytest.approx(SLOPE, rel=1e-4)
    titles = [table.title for table in state.page.tables]
    assert titles[0] == "Rate table and head together (3.3)"
    assert "Calibrated rates, deg/s (Table 3.7)" in titles
    cells = [cell for table in state.page.tables for row in table.rows for cell in row]
    assert {"code/(m/s²)", "(deg/s)/(m/s²)", "(deg/h)/g"} <= set(cells)


def test_a_unit_with_accelerometers_is_recognised_on_the_head(
    make_rate_desk: Callable[..., Desk],
):
    desk = make_rate_desk("pw09_raw", "g_sensitivity_8")
    desk.connection.on_head = True
    for _ in range(4):
        desk.measure()
    desk.measure(desk.sitting.plan.steps[1])
    assert len(desk.rates) == 4
    assert "looks like position 2" in desk.what


def test_whole_turns_are_proposed_and_what_is_left_is_said():
    settings = RateSettings(accumulation_s=30.0)
    assert seconds_and_turns(20.0, settings) == "36 s (whole turns: 2)"
    assert seconds_and_turns(0.0, settings) == "30 s"
    broken = seconds_and_turns(20.0, replace(settings, whole_turns=False))
    assert broken == "30 s (1.67 turns; 36 s would be whole turns)"
    assert settings.seconds_at(100.0) == pytest.approx(28.8)


def test_a_worn_table_widens_the_uncertainty(rate_desk: Desk, qtbot: QtBot):
    for _ in RATES:
        rate_desk.measure()
    found: list[float] = []
    for u in (0.0, 0.2):
        rate_desk.set(rate_u_dps=u)
        processed(rate_desk, qtbot)
        state = rate_desk.results.state
        assert state is not None
        fit = state.calibration.fits[0]
        found.append(float(np.sqrt(fit.covariance[fit.index("scale_factor")][1])))
    assert found[1] > 20.0 * found[0]


def test_settings_are_kept_with_the_session_and_remembered(rate_desk: Desk):
    rate_desk.set(latitude_deg=50.45, rate_u_dps=0.02, azimuth_known=True)
    rate_desk.measure()
    session = rate_desk.sitting.keeper.session
    assert session is not None
    start = session.record.start
    assert (start.sensor, start.plan.test) == ("gyro", "rate_table")
    again = settings_of_session(start, RateSettings())
    assert (again.latitude_deg, again.rate_u_dps, again.azimuth_known) == (50.45, 0.02, True)
    remembered = settings_of(rate_desk.presenter._settings.section("rate_table"))
    assert remembered.latitude_deg == 50.45
    assert settings_of({"latitude_deg": 400, "rate_u_dps": "worn"}) == RateSettings()


def test_a_device_without_gyros_is_told(make_rate_desk: Callable[..., Desk]):
    assert make_rate_desk("adc_board9").presenter.state.stage.headline == "No gyros"


def test_an_earlier_calibration_tells_the_wrong_way_from_the_first_rate(
    make_rate_desk: Callable[..., Desk], qtbot: QtBot
):
    first = make_rate_desk()
    for _ in RATES:
        first.measure()
    processed(first, qtbot)
    first.sitting.close()
    again = make_rate_desk()
    again.measure(replace(again.step, rate_dps=100.0))
    assert again.rates == []
    assert "turned the wrong way" in again.what
