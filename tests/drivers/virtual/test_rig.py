"""The whole rig, through its bytes, against formulas written a second time."""

import math

import numpy as np
import pytest

from core.samples.block import SampleBlock
from drivers.decoders import make_decoder
from drivers.virtual.bench import Manner
from drivers.virtual.devices import Output
from drivers.virtual.faults import Faults
from drivers.virtual.rig import Rig, RigOptions, Unplugged

G = 9.8106
QUICK = Manner(head_dps=720.0, remount_s=0.1, table_dps2=1000.0)
SECONDS = 20


def hear(rig: Rig, seconds: float) -> dict[str, np.ndarray]:
    """Samples of the next seconds by role, decoded from the bytes."""
    decoder = make_decoder(rig.profile)
    events = decoder.feed(rig.produce(round(seconds * rig.rate_hz))) + decoder.flush()
    blocks = [event for event in events if isinstance(event, SampleBlock)]
    data = np.concatenate([block.data for block in blocks])
    return {channel.role: data[:, k] for k, channel in enumerate(decoder.channels)}


def naive_output(output: Output, a: np.ndarray, w: np.ndarray) -> float:
    """U = U0 + k . input + b . a, written out from (1.3), (2.1) and (3.3)."""
    own = "xyz".index(output.model.sensor.axis)
    felt = a if output.model.sensor.kind == "accelerometer" else w
    total = output.value("bias") + output.value("scale_factor") * felt[own]
    for other in {0, 1, 2} - {own}:
        total += output.value(f"cross_axis_{'xyz'[other]}") * felt[other]
    if output.model.sensor.kind == "gyro":
        for axis in range(3):
            total += output.value(f"g_sensitivity_{'xyz'[axis]}") * a[axis]
    return total


