"""What becomes of an accumulation: taken, doubted, repeated, discarded, taken back."""

import json
from collections.abc import Callable

import pytest

from core.errors import StorageError
from core.procedures.measuring import Phase
from core.records.open import read_any
from core.records.session.events import Position
from core.records.session.record import read_session
from gui.measuring.keeper import Keeper
from tests.gui.desk import Desk


def on_disk(desk: Desk) -> list[int]:
    """Steps in the journal as another program would read it now."""
    folders = [path.parent for path in desk.root.glob("*/session.json")]
    return [p.step.number for folder in folders for p in read_session(folder).positions]


def test_a_position_is_on_the_disk_before_the_screen_says_so(desk: Desk):
    seen: list[list[int]] = []
    desk.taking.cue.connect(lambda cue: seen.append(on_disk(desk)) if cue == "done" else None)
    desk.measure()
    assert seen == [[1]]
    assert desk.presenter.state.stage.headline == "Position 1 done"
    assert desk.cues == ["start", "done"]


def test_the_whole_plan_and_its_files(desk: Desk):
    for _ in range(8):
        desk.measure()
    assert desk.numbers == [1, 2, 3, 4, 13, 14, 15, 16]
    assert desk.presenter.state.stage.headline == "All positions done"
    session = desk.sitting.keeper.session
    assert session is not None
    assert session.legacy_path is not None
    run = read_any(session.legacy_path)
    assert list(run.extra["step"]) == desk.numbers
    desk.sitting.close()
    assert read_session(session.folder).is_finished


def test_a_wrong_position_is_not_recorded(desk: Desk):
    for _ in range(4):
        desk.measure()
    desk.measure(desk.sitting.plan.step(2))
    assert desk.numbers == [1, 2, 3, 4]
    assert desk.presenter.state.stage.headline == "Wrong position"
    assert "looks like position 2" in desk.what
    assert desk.cues[-1] == "error"
    banner = desk.messages.current
    assert banner is not None
    keys = [action.key for action in banner.actions]
    assert keys == ["accept as 2", "repeat", "take"]


def test_it_can_be_taken_under_the_number_that_it_looks_like(desk: Desk):
    for _ in range(4):
        desk.measure()
    desk.measure(desk.sitting.plan.step(2))
    desk.messages.press("accept as 2")
    assert desk.numbers == [1, 2, 3, 4, 2]
    last = desk.sitting.keeper.last
    assert last is not None
    (note,) = (n for n in last.accumulation.notes if n.subject == "taken_anyway")
    assert "accumulated for position 13" in note.text
    assert desk.what == ""


def test_it_can_be_taken_as_it_is_with_a_note_that_stays(desk: Desk):
    for _ in range(4):
        desk.measure()
    desk.measure(desk.sitting.plan.step(2))
    desk.messages.press("take")
    assert desk.numbers[-1] == 13
    session = desk.sitting.keeper.session
    assert session is not None
    notes = read_session(session.folder).positions[-1].accumulation.notes
    assert any("taken by the operator" in note.text for note in notes)


def test_a_head_that_moves_is_told_and_can_be_repeated(desk: Desk):
    desk.presenter.act("accumulate")
    desk.connection.stand(desk.step, turn_dps=4.0)
    assert desk.numbers == []
    assert desk.what == "The head moved"
    assert desk.presenter.state.stage.headline == "Not taken"
    desk.messages.press("repeat")
    assert desk.sitting.walk.measuring
    assert desk.what == ""
    desk.connection.stand(desk.step)
    assert desk.numbers == [1]


def test_stop_and_a_lost_link_give_up_that_accumulation_only(desk: Desk):
    desk.measure()
    desk.presenter.act("accumulate")
    desk.connection.stand(desk.step, 0.5)
    desk.presenter.act("stop")
    assert not desk.sitting.walk.measuring
    desk.presenter.act("accumulate")
    desk.connection.stand(desk.step, 0.5)
    desk.connection.interrupted.emit()
    assert desk.presenter.state.stage.headline == "Link lost"
    assert not desk.sitting.walk.measuring
    desk.connection.stand(desk.step, 0.2)
    assert desk.presenter.state.stage.headline != "Link lost"
    desk.measure()
    assert desk.numbers == [1, 2]


def test_repeat_supersedes_and_undo_brings_the_first_back(desk: Desk):
    desk.measure()
    desk.presenter.act("repeat")
    desk.connection.stand(desk.sitting.plan.step(1))
    (again,) = desk.sitting.keeper.positions
    assert (again.step.number, again.attempt) == (1, 2)
    desk.presenter.act("undo")
    (first,) = desk.sitting.keeper.positions
    assert first.attempt == 1
    assert on_disk(desk) == [1]


