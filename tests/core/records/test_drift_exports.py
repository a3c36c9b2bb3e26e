"""Drift tables as files."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult, compensate
from core.procedures.drift.curves import curves_of
from core.procedures.drift.simulated import simulated_turn_ons
from core.records.drift_exports import DRIFT_EXPORTS

WHO = Provenance("drift", "GIB-7", software="CalRig")


@pytest.fixture(scope="module")
def result() -> DriftResult:
    return compensate(curves_of(simulated_turn_ons(1, rate=20.0, count=2)), "deg/s", knots=5)


@pytest.mark.parametrize("key", list(DRIFT_EXPORTS))
def test_every_format_is_written(tmp_path: Path, result: DriftResult, key: str):
    path = tmp_path / f"gyro{DRIFT_EXPORTS[key].suffix}"
    DRIFT_EXPORTS[key].write(result, WHO, path)
    assert path.stat().st_size > 300


def test_the_files_hold_the_table(tmp_path: Path, result: DriftResult):
    for key, name in (("json", "a.json"), ("csv", "a.csv"), ("c", "Gyro X.h")):
        DRIFT_EXPORTS[key].write(result, WHO, tmp_path / name)
    read = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert read["values"] == result.table.values.tolist()
    with (tmp_path / "a.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    m = len(result.table.temperatures_c)
    values = np.array([row[1 : 1 + m] for row in rows[1:]], dtype=float)
    assert values.T.tolist() == result.table.values.tolist()
    assert len(rows[0]) == 1 + 2 * m
    assert "gyro_x_correction(" in (tmp_path / "Gyro X.h").read_text(encoding="utf-8")
