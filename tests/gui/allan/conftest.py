"""The tab without the rest of the window, and records with known noise."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from core.arrays import frozen
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of
from core.records.cvgcom_writer import write_cvgcom
from gui.allan.tab import AllanTab
from gui.services import Services
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
def tab(services: Services, show_tab: Callable[[AllanTab], None]) -> AllanTab:
    """The tab with its plot, on the screen."""
    made = AllanTab(services)
    show_tab(made)
    return made


def idle(tab: AllanTab) -> bool:
    """Whether no work waits or runs."""
    return not any(tab.library.busy(entry.key) for entry in tab.library.entries)
