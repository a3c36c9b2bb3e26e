"""Live codes in physical units: the triad by Q, single sensors by their scale factor."""

from dataclasses import replace

import numpy as np
import pytest

from core.procedures.dividing_head import calibrate
from core.procedures.physical import physical_of
from core.samples.block import Channel
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

G = 9.8106
K = np.array([[-1335.0, -13.0, -73.0], [36.0, -1339.0, 12.0], [1.0, 14.0, 1335.0]])
U0 = np.array([-379.0, -195.0, -230.0])
ORDER = [2, 0, 1]
CHANNELS = (
    Channel("n", "", "counter"),
    Channel("az", "code", "acc.z"),
    Channel("ax", "code", "acc.x"),
    Channel("ay", "code", "acc.y"),
)


def triad() -> Run:
    angles = np.tile([0.0, 90.0, 180.0, 270.0], 2)
    c, s = np.cos(np.radians(angles)), np.sin(np.radians(angles))
    zero = np.zeros(8)
    about_x = np.column_stack([zero, -s, c])[:4]
    about_y = np.column_stack([s, zero, c])[4:]
    y = U0 + G * np.vstack([about_x, about_y]) @ K.T
    return plain_run(
        channels=tuple(f"acc_{'xyz'[i]}" for i in ORDER),
        axes=tuple("xyz"[i] for i in ORDER),
        y=y[:, ORDER],
        y_se=np.full((8, 3), 0.1),
        mount=("X_from",) * 4 + ("Y_from",) * 4,
        head_deg=angles,
    )


def test_codes_of_a_triad_become_specific_force_whatever_their_order():
    found = physical_of(calibrate(triad(), Conditions(g_mps2=G)), CHANNELS)
    assert found is not None
    assert found.unit == "m/s^2"
    force = np.array([[1.0, -2.0, 9.3], [0.0, 0.5, -9.8]])
    codes = U0 + force @ K.T
    data = np.column_stack([np.zeros(2), codes[:, ORDER]])
    assert found.of(data) == pytest.approx(force[:, ORDER], abs=1e-9)


def test_a_single_sensor_of_an_assembly():
    run = triad()
    one = replace(run, channels=("acc_3",), axes=("z",), y=run.y[:, :1], y_se=run.y_se[:, :1])
    channels = (Channel("u3", "code", "adc.3"),)
    found = physical_of(calibrate(one, Conditions(g_mps2=G)), channels)
    assert found is not None
    assert found.of(np.array([[U0[2] + 1335.0 * 9.0]])) == pytest.approx(9.0, abs=0.01)


def test_another_unit_or_other_channels_do_not_fit():
    made = calibrate(triad(), Conditions(g_mps2=G))
    assert physical_of(made, CHANNELS[:3]) is None
    volts = tuple(replace(channel, unit="V") for channel in CHANNELS)
    assert physical_of(made, volts) is None