def test_discard_reopens_the_position_and_undo_closes_it(desk: Desk):
    desk.measure()
    desk.measure()
    desk.presenter.act("discard")
    assert desk.numbers == [1]
    assert desk.step.number == 2
    desk.presenter.act("undo")
    assert desk.numbers == [1, 2]
    desk.presenter.choose(0)
    desk.presenter.act("discard")
    assert desk.numbers == [2]
    assert desk.step.number == 1


def test_a_done_position_that_is_picked_again_is_a_replicate(desk: Desk):
    desk.measure()
    desk.measure()
    desk.presenter.choose(0)
    desk.measure()
    assert desk.numbers == [1, 2, 1]
    assert desk.presenter.state.steps[0].replicates == 2
    assert desk.step.number == 3


def test_several_passes_walk_the_plan_again(make_desk: Callable[..., Desk]):
    desk = make_desk(plan_id="accelerometer_4")
    desk.set(passes=2)
    for _ in range(4):
        desk.measure()
    assert desk.presenter.state.stage.headline != "All positions done"
    assert desk.step.number == 1
    for _ in range(4):
        desk.measure()
    assert desk.numbers == [1, 2, 3, 4, 1, 2, 3, 4]
    assert desk.presenter.state.stage.headline == "All positions done"


def test_hands_free_walks_by_itself_and_offers_what_stands_there(desk: Desk):
    desk.presenter.set_hands_free(True)
    for step in desk.sitting.plan.steps[:5]:
        desk.connection.stand(step, 0.5, turn_dps=-90.0)
        desk.connection.stand(step, 3.5)
    assert desk.numbers == [1, 2, 3, 4, 13]
    wrong = desk.sitting.plan.step(3)
    desk.connection.stand(wrong, 0.5, turn_dps=-90.0)
    desk.connection.stand(wrong, 2.5)
    assert desk.numbers == [1, 2, 3, 4, 13]
    banner = desk.messages.current
    assert banner is not None
    assert any(action.key == "measure 3" for action in banner.actions)
    desk.messages.press("measure 3")
    desk.connection.stand(wrong, 3.5)
    assert desk.numbers == [1, 2, 3, 4, 13, 3]


def test_what_cannot_be_stored_is_kept_and_can_be_stored_again(desk: Desk):
    desk.measure()
    stubborn = Stubborn(desk.sitting.keeper)
    desk.sitting.keeper = stubborn
    desk.measure()
    assert desk.numbers == [1]
    assert "not on the disk" in desk.what
    assert desk.cues[-1] == "error"
    stubborn.full = False
    desk.messages.press("store")
    assert desk.numbers == [1, 2]
    assert desk.what == ""
    assert desk.cues[-1] == "done"


class Stubborn(Keeper):
    """A keeper whose disk is full until it is not."""

    def __init__(self, keeper: Keeper) -> None:
        self.__dict__.update(keeper.__dict__)
        self.full = True

    def accept(self, *args: object, **named: object) -> Position:
        if self.full:
            raise StorageError("no space left on the disk")
        return super().accept(*args, **named)


def test_a_thermal_cycle_asks_for_the_next_temperature(make_desk: Callable[..., Desk]):
    desk = make_desk(plan_id="accelerometer_4")
    desk.set(thermo=True, cycle_c=(27.0, -10.0, 27.0))
    for _ in range(4):
        desk.measure()
    assert desk.what == "All positions at +27 °C are done"
    desk.messages.press("next")
    assert desk.presenter.state.settings.visit == 1
    assert [step.replicates for step in desk.presenter.state.steps] == [0, 0, 0, 0]
    desk.measure()
    session = desk.sitting.keeper.session
    assert session is not None
    set_c = [position.set_temperature_c for position in session.positions]
    assert set_c == [27.0] * 4 + [-10.0]


def test_the_raw_bytes_are_synced_and_named_in_the_journal(desk: Desk, tmp_path: object):
    link = desk.connection.link
    assert link is not None
    link.raw_path = desk.root / "raw.calrec"
    link.raw_path.write_bytes(bytes(1000))
    link.raw_size = 300
    desk.measure()
    assert link.synced == 1
    session = desk.sitting.keeper.session
    assert session is not None
    assert (session.folder / "raw.calrec").read_bytes() == bytes(1000)
    line = (session.folder / "positions.jsonl").read_text().splitlines()[-1]
    raw = json.loads(line)["event"]["position"]["raw"]
    assert raw == {"name": "raw.calrec", "first": 300, "last": 1000}


@pytest.mark.parametrize("key", ["discard", "undo", "repeat"])
def test_nothing_to_take_back_is_no_error(desk: Desk, key: str):
    desk.presenter.act(key)
    status = desk.sitting.walk.status
    assert status is not None
    assert status.phase is Phase.READY
