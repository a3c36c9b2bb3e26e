"""Estimates beside the truth."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.plans.plan import load_plans
from core.procedures.dividing_head import calibrate
from core.procedures.g_sensitivity import fit_g_sensitivity
from core.procedures.rate_table import calibrate_rate_table
from core.samples.run import Conditions
from drivers.virtual.address import rig_of
from drivers.virtual.session import Order, simulate_session
from drivers.virtual.truth import compare, compare_rates, report

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


def test_scale_factors_of_the_table_stand_beside_their_truth(tmp_path: Path) -> None:
    plan = load_plans()["rate_table_100"]
    plan = replace(plan, steps=plan.steps[::5], accumulation_s=1.0, settle_s=0.5)
    url = "sim://clbdus?speed=max&name=rates"
    run = simulate_session(Order(url, plan, "gyro", STATED), tmp_path / "s")
    rows = compare_rates(calibrate_rate_table(run, STATED), rig_of(url))
    assert [row.symbol for row in rows] == ["k_z"] * 9
    assert sum(row.covered for row in rows) >= 6
    assert all(abs(row.estimate / row.truth - 1.0) < 0.01 for row in rows)


def test_g_sensitivities_stand_beside_their_truth(tmp_path: Path) -> None:
    plan = replace(load_plans()["g_sensitivity_4"], accumulation_s=1.0, settle_s=0.5)
    url = "sim://clbdus?speed=max&name=at_rest"
    run = simulate_session(Order(url, plan, "gyro", STATED), tmp_path / "s")
    rows = compare(fit_g_sensitivity(run, STATED).calibration(), rig_of(url))
    assert {row.symbol for row in rows} == {"U0", "b_zy", "b_zz"}
    assert sum(row.covered for row in rows) >= 20
