"""The tab without the rest of the window, and cycles as files."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.plans.plan import load_plans
from core.procedures.thermal.simulated import simulated_cycle
from core.records.run_file import write_run
from core.samples.run import Run
from drivers.profile import load_profiles
from gui.devices.connection import Connection
from gui.jobs import Jobs
from gui.messages import Messages
from gui.services import Services
from gui.settings import Settings
from gui.thermal.tab import ThermalTab


def cycle(seed: int = 1) -> Run:
    """The packaged cycle of a simulated triad."""
    return simulated_cycle(load_plans()["thermal_8"], seed)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The cycle as nine files, one a temperature, as ClbAcc left them."""
    made = tmp_path / "cycle"
    made.mkdir()
    whole = cycle()
    for place in range(9):
        write_run(whole.rows(range(8 * place, 8 * place + 8)), made / f"{place}.run.csv")
    return made


@pytest.fixture
def tab(qtbot: QtBot, tmp_path: Path) -> Iterator[ThermalTab]:
    """The tab with its plots, on the screen."""
    jobs, messages = Jobs(), Messages()
    connection = Connection(load_profiles, lambda: tmp_path, messages)
    settings = Settings(tmp_path / "settings.json")
    services = Services(
        connection, jobs, messages, settings, load_profiles, lambda: tmp_path, lambda _: None
    )
    made = ThermalTab(services)
    made.messages = messages
    qtbot.addWidget(made.view)
    made.view.resize(1280, 700)
    made.view.show()
    made.after_paint()
    yield made
    made.close()
    connection.close()
    jobs.close()
