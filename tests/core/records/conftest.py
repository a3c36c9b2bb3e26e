"""Calibrations of the practicum's tables."""

from pathlib import Path

import pytest

from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from core.samples.run import Conditions

SPECIMENS = Path(__file__).parents[2] / "data" / "legacy"
STATED = Conditions(g_mps2=9.8106, u_g_mps2=1e-4, head_u_arcsec=5.0)


@pytest.fixture(scope="session")
def triad() -> Calibration:
    """Table 2.2: three accelerometers in eight positions."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405140930.txt").to_run()
    return calibrate(run, STATED)


@pytest.fixture(scope="session")
def single() -> Calibration:
    """Table 1.2: one accelerometer in four positions."""
    run = read_legacy(SPECIMENS / "OpticalDividingHead_202405131405.txt").to_run()
    return calibrate(run, STATED)
