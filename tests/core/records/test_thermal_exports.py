"""Calibrations over temperature as files."""

import json
from pathlib import Path

import numpy as np
import pytest

from core.errors import FitError
from core.plans.plan import load_plans
from core.procedures.calibration import Provenance
from core.procedures.thermal.cycle import ThermalCalibration, calibrate_thermal
from core.procedures.thermal.record import RecordResult, fit_record
from core.procedures.thermal.simulated import simulated_cycle
from core.records.thermal_exports import THERMAL_EXPORTS
from core.samples.run import Run

WHO = Provenance("thermal", "PW09", software="CalRig")


@pytest.fixture(scope="module")
def cycle() -> ThermalCalibration:
    run = simulated_cycle(load_plans()["thermal_8"], 1)
    return calibrate_thermal(run, run.conditions)


@pytest.fixture(scope="module")
def record() -> RecordResult:
    x = np.linspace(-20.0, 60.0, 400)
    rng = np.random.default_rng(5)
    unknown = np.full(400, np.nan)
    return fit_record(
        Run(
            "record",
            "gyro",
            "G1",
            ("g",),
            ("z",),
            "deg/s",
            (0.1 + 0.002 * x + 1e-3 * rng.standard_normal(400))[:, None],
            np.full((400, 1), np.nan),
            np.ones(400, dtype=np.int64),
            np.arange(400),
            ("",) * 400,
            unknown,
            unknown,
            x,
            np.arange(400.0),
        )
    )


@pytest.mark.parametrize("key", list(THERMAL_EXPORTS))
def test_every_format_of_a_cycle_is_written(tmp_path: Path, cycle: ThermalCalibration, key: str):
    path = tmp_path / f"unit{THERMAL_EXPORTS[key].suffix}"
    THERMAL_EXPORTS[key].write(cycle, WHO, path)
    assert path.stat().st_size > 300


def test_a_record_has_polynomials_and_no_c_header(tmp_path: Path, record: RecordResult):
    THERMAL_EXPORTS["json"].write(record, WHO, tmp_path / "r.json")
    read = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    assert read["provenance"]["device"] == "PW09"
    assert len(read["trends"][0]["coefficients"]) == record.trends[0].order + 1
    THERMAL_EXPORTS["csv"].write(record, WHO, tmp_path / "r.csv")
    assert (tmp_path / "r.csv").read_text(encoding="utf-8").count("\n") == 2 + record.trends[
        0
    ].order
    with pytest.raises(FitError, match="this orientation only"):
        THERMAL_EXPORTS["c"].write(record, WHO, tmp_path / "r.h")
