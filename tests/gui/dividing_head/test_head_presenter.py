"""The tab's state: layouts, settings, sessions, what can be pressed and why not."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from core.plans.orientation import BaseOrientation
from core.records.session.find import unfinished
from gui.dividing_head.settings import HeadSettings, Tilter, settings_of, settings_of_session
from gui.settings import Settings
from gui.widgets.states import StepMark
from tests.gui.desk import Desk


def enabled(desk: Desk) -> set[str]:
    """Keys of the buttons that can be pressed."""
    return {item.key for item in desk.presenter.state.actions.items if item.enabled}


def test_the_layout_follows_the_device(make_desk: Callable[..., Desk]):
    assert make_desk().presenter.state.layout == "pointer"
    assembly = make_desk("adc_board9", "accelerometer_8").presenter.state
    assert assembly.layout == "clbacc"
    assert assembly.temperatures == (27.0, -10.0, -40.0, -10.0, 27.0, 50.0, 70.0, 50.0, 27.0)


def test_a_device_without_accelerometers_is_told(make_desk: Callable[..., Desk]):
    state = make_desk("cvgx48").presenter.state
    assert state.stage.headline == "No accelerometers"
    assert "accumulate" not in {item.key for item in state.actions.items if item.enabled}


def test_what_can_be_pressed_follows_the_work(desk: Desk):
    assert enabled(desk) == {"accumulate", "load"}
    desk.presenter.act("accumulate")
    assert enabled(desk) == {"stop"}
    desk.connection.stand(desk.step)
    assert enabled(desk) == {"accumulate", "repeat", "discard", "load", "process"}
    desk.connection.interrupted.emit()
    assert enabled(desk) == {"discard", "load", "process"}
    reasons = {item.why_not for item in desk.presenter.state.actions.items if not item.enabled}
    assert reasons == {"The link is lost"}


def test_the_session_locks_the_plan_and_new_session_frees_it(desk: Desk):
    assert desk.presenter.state.locked.plan == ""
    assert desk.presenter.state.session_editable
    desk.presenter.set_session_name("../my unit")
    desk.measure()
    state = desk.presenter.state
    assert "New session" in state.locked.plan
    assert not state.session_editable
    assert state.session == "my_unit"
    assert (desk.root / "my_unit" / "session.json").is_file()
    desk.presenter.new_session()
    assert desk.presenter.state.locked.plan == ""
    assert desk.presenter.state.session != "my_unit"
    assert [step.replicates for step in desk.presenter.state.steps] == [0] * 8


def test_two_sessions_of_one_name_do_not_share_a_folder(desk: Desk):
    for _ in range(2):
        desk.presenter.set_session_name("same")
        desk.measure()
        desk.presenter.new_session()
    assert sorted(path.parent.name for path in desk.root.glob("*/session.json")) == [
        "same",
        "same_2",
    ]


def test_settings_are_kept_with_the_session_and_remembered(desk: Desk):
    base = BaseOrientation(3.0, -2.0, 0.5, 90.0)
    desk.set(base=base, g_mps2=9.8155, tilter=Tilter("Auto", 2, 3))
    desk.measure()
    session = desk.sitting.keeper.session
    assert session is not None
    start = session.record.start
    assert start.base == base
    assert start.conditions.g_mps2 == 9.8155
    assert start.tilter["mode"] == "Auto"
    assert start.tilter["position"] == 3.0
    again = settings_of_session(start, HeadSettings())
    assert (again.base, again.tilter.number) == (base, 2)
    remembered = settings_of(desk.presenter._settings.section("dividing_head"))
    assert remembered.g_mps2 == 9.8155
    assert remembered.base == base


def test_impossible_preferences_take_their_defaults(tmp_path: object):
    found = settings_of({"g_mps2": "heavy", "passes": 1e9, "base": 3, "cycle_c": ["hot"]})
    assert found == replace(HeadSettings(), plan_id=found.plan_id)


def test_a_free_angle_becomes_a_position(desk: Desk):
    desk.presenter.add_angle("X_from", 45.0)
    assert desk.step.head_deg == 45.0
    assert desk.presenter.state.steps[-1].group == "Free angles"
    desk.measure()
    assert desk.numbers == [17]
    session = desk.sitting.keeper.session
    assert session is not None
    # Pointer's file has numbers for its 16 positions only: this session writes none.
    assert session.legacy_path is None


def test_the_steps_show_what_was_measured(desk: Desk):
    desk.measure()
    first, second = desk.presenter.state.steps[:2]
    assert first.mark is StepMark.DONE
    assert len(first.values.split()) == 3
    assert second.mark is StepMark.NOW
    assert first.group == "Rotation Around X axis, X from ODH"


def test_an_interrupted_session_goes_on_where_it_stood(make_desk: Callable[..., Desk]):
    first = make_desk()
    first.set(base=BaseOrientation(1.0, 0.0, 0.0, 0.0))
    first.presenter.add_angle("X_from", 45.0)
    first.measure()
    first.presenter.choose(0)
    first.measure()
    first.sitting.close()
    (waiting,) = unfinished(first.root)
    assert waiting.record is not None
    second = make_desk()
    start = waiting.record.start
    second.sitting.resume(waiting.folder, settings_of_session(start, second.sitting.settings))
    assert second.numbers == [17, 1]
    assert second.sitting.settings.base.alpha_arcmin == 1.0
    assert second.step.number == 2
    assert second.sitting.plan.step(17).head_deg == 45.0
    second.measure()
    assert second.numbers == [17, 1, 2]


def test_another_kind_of_device_cannot_go_on_with_a_session(make_desk: Callable[..., Desk]):
    first = make_desk()
    first.measure()
    first.sitting.close()
    (waiting,) = unfinished(first.root)
    assert waiting.record is not None
    other = make_desk("adc_board9", "accelerometer_8")
    settings = settings_of_session(waiting.record.start, other.sitting.settings)
    other.sitting.resume(waiting.folder, settings)
    assert other.sitting.walk.status is None
    assert "cannot go on with the session of PW09" in other.what
    other.presenter.new_session()
    assert other.what == ""
    assert other.sitting.walk.status is not None


def test_the_live_table_is_in_mg_once_the_scale_is_known(desk: Desk):
    desk.connection.stand(desk.step, 1.5)
    before = desk.presenter.live()
    assert before.std_unit == "code"
    assert [row.name for row in before.rows] == ["X", "Y", "Z"]
    assert before.has_others
    assert all(row.mean and row.temp and row.other_mean for row in before.rows)
    desk.results.live_scale = {f"acc.{axis}": 1.0 / 13.1 for axis in "xyz"}
    after = desk.presenter.live()
    assert after.std_unit == "mg"
    ratio = float(before.rows[0].std) / float(after.rows[0].std)
    assert np.isclose(ratio, 13.1, rtol=0.05)


def test_preferences_survive_a_round_trip(desk: Desk):
    desk.set(accumulation_s=7.0, cycle_c=(20.0, 60.0))
    store = desk.presenter._settings
    store.save()
    again = settings_of(Settings(store.path).section("dividing_head"))
    assert again.accumulation_s == 7.0
    assert again.cycle_c == (20.0, 60.0)
