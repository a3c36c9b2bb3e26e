"""The presenters of the dividing-head tab on a fed connection, without a window."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from core.plans.plan import Step
from gui.dividing_head.guide import HeadGuide
from gui.dividing_head.results import HeadResults
from gui.dividing_head.settings import HeadSettings
from gui.jobs import Jobs
from gui.measuring.bench import Bench
from gui.measuring.presenter import MeasuringPresenter
from gui.measuring.sitting import Sitting
from gui.measuring.tab import plans_of
from gui.measuring.taking import Taking
from gui.messages import Messages
from gui.settings import Settings
from tests.gui.fake_bench import FakeConnection


@dataclass
class Desk:
    """Everything behind the view."""

    connection: FakeConnection
    messages: Messages
    bench: Bench
    sitting: Sitting[HeadSettings]
    taking: Taking
    results: HeadResults
    presenter: MeasuringPresenter[HeadSettings]
    jobs: Jobs
    root: Path
    cues: list[str]

    @property
    def step(self) -> Step:
        """The current step."""
        status = self.sitting.walk.status
        assert status is not None
        assert status.step is not None
        return status.step

    @property
    def numbers(self) -> list[int]:
        """Steps of the positions that count."""
        return [position.step.number for position in self.sitting.keeper.positions]

    @property
    def what(self) -> str:
        """Headline of the banner."""
        return "" if self.messages.current is None else self.messages.current.what

    def measure(self, step: Step | None = None) -> None:
        """Press Accumulate Data with the unit standing in a step; the current one if none."""
        self.presenter.act("accumulate")
        self.connection.stand(step or self.step)

    def set(self, **values: object) -> None:
        """Change settings."""
        self.presenter.set_settings(replace(self.sitting.settings, **values))


@pytest.fixture
def make_desk(qapp: object, tmp_path: Path) -> Iterator[Callable[..., Desk]]:
    """Build a desk; a second one on the same folder is the next start of the program."""
    desks: list[Desk] = []

    def make(profile_id: str = "pw09_raw", plan_id: str = "pointer_8") -> Desk:
        guide = HeadGuide()
        plans = plans_of(guide.tests)
        messages, jobs = Messages(), Jobs()
        connection = FakeConnection(profile_id)
        bench = Bench(connection, guide.device_of, guide.missing)
        settings = HeadSettings(plan_id=plan_id, accumulation_s=1.0, settle_s=0.2)
        root = tmp_path / "data"
        root.mkdir(exist_ok=True)
        sitting = Sitting(guide, bench, messages, lambda: root, plans[plan_id], settings)
        taking = Taking(sitting, bench, messages)
        results = HeadResults(guide.key, jobs, messages)
        presenter = MeasuringPresenter(
            bench, sitting, taking, results, plans, Settings(tmp_path / "settings.json")
        )
        cues: list[str] = []
        taking.cue.connect(cues.append)
        desk = Desk(
            connection, messages, bench, sitting, taking, results, presenter, jobs, root, cues
        )
        connection.plug("0917" if profile_id == "adc_board9" else "PW09")
        connection.stand(plans[plan_id].steps[0], 0.2)
        desks.append(desk)
        return desk

    yield make
    for desk in desks:
        desk.sitting.close()
        desk.jobs.close()


@pytest.fixture
def desk(make_desk: Callable[..., Desk]) -> Desk:
    """The attitude unit, eight positions of a second each."""
    return make_desk()
