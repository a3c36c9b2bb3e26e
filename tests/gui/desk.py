"""The presenters of a measuring tab on a fed connection, without a window."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from core.plans.plan import Step
from gui.jobs import Jobs
from gui.measuring.bench import Bench
from gui.measuring.guide import Guide
from gui.measuring.presenter import MeasuringPresenter
from gui.measuring.results import Results
from gui.measuring.sitting import Sitting
from gui.measuring.tab import plans_of
from gui.measuring.taking import Taking
from gui.messages import Messages
from gui.settings import Settings


@dataclass
class Desk:
    """Everything behind the view; `send` has the connection send what a step asks for."""

    connection: Any
    messages: Messages
    bench: Bench
    sitting: Sitting[Any]
    taking: Taking
    results: Any
    presenter: MeasuringPresenter[Any]
    jobs: Jobs
    root: Path
    cues: list[str]
    send: Callable[[Step], None]

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
    def rates(self) -> list[float]:
        """Set rates of what counts."""
        return [position.step.rate_dps for position in self.sitting.keeper.positions]

    @property
    def what(self) -> str:
        """Headline of the banner."""
        return "" if self.messages.current is None else self.messages.current.what

    @property
    def meaning(self) -> str:
        """Sentence of the banner."""
        return "" if self.messages.current is None else self.messages.current.meaning

    def measure(self, step: Step | None = None) -> None:
        """Press Accumulate Data with the unit as a step asks; the current one if none."""
        self.presenter.act("accumulate")
        self.send(step or self.step)

    def set(self, **values: object) -> None:
        """Change settings."""
        self.presenter.set_settings(replace(self.sitting.settings, **values))


@contextmanager
def desks(tmp_path: Path) -> Iterator[Callable[..., Desk]]:
    """Build desks, all on one folder; end them at last."""
    made: list[Desk] = []

    def make(
        guide: Guide[Any],
        connection: Any,
        send: Callable[[Step], None],
        settings: Any,
        results_of: Callable[[str, Jobs, Messages], Results],
    ) -> Desk:
        plans = plans_of(guide.tests)
        messages, jobs = Messages(), Jobs()
        bench = Bench(connection, guide.device_of, guide.missing)
        root = tmp_path / "data"
        root.mkdir(exist_ok=True)
        plan = plans[settings.plan_id]
        sitting = Sitting(guide, bench, messages, lambda: root, plan, settings)
        taking = Taking(sitting, bench, messages)
        results = results_of(guide.key, jobs, messages)
        presenter = MeasuringPresenter(
            bench, sitting, taking, results, plans, Settings(tmp_path / "settings.json")
        )
        cues: list[str] = []
        taking.cue.connect(cues.append)
        desk = Desk(
            connection, messages, bench, sitting, taking, results, presenter, jobs, root, cues, send
        )
        made.append(desk)
        return desk

    yield make
    for desk in made:
        desk.sitting.close()
        desk.jobs.close()
