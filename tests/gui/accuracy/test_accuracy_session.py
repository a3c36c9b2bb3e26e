"""A roll session measured in the window on the simulated rig; a unit that sends angles alone."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from core.arrays import frozen, frozen_int
from core.procedures.angle_errors import ROLL, main_angle
from core.records.legacy.reader import read_legacy
from core.samples.block import Channel, SampleBlock
from gui.accuracy.tab import AccuracyTab
from gui.services import Services
from tests.gui.fake_bench import FakeConnection

G = 9.8106
RATE = 100.0
ANGLES = (
    Channel("n", "", "counter"),
    *(Channel(name, "deg", f"angle.{name}") for name in ("heading", "pitch", "roll")),
)


def test_a_roll_session_on_the_rig_to_its_verdict_and_files(open_app: Callable[[], object]):
    driver = open_app()
    app, tab = driver.app, driver.app.tabs["Accuracy"]
    assert isinstance(tab, AccuracyTab)
    app.open_simulated("sim://pointer?speed=20&seed=5&name=roll-accuracy")
    app.window.tabs.setCurrentWidget(tab.widget)
    driver.until(lambda: tab.bench.linked)
    # Roll, and a short list of angles, as an operator sets them.
    driver.click(tab._form._kind_buttons[1])
    assert tab.sitting.plan.id == "roll_accuracy"
    assert tab._form.angles.text().startswith("0, 30, 60, 80")
    field = tab._form.angles
    field.setFocus()
    field.selectAll()
    driver.bot.keyClicks(field, "0, 45, 90, 180")
    driver.bot.keyClick(field, Qt.Key.Key_Return)
    assert [step.head_deg for step in tab.sitting.plan.steps] == [0.0, 315.0, 270.0, 180.0]
    # The operator of the rig turns nearly there, looks, and sets the angle: wait that out.
    settings = replace(tab.sitting.settings, accumulation_s=4.0, settle_s=6.0, limit_deg=0.1)
    tab.presenter.set_settings(settings)
    # The dial runs against the roll: both are told.
    for row, dial, roll in ((1, "Turn to 315°", "Roll 45°. "), (0, "Turn to 0°", "Roll 0°. ")):
        tab.presenter.choose(row)
        stage = tab.presenter.state.stage
        assert stage.headline == dial
        assert roll in stage.detail
    tab.presenter.set_hands_free(True)
    app.rig.set_operator(True)
    driver.until(lambda: len(tab.sitting.keeper.positions) == 4, 60_000)
    app.rig.set_operator(False)
    driver.until(lambda: not tab.results.busy and len(tab.results.state.run) == 4)
    # The unit's own roll is 0.05 deg off (its electronics), which the limit of 0.1 allows.
    verdicts = {chip._chip.name: chip.verdict for chip in tab.page.chips if chip._chip}
    assert verdicts["Inter"] == "PASS"
    assert tab.results.state.found.trace("inter").error == pytest.approx([-0.05] * 4, abs=0.011)
    # A tighter limit fails it at once, without measuring anew.
    tab._form._limit.setValue(0.03)
    driver.until(lambda: not tab.results.busy and tab.page.chips[0].verdict == "FAIL")
    folder = tab.sitting.keeper.session.folder
    (text,) = folder.glob("Accuracy_*.txt")
    run = read_legacy(text).to_run()
    told = tab.results.state.found.trace("inter").roll
    assert run.extra["unit_roll_deg"] == pytest.approx(told, abs=0.0051)
    assert "Inter: FAIL" in (folder / "accuracy.csv").read_text(encoding="utf-8")
    tab.results.show_page("temperature")
    assert len(tab.results.page.graph.series) == 9
    tab.page.graph.grab()


class AngleConnection(FakeConnection):
    """A unit that tells heading, pitch and roll, and nothing else."""

    def __init__(self) -> None:
        super().__init__("vectornav_ascii")
        self.channels = ANGLES
        self.error_deg = 0.02

    def rest(self, roll_deg: float, seconds: float = 1.5) -> None:
        """Send samples of a unit that rests at a roll."""
        n = round(seconds * RATE)
        index = np.arange(self._next, self._next + n)
        self._next += n
        roll = roll_deg + self.error_deg + self._rng.normal(0.0, 0.03, n)
        data = np.column_stack(
            [
                index,
                np.full(n, 123.0),
                self._rng.normal(0.0, 0.03, n),
                (roll + 180.0) % 360.0 - 180.0,
            ]
        )
        for part in np.array_split(np.arange(n), n // 10):
            block = SampleBlock(self.channels, frozen_int(index[part]), frozen(data[part]), RATE)
            self.blocks.emit(block)


@pytest.fixture
def angles(qtbot: QtBot, services: Services) -> Iterator[tuple[AccuracyTab, AngleConnection]]:
    connection = AngleConnection()
    tab = AccuracyTab(replace(services, connection=connection))
    qtbot.addWidget(tab.widget)
    connection.plug("VN")
    yield tab, connection
    tab.close()


def test_a_unit_without_raw_codes_is_measured_and_judged_by_its_own_angles(
    angles: tuple[AccuracyTab, AngleConnection], qtbot: QtBot
):
    tab, connection = angles
    tab.presenter.set_plan("roll_accuracy_45")
    tab.presenter.set_settings(replace(tab.sitting.settings, accumulation_s=1.0))
    connection.rest(0.0)
    assert tab.bench.device is not None
    for step in tab.sitting.plan.steps:
        force = step.specific_force(G)[None, :]
        roll = float(main_angle(ROLL, force, full_turn=False)[0])
        tab.presenter.act("accumulate")
        connection.rest(roll)
    assert len(tab.sitting.keeper.positions) == 9
    qtbot.waitUntil(
        lambda: (
            not tab.results.busy
            and tab.results.state is not None
            and len(tab.results.state.run) == 9
        ),
        timeout=10_000,
    )
    found = tab.results.state.found
    # At 180 deg half of the samples read -180.
    assert found.trace("inter").error == pytest.approx([0.02] * 9, abs=0.01)
    assert found.trace("inter").statistics.noise_std == pytest.approx(0.03, rel=0.2)
    assert tab.results.page.chips[0].verdict == "PASS"
    assert any("no raw codes" in note.text for note in found.notes)


def test_a_unit_in_another_position_is_not_taken(angles: tuple[AccuracyTab, AngleConnection]):
    tab, connection = angles
    tab.presenter.set_plan("roll_accuracy_3")
    tab.presenter.set_settings(replace(tab.sitting.settings, accumulation_s=1.0))
    connection.rest(0.0)
    tab.presenter.act("accumulate")
    connection.rest(30.0)
    assert not tab.sitting.keeper.positions
    banner = tab._services.messages.current
    assert banner is not None
    assert "roll of 30.0 deg: this looks like roll 30°" in banner.what


def test_a_device_that_tells_no_attitude(angles: tuple[AccuracyTab, AngleConnection]):
    tab, connection = angles
    connection.channels = ANGLES[:2]
    index = frozen_int(np.arange(5))
    connection.blocks.emit(SampleBlock(connection.channels, index, frozen(np.zeros((5, 2))), RATE))
    stage = tab.presenter.state.stage
    assert stage.headline == "No pitch, no roll"


def test_a_list_that_is_none_leaves_the_plan_alone(angles: tuple[AccuracyTab, AngleConnection]):
    tab, _ = angles
    before = tab.sitting.plan
    tab._form.angles.setText("0, thirty")
    tab._form.angles.setModified(True)
    tab._form._on_angles()
    assert tab.sitting.plan == before
    assert tab._services.messages.current is not None
    assert "'thirty' is no angle" in tab._services.messages.current.meaning
    assert tab._form.angles.text().startswith("0, 30, 60")
