"""The tab Methods with real jobs, and runs of every kind on the disk."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.plans.plan import Plan
from core.procedures.fourier.readings import run_of_angles
from core.procedures.gyrocompass import run_of_headings
from core.records.run_file import write_run
from core.units import DPH_PER_DPS, EARTH_RATE_DPS
from gui.methods.tab import MethodsTab
from gui.services import Services

HEAD = np.arange(5.0, 401.0, 5.0)
LATITUDE = 50.45


@pytest.fixture
def opened() -> list[Plan]:
    """Plans that were handed over."""
    return []


@pytest.fixture
def unseen_tab(
    qtbot: QtBot, tmp_path: Path, services: Services, opened: list[Plan]
) -> Iterator[MethodsTab]:
    """The tab behind another one."""
    root = tmp_path / "root"
    root.mkdir()

    def take(plan: Plan) -> bool:
        opened.append(plan)
        return plan.test != "headings"

    made = MethodsTab(replace(services, root=lambda: root, open_plan=take))
    made.messages = services.messages
    made.root = root
    qtbot.addWidget(made.view)
    made.view.resize(1280, 700)
    yield made
    made.close()


@pytest.fixture
def tab(unseen_tab: MethodsTab) -> MethodsTab:
    """The tab on the screen."""
    unseen_tab.view.show()
    return unseen_tab


@pytest.fixture
def tumble_file(tmp_path: Path) -> Callable[..., Path]:
    """A tumble of the source's sensor, five realisations."""

    def make(name: str = "t.run.csv", *, flipped: bool = False, noise: float = 1e-5) -> Path:
        alpha = np.radians(HEAD + 0.1121)
        u = 2.5 - np.sin(alpha) - 0.0098 * np.cos(alpha) + 0.001 * np.sin(alpha) * np.cos(alpha)
        rng = np.random.default_rng(3)
        readings = u[:, None] + noise * rng.standard_normal((80, 5))
        path = tmp_path / name
        write_run(run_of_angles(HEAD, readings, "V", flipped=flipped, device="DXL203"), path)
        return path

    return make


@pytest.fixture
def headings_file(tmp_path: Path) -> Callable[..., Path]:
    """A gyro at five headings; the axis stands at 37.3 degrees, the drift is 0.8 deg/h."""

    def make(
        name: str = "g.run.csv",
        unit: str = "deg/h",
        factor: float = 1.0,
        headings: tuple[float, ...] = (0.0, 90.0, 180.0, 270.0, 360.0),
    ) -> Path:
        h = np.array(headings)
        level = EARTH_RATE_DPS * DPH_PER_DPS * np.cos(np.radians(LATITUDE))
        noise = np.random.default_rng(3).normal(0.0, 0.012, len(h))
        w = level * np.cos(np.radians(h + 37.3)) + 0.8 + noise
        run = run_of_headings(
            h,
            w * factor,
            unit,
            se=np.full(len(h), 0.012 * abs(factor)),
            t_s=np.arange(len(h)) * 20.0,
            device="CVG48",
        )
        path = tmp_path / name
        write_run(run, path)
        return path

    return make
