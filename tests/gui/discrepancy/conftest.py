"""A run with a hidden effect as a file and as a story; the tab without the window."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from core.discrepancy.ladder import Ladder
from core.plans.plan import Plan
from core.records.run_file import write_run
from gui.discrepancy.tab import DiscrepancyTab
from gui.discrepancy.working import Story, searched
from gui.services import Services
from tests.core.discrepancy.hidden import Truth, head_run

K2 = 6e-4
"""Hidden second-order nonlinearity, g/g^2."""


def bent(truth: Truth):
    """A parabola in the output."""
    return K2 * truth.a[:, 2] ** 2


@pytest.fixture(scope="session")
def story() -> Story:
    """A bent accelerometer, looked at and searched."""
    run = head_run(hidden=bent)
    ladder = Ladder.of(run)
    plain = Story(run, (Path("A1.run.csv"),), ladder, ladder.explanation)
    return searched(plain, lambda _: None)


@pytest.fixture
def bent_file(tmp_path: Path) -> Path:
    """The same run as a file."""
    path = tmp_path / "A1.run.csv"
    write_run(head_run(hidden=bent), path)
    return path


@pytest.fixture
def tab(services: Services, show_tab: Callable[[DiscrepancyTab], None]) -> DiscrepancyTab:
    """The tab with its plots, on the screen; plans that it hands over are kept in `opened`."""
    opened: list[Plan] = []

    def open_plan(plan: Plan) -> bool:
        opened.append(plan)
        return len(opened) == 1

    made = DiscrepancyTab(replace(services, open_plan=open_plan))
    made.messages = services.messages
    made.opened = opened
    show_tab(made)
    return made
