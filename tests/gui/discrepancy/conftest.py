"""A run with a hidden effect as a file and as a story; the tab without the window."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.discrepancy.ladder import Ladder
from core.plans.plan import Plan
from core.records.run_file import write_run
from drivers.profile import load_profiles
from gui.devices.connection import Connection
from gui.discrepancy.tab import DiscrepancyTab
from gui.discrepancy.working import Story, searched
from gui.jobs import Jobs
from gui.messages import Messages
from gui.services import Services
from gui.settings import Settings
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
def tab(qtbot: QtBot, tmp_path: Path) -> Iterator[DiscrepancyTab]:
    """The tab with its plots, on the screen; plans that it hands over are kept in `opened`."""
    jobs, messages = Jobs(), Messages()
    connection = Connection(load_profiles, lambda: tmp_path, messages)
    settings = Settings(tmp_path / "settings.json")
    opened: list[Plan] = []

    def open_plan(plan: Plan) -> bool:
        opened.append(plan)
        return len(opened) == 1

    services = Services(
        connection,
        jobs,
        messages,
        settings,
        load_profiles,
        lambda: tmp_path,
        lambda _: None,
        open_plan,
    )
    made = DiscrepancyTab(services)
    made.messages = messages
    made.opened = opened
    qtbot.addWidget(made.view)
    made.view.resize(1280, 700)
    made.view.show()
    made.after_paint()
    yield made
    made.close()
    connection.close()
    jobs.close()
