"""The tab on a folder with sessions and calibrations, without the rest of the window."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from gui.archive.tab import ArchiveTab
from gui.services import Services
from tests.core.archive.conftest import SPECIMENS, STATED, calibrated, measured


@pytest.fixture(scope="session")
def triad() -> Calibration:
    """Table 2.2: three accelerometers in eight positions."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    return calibrate(run, STATED)


@pytest.fixture
def root(tmp_path: Path) -> Path:
    folder = tmp_path / "CalRig"
    folder.mkdir()
    return folder


@pytest.fixture
def filled(root: Path, triad: Calibration) -> Path:
    """Three sessions of one unit with their calibrations, and one of another."""
    for year, bias in ((2023, 0.0), (2024, 1.0), (2025, 30.0)):
        when = f"{year}-03-01T10:00:00+00:00"
        folder = measured(root / f"{year}0301_PW09", started=when)
        calibrated(triad, folder, when=when, bias=bias)
    measured(root / "20250401_PW10", device="PW10", started="2025-04-01T10:00:00+00:00")
    return root


@pytest.fixture
def opened() -> list[tuple[str, Path]]:
    """What was handed to other tabs."""
    return []


@pytest.fixture
def tab(
    qtbot: QtBot, services: Services, root: Path, opened: list[tuple[str, Path]]
) -> Iterator[ArchiveTab]:
    """The tab, not yet on the screen."""

    def open_file(title: str, path: Path) -> bool:
        opened.append((title, path))
        return title != "Accuracy"

    made = ArchiveTab(replace(services, root=lambda: root, open_file=open_file))
    qtbot.addWidget(made.view)
    made.view.resize(1280, 700)
    made.after_paint()
    yield made
    made.close()


def show(tab: ArchiveTab, qtbot: QtBot) -> None:
    """Bring the tab to the front and wait until it has looked at its folder."""
    tab.view.show()
    settle(tab, qtbot)


def settle(tab: ArchiveTab, qtbot: QtBot) -> None:
    """Wait until nothing is asked any more."""
    qtbot.waitUntil(lambda: tab.library.idle, timeout=30_000)
