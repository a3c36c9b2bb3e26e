"""The source's table: errors of roll and pitch before and after compensation."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.dividing_head import calibrate
from core.procedures.thermal.cycle import calibrate_thermal
from core.procedures.thermal.tilt import tilt_errors, tilt_left_out
from core.samples.run import Conditions

CASE = Conditions(g_mps2=9.8106)


def test_compensation_takes_the_errors_away(make_chamber):
    run = make_chamber(0.5)
    at_27 = calibrate(run.rows(range(8)), CASE).triad()
    over = calibrate_thermal(run, CASE)
    hot = make_chamber(0.5, seed=9, temperatures=(69.0,))
    before, after = (tilt_errors(hot, how, CASE) for how in (at_27, over))
    assert before.worst_deg > 0.2
    assert after.worst_deg < 0.02
    assert np.nanmax(np.abs(after.pitch_error_deg / after.u_pitch_deg)) < 4.0
    assert before.temperature_c == pytest.approx(np.full(8, 69.0), abs=0.5)


def test_set_angles_are_those_of_the_positions(make_chamber):
    run = make_chamber(1e-6, temperatures=(27.0,))
    table = tilt_errors(run, calibrate(run, CASE).triad(), CASE)
    # About X the head lowers Y; with Y vertical there is no roll.
    assert table.pitch_deg[:4] == pytest.approx([0.0, -90.0, 0.0, 90.0])
    assert np.isnan(table.roll_deg[[1, 3]]).all()
    assert table.roll_deg[[0, 4, 5, 7]] == pytest.approx([0.0, 0.0, -90.0, 90.0])
    # At 180 degrees an error crosses the end of the scale.
    assert abs(table.roll_error_deg[2]) < 5e-3


def test_a_temperature_that_was_not_measured_is_refused(make_chamber):
    over = calibrate_thermal(make_chamber(), CASE)
    hotter = replace(make_chamber(temperatures=(27.0,)), temperature_c=np.full(8, 95.0))
    with pytest.raises(FitError, match="leaves the measured"):
        tilt_errors(hotter, over, CASE)


def test_a_temperature_left_out_is_corrected_by_the_others(make_chamber):
    run, case = make_chamber(), Conditions(g_mps2=9.8106)
    found = calibrate_thermal(run, case)
    errors, unseen = tilt_left_out(run, found, case)
    assert errors.temperature_c.tolist() == run.temperature_c.tolist()
    outermost = (run.temperature_c < -35.0) | (run.temperature_c > 65.0)
    assert unseen.tolist() == (~outermost).tolist()
    within = tilt_errors(run, found, case)
    assert errors.pitch_error_deg[outermost] == pytest.approx(within.pitch_error_deg[outermost])
    assert not np.allclose(errors.pitch_error_deg[unseen], within.pitch_error_deg[unseen])
    assert errors.worst_deg < 0.1
