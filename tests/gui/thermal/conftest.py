"""The tab without the rest of the window, and cycles as files."""

from collections.abc import Callable
from pathlib import Path

import pytest

from core.plans.plan import load_plans
from core.procedures.thermal.simulated import simulated_cycle
from core.records.run_file import write_run
from core.samples.run import Run
from gui.services import Services
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
def tab(services: Services, show_tab: Callable[[ThermalTab], None]) -> ThermalTab:
    """The tab with its plots, on the screen."""
    made = ThermalTab(services)
    made.messages = services.messages
    show_tab(made)
    return made
