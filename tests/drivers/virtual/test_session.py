"""Sessions on the rig without a window: whole, thermal, repeated, and what stops one."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.errors import StorageError
from core.plans.plan import load_plans
from core.records.open import read_any
from core.samples.run import Conditions
from drivers.series import read_series
from drivers.virtual.session import RAW_NAME, Order, simulate_record, simulate_session

PLANS = load_plans()
STATED = Conditions(g_mps2=9.8106, head_u_arcsec=5.0)


def an_order(device: str, plan: str, name: str, **changes: object) -> Order:
    quick = replace(PLANS[plan], accumulation_s=1.0, settle_s=0.5)
    url = f"sim://{device}?speed=max&name={name}"
    return replace(Order(url, quick, "accelerometer", STATED), **changes)


def test_a_session_is_finished_and_reads_back(tmp_path: Path) -> None:
    folder = tmp_path / "s"
    run = simulate_session(an_order("pointer", "pointer_8", "whole"), folder)
    assert run.mount == tuple(step.mount for step in PLANS["pointer_8"].steps)
    again = read_any(folder)
    np.testing.assert_array_equal(again.y, run.y)
    assert again.conditions.head_u_arcsec == 5.0
    assert (folder / RAW_NAME).stat().st_size > 10000
    assert list(folder.glob("OpticalDividingHead_*.txt"))
    assert list(folder.glob("*.run.csv"))


def test_an_assembly_is_walked_at_every_temperature(tmp_path: Path) -> None:
    order = an_order("clbacc", "accelerometer_4", "warm")
    order = replace(order, plan=replace(order.plan, temperatures_c=(27.0, -10.0)))
    run = simulate_session(order, tmp_path / "s")
    assert len(run) == 8
    assert len(run.channels) == 9
    np.testing.assert_array_equal(run.extra["set_temperature_c"], [27.0] * 4 + [-10.0] * 4)


def test_replicates_walk_the_plan_again(tmp_path: Path) -> None:
    order = an_order("pointer", "accelerometer_4", "twice", replicates=2)
    run = simulate_session(order, tmp_path / "s")
    assert run.run.tolist() == [1] * 4 + [2] * 4


def test_a_folder_is_never_measured_into_twice(tmp_path: Path) -> None:
    simulate_session(an_order("pointer", "accelerometer_4", "once"), tmp_path / "s")
    with pytest.raises(StorageError, match="already holds a session"):
        simulate_session(an_order("pointer", "accelerometer_4", "again"), tmp_path / "s")


def test_gyros_at_rest_are_started_by_hand_in_every_position(tmp_path: Path) -> None:
    order = replace(an_order("clbdus", "g_sensitivity_4", "gyros"), sensor="gyro")
    run = simulate_session(order, tmp_path / "s")
    assert run.test == "static_positions"
    assert run.head_deg.tolist() == [0.0, 90.0, 180.0, 270.0]


def test_a_unit_at_rest_is_recorded_for_as_long_as_asked(tmp_path: Path) -> None:
    path = tmp_path / RAW_NAME
    simulate_record("sim://cvg25?speed=max&block=5&name=record", 30.0, path)
    series = read_series(path)
    assert 29.0 <= series.n / series.rate < 60.0
