"""The tab without the rest of the window, and records with known noise."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from core.arrays import frozen
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of
from core.records.cvgcom_writer import write_cvgcom
from drivers.profile import load_profiles
from gui.allan.tab import AllanTab
from gui.devices.connection import Connection
from gui.jobs import Jobs
from gui.messages import Messages
from gui.services import Services
from gui.settings import Settings
from tests.core.records.noise_records import gyro_noise

TRUTH = {"N": 0.02, "B": 0.0125, "K": 3e-4}
SCALE = 0.03


def cvg_record(folder: Path, device: str, seed: int, slope: float = 0.0) -> Path:
    """Write fifty minutes of a simulated CVG at 20 Hz as CVGCom did."""
    n, rate = 60_000, 20.0
    temperature = 25.0 + 3.0 * np.sin(np.arange(n) / n * 3.0)
    values = gyro_noise(n, rate, (TRUTH["N"], TRUTH["B"], TRUTH["K"]), seed)
    data = np.column_stack([SCALE * (values + slope * temperature), temperature])
    channels = (channel_of("GyroOut"), channel_of("Temperature"))
    path = folder / f"{device}.exp(001)_s_pr1.txt"
    head = CvgcomHead(1.0 / rate, SCALE, channels)
    write_cvgcom(CvgcomFile(path, head, frozen(data), None, ()), path)
    return path


@pytest.fixture(scope="session")
def records(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Two CVGs; the second depends on its temperature."""
    folder = tmp_path_factory.mktemp("cvg")
    return [cvg_record(folder, "25-143", 1), cvg_record(folder, "25-144", 2, 0.05)]


@pytest.fixture
def tab(qtbot: QtBot, tmp_path: Path) -> Iterator[AllanTab]:
    """The tab with its plot, on the screen."""
    jobs, messages = Jobs(), Messages()
    connection = Connection(load_profiles, lambda: tmp_path, messages)
    settings = Settings(tmp_path / "settings.json")
    services = Services(
        connection, jobs, messages, settings, load_profiles, lambda: tmp_path, lambda _: None
    )
    made = AllanTab(services)
    qtbot.addWidget(made.view)
    made.view.resize(1280, 700)
    made.view.show()
    made.after_paint()
    yield made
    made.close()
    connection.close()
    jobs.close()


def idle(tab: AllanTab) -> bool:
    """Whether no work waits or runs."""
    return not any(tab.library.busy(entry.key) for entry in tab.library.entries)