def naive_up(mount: str, degrees: float) -> np.ndarray:
    """Specific force by Tables 1.1 and 2.1, for any angle between their rows."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    along_x = {"X_from": np.array([0.0, -s, c]), "Y_from": np.array([s, 0.0, c])}
    return G * along_x[mount]


def naive_earth(mount: str, degrees: float) -> np.ndarray:
    """Rate of the Earth at Kyiv with the shaft pointing north, deg/s."""
    rate = 360.0 / 86164.0905
    north, up = rate * math.cos(math.radians(50.45)), rate * math.sin(math.radians(50.45))
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if mount == "X_from":
        return np.array([north, -s * up, c * up])
    # Y along the shaft, to the north; X points to the right of it, to the east, at angle zero.
    return np.array([s * up, north, c * up])


def expected_deviation(output: Output, seconds: float) -> float:
    """Standard deviation of a mean: white noise, flicker, walk over the test, rounding."""
    level = output.level
    white = level.density / math.sqrt(2.0 * seconds)
    return math.hypot(white, 2.0 * level.floor, level.walk * math.sqrt(400.0), 1e-9)


@pytest.mark.parametrize("name", ["clbacc", "pointer", "clbdus", "cvg25"])
def test_means_at_all_positions_are_those_of_a_naive_formula(name):
    rig = Rig(RigOptions(device=name, seed=11, manner=QUICK))
    scores = []
    for mount in ("X_from", "Y_from"):
        rig.remount(mount)
        for degrees in (0.0, 90.0, 180.0, 270.0, 15.0, 330.0):
            rig.turn(degrees)
            hear(rig, 3.0)
            heard = hear(rig, SECONDS)
            for output in rig.truth():
                expected = naive_output(
                    output, naive_up(mount, degrees), naive_earth(mount, degrees)
                )
                deviation = expected_deviation(output, SECONDS)
                scores.append((heard[output.role].mean() - expected) / deviation)
    assert np.max(np.abs(scores)) < 4.5
    assert 0.4 < np.std(scores) < 1.3


def test_rates_of_the_table_are_those_of_a_naive_formula():
    rig = Rig(RigOptions(device="clbdus", seed=2, manner=QUICK))
    for rate in (-100.0, -40.0, 20.0, 100.0):
        rig.spin(rate, "z")
        hear(rig, 2.0)
        heard = hear(rig, SECONDS)
        for output in rig.truth():
            w = np.array([0.0, 0.0, rate + naive_earth("X_from", 0.0)[2]])
            expected = naive_output(output, np.array([0.0, 0.0, G]), w)
            deviation = expected_deviation(output, SECONDS)
            assert heard[output.role].mean() == pytest.approx(expected, abs=4.5 * deviation + 0.01)


def test_a_further_effect_is_played():
    plain = Rig(RigOptions(seed=3, noise=0.0, manner=QUICK))
    shifted = Rig(RigOptions(seed=3, noise=0.0, manner=QUICK, effects={"adc.4/bias": (50.0,)}))
    one, other = hear(plain, 1.0), hear(shifted, 1.0)
    assert np.array_equal(other["adc.4"], one["adc.4"] + 50.0)
    assert np.array_equal(other["adc.5"], one["adc.5"])


def test_same_seed_same_bytes_however_they_are_asked_for():
    def walk(rig: Rig, cuts: tuple[int, ...]) -> bytes:
        data = b""
        rig.fail(Faults(drop=0.01, bit_error=1e-5))
        for count in cuts:
            data += rig.produce(count)
        rig.turn(30.0, after_s=0.5)
        return data + b"".join(rig.produce(count) for count in cuts)

    options = RigOptions(device="pointer", seed=4)
    whole = walk(Rig(options), (1000,))
    assert walk(Rig(options), (1, 9, 90, 400, 500)) == whole
    assert walk(Rig(RigOptions(device="pointer", seed=5)), (1000,)) != whole


def test_warming_up_is_smooth_within_a_block():
    rig = Rig(RigOptions(device="cvg25", cold=True, noise=0.0))
    temperature = hear(rig, 100.0)["temp"]
    steps = np.diff(temperature)
    assert np.all(steps >= 0.0)
    assert steps.max() < 1e-4
    assert temperature[-1] - temperature[0] == pytest.approx(
        9.0 * (1 - math.exp(-100 / 900)), rel=1e-2
    )


def test_orders_wait_for_their_time_and_the_state_tells():
    rig = Rig(RigOptions(manner=Manner(head_dps=90.0)))
    rig.turn(45.0, after_s=1.0)
    rig.remount("Y_from", after_s=4.0)
    rig.heat(50.0)
    rig.produce(190)
    assert (rig.state.head_target_deg, rig.state.moving) == (0.0, False)
    rig.produce(20)
    assert (rig.state.head_target_deg, rig.state.moving) == (45.0, True)
    rig.produce(390)
    assert (rig.state.head_deg, rig.state.moving) == (45.0, False)
    assert rig.state.mount == "X_from"
    rig.produce(300)
    assert rig.state.mount == "Y_from"
    assert 27.0 < rig.state.case_c < rig.state.chamber_c < 50.0
    assert rig.state.time_s == pytest.approx(4.5)
    with pytest.raises(ValueError, match="unknown mount"):
        rig.remount("sideways")
    with pytest.raises(ValueError, match="expected x, y or z"):
        rig.spin(10.0, "w")


def test_unplugged_rig_gives_nothing_until_it_is_plugged_in():
    rig = Rig(RigOptions())
    rig.produce(10)
    rig.unplug()
    assert not rig.state.plugged
    with pytest.raises(Unplugged):
        rig.produce(10)
    rig.plug_in()
    assert len(rig.produce(10)) == 510


def test_stuck_channel():
    rig = Rig(RigOptions())
    rig.fail(Faults(stuck=(2,)))
    heard = hear(rig, 2.0)
    assert np.ptp(heard["adc.3"]) == 0.0
    assert np.ptp(heard["adc.2"]) > 0.0


def test_stopped_unit_is_silent_while_time_goes_on():
    rig = Rig(RigOptions(device="pointer"))
    rig.receive(rig.profile.commands["stop"].data)
    assert rig.produce(100) == b""
    assert rig.state.time_s == pytest.approx(1.0)
    assert not rig.state.streaming


def test_one_connection():
    rig = Rig(RigOptions())
    assert rig.acquire()
    assert not rig.acquire()
    rig.release()
    assert rig.acquire()
    rig.release()
