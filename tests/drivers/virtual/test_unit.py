"""From what acts on the unit to its numbers."""

import numpy as np
import pytest

from core.model.stimulus import Stimulus
from core.samples.block import Channel
from drivers.virtual.devices import make_device
from drivers.virtual.unit import Unit

RATE = 100.0


def stimulus(a, w=(0.0, 0.0, 0.0), *, t=0.0, temperature=27.0, rows=1) -> Stimulus:
    full = {"t_s": t, "temperature_c": temperature, "north_x": 0.0, "north_y": 1.0, "north_z": 0.0}
    return Stimulus(
        a=np.tile(a, (rows, 1)).astype(float),
        w=np.tile(w, (rows, 1)).astype(float),
        da_dhead=np.zeros((rows, 3)),
        dw_drate=np.zeros((rows, 3)),
        columns={name: np.full(rows, float(value)) for name, value in full.items()},
    )


def unit(name: str, *channels: Channel, noise: float = 0.0, cold: bool = False) -> Unit:
    rng = np.random.default_rng(1)
    return Unit(make_device(name, 1), channels, RATE, rng, noise=noise, cold=cold)


def test_channels_are_filled_by_role_or_by_name_in_any_order():
    one = unit(
        "cvg25",
        Channel("GyroOut_RAW", "V"),
        Channel("AntiNodePeriod", "us"),
        Channel("what", "V"),
        Channel("T", "degC", "temp"),
        Channel("out", "V", "rate.z"),
    )
    data = one.sends(stimulus((0, 0, 9.8), (0, 0, 10.0), temperature=37.0), 3)
    assert data.shape == (3, 5)
    assert np.array_equal(data[:, 0], data[:, 4])
    assert data[0, 4] == pytest.approx(0.24, rel=0.02)
    assert data[0, 1] == pytest.approx(23.733621597 + 6.3e-3)
    assert not data[:, 2].any()
    assert data[0, 3] == pytest.approx(37.0)


def test_codes_are_whole_and_clipped():
    one = unit("clbacc", Channel("adc_1", "code", "adc.1"), noise=1.0)
    data = one.sends(stimulus((0, 0, 9.81)), 500)
    assert np.array_equal(data, np.rint(data))
    assert data.std() > 5.0
    assert one.sends(stimulus((0, 0, 90.0)), 500)[-1] == 32767.0
    assert one.sends(stimulus((0, 0, -90.0)), 500)[-1] == -32767.0


def test_bandwidth_smooths_a_step_and_then_one_row_is_enough():
    one = unit("clbacc", Channel("adc_1", "V", "adc.1"))
    before = one.sends(stimulus((0, 0, 0.0)), 5)
    assert np.ptp(before) == 0.0
    step = one.sends(stimulus((0, 0, 1.0)), 100)[:, 0] - before[0, 0]
    # 20 Hz sampled at 100 Hz.
    pole = np.exp(-2 * np.pi * 20.0 / 100.0)
    assert np.allclose(step / 1328.0691, 1 - pole ** np.arange(1, 101), atol=1e-9)


def test_cold_start_drifts_until_the_unit_is_warm():
    channels = (Channel("adc_1", "V", "adc.1"), Channel("temp_1", "V", "temp.adc.1"))
    device = make_device("clbacc", 1)
    cold = unit("clbacc", *channels, cold=True)
    start = cold.sends(stimulus((0, 0, 0), t=0.0), 1)[0]
    later = cold.sends(stimulus((0, 0, 0), t=device.heating_tau_s), 1)[0]
    warm = unit("clbacc", *channels).sends(stimulus((0, 0, 0)), 1)[0]
    missing = device.heating_c * np.array([-device.outputs[0].warm_up, -12.5])
    assert np.allclose(start - warm, missing)
    assert np.allclose(later - warm, missing / np.e)


def test_attitude_unit_tells_its_angles_and_the_field():
    names = ("mag.x", "mag.y", "mag.z", "angle.heading", "angle.pitch", "angle.roll")
    one = unit("pointer", *(Channel(name, "nT", name) for name in names))
    pitch = np.radians(30.0)
    up = 9.81 * np.array([0.0, np.sin(pitch), np.cos(pitch)])
    acting = stimulus(up)
    acting.columns["north_y"][:], acting.columns["north_z"][:] = np.cos(pitch), -np.sin(pitch)
    data = one.sends(acting, 1)[0]
    assert np.allclose(data[3:], [0.4, 30.02, -0.05], atol=1e-9)
    hard_iron = 0.1 * np.array([310.0, -140.0, 220.0])
    level, down = 2000.0, 4550.0
    field = [
        0.0,
        level * np.cos(pitch) - down * np.sin(pitch),
        -level * np.sin(pitch) - down * np.cos(pitch),
    ]
    assert np.allclose(data[:3] - hard_iron, field, atol=1e-6)
