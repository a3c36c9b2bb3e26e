"""Estimates beside the truth."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.plans.plan import load_plans
from core.procedures.dividing_head import calibrate
from core.samples.run import Conditions
from drivers.virtual.address import rig_of
from drivers.virtual.session import Order, simulate_session
from drivers.virtual.truth import compare, report

STATED = Conditions(g_mps2=9.8106, repeatability=np.nan)


def test_every_parameter_stands_beside_its_truth(tmp_path: Path) -> None:
    plan = replace(load_plans()["accelerometer_8"], accumulation_s=2.0, settle_s=0.5)
    url = "sim://clbacc?speed=max&name=truth"
    run = simulate_session(Order(url, plan, "accelerometer", STATED), tmp_path / "s")
    calibration = calibrate(run, STATED)
    rows = compare(calibration, rig_of(url))
    assert len(rows) == 9 * 4
    assert {row.channel for row in rows} == set(calibration.channels)
    # A wrong pairing of channels or parameters would be outside by far.
    assert sum(row.covered for row in rows) >= 27
    shifted = replace(rows[0], covered=False)
    lines = report((shifted, *rows[1:]))
    assert lines[0].endswith("outside")
    assert lines[-1].endswith("of 36 intervals (95 %) hold the truth")
