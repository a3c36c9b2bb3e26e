"""Records of any kind for the thermal and the drift procedure."""

import math

import numpy as np
import pytest

from core.errors import FitError, FormatError
from core.records.series import Series
from core.records.series_run import record_run, sampled_run, turn_on_of, with_first
from core.samples.block import Channel

N = 200
GYRO = (Channel("gx", "deg/s", "rate.x"), Channel("gy", "deg/s", "rate.y"))
ACC = (Channel("az", "m/s^2", "acc.z"),)
CHIP = (Channel("T", "degC", "temp"),)
NAMELESS = (Channel("a", "code"), Channel("imu.temperature", "code"))


def series(channels: tuple[Channel, ...], **how) -> Series:
    columns = tuple(np.arange(N, dtype=float) + 1000.0 * place for place in range(len(channels)))
    return Series("r.csv", "CVG", channels, columns, N, **{"rate": 10.0, **how})


def test_rates_come_before_forces_and_the_temperature_is_found():
    run = record_run(series((*ACC, *CHIP, *GYRO)))
    assert (run.test, run.sensor, run.unit) == ("record", "gyro", "deg/s")
    assert run.channels == ("gx", "gy")
    assert run.axes == ("x", "y")
    assert run.temperature_c[0] == 1000.0
    assert run.t_s[:3].tolist() == [0.0, 0.1, 0.2]
    forces = record_run(series((*ACC, *CHIP)))
    assert (forces.sensor, forces.channels) == ("accelerometer", ("az",))


def test_outputs_may_be_named():
    run = record_run(series((*GYRO, *ACC, *CHIP)), ("az",))
    assert (run.sensor, run.unit) == ("accelerometer", "m/s^2")
    run = record_run(series(NAMELESS), ("1",))
    assert run.temperature_c[0] == 1000.0
    assert record_run(series(NAMELESS), ("a",), sensor="accelerometer").sensor == "accelerometer"
    with pytest.raises(FitError, match=r"outputs in deg/s, m/s\^2"):
        record_run(series((*GYRO, *ACC, *CHIP)), ("gx", "az"))


def test_what_the_names_do_not_tell_is_asked_for():
    with pytest.raises(FitError, match=r"which channels are the outputs\? There are: a, imu"):
        record_run(series(NAMELESS))
    with pytest.raises(FitError, match=r"which channel is the temperature\? There are: gx, gy"):
        record_run(series(GYRO))
    with pytest.raises(FormatError, match="no channel 'gz'"):
        record_run(series((*GYRO, *CHIP)), ("gz",))


def test_lost_rows_are_left_out_and_counted():
    columns = [np.arange(N, dtype=float), np.full(N, 20.0)]
    columns[0][5:8] = np.nan
    gaps = Series("r.csv", "CVG", (GYRO[0], *CHIP), columns, N, 10.0)
    run = record_run(gaps)
    assert len(run) == N - 3
    assert run.t_s[5] == pytest.approx(0.8)
    assert [note.subject for note in run.notes] == ["lost"]


def test_times_come_from_stamps_or_from_the_counter():
    stamped = record_run(series((*GYRO, *CHIP), rate=0.0, time=np.arange(N) * 0.5 + 7.0))
    assert stamped.t_s[:2].tolist() == [0.0, 0.5]
    counted = record_run(series((*GYRO, *CHIP), index=np.arange(N) * 2))
    assert counted.t_s[1] == pytest.approx(0.2)
    assert np.isnan(record_run(series((*GYRO, *CHIP), rate=0.0)).t_s).all()


def test_a_turn_on_is_one_channel_with_the_chip():
    one, unit = turn_on_of(series((*GYRO, *CHIP)), ambient_c=-20.0)
    assert (one.label, one.ambient_c, one.rate, unit) == ("r.csv", -20.0, 10.0, "deg/s")
    assert one.temperature_c[0] == 2000.0
    other, _ = turn_on_of(series((*GYRO, *CHIP)), "gy", scale_factor=4.0)
    assert other.y[0] == 250.0
    assert math.isnan(other.ambient_c)
    bare, _ = turn_on_of(series(GYRO), ambient_c=20.0)
    assert np.isnan(bare.temperature_c).all()


def test_gaps_are_refused():
    index = np.arange(N)
    index[50:] += 3
    with pytest.raises(FitError, match="samples were lost"):
        turn_on_of(series((*GYRO, *CHIP), index=index))


def test_one_output_comes_with_all_other_channels_and_what_is_lost_stays_lost():
    one = series((*GYRO, *CHIP, *ACC))
    one.columns[0][5] = np.nan
    run = sampled_run(one)
    assert (run.test, run.sensor, run.channels) == ("record", "gyro", ("gx",))
    assert set(run.extra) == {"gy", "az"}
    assert len(run) == N
    assert np.isnan(run.y[5, 0])
    assert run.temperature_c[0] == 2000.0
    assert sampled_run(one, "az").sensor == "accelerometer"


def test_a_copy_of_the_output_is_no_cause_of_it():
    rng = np.random.default_rng(3)
    rate, warm = rng.standard_normal(N), 25.0 + 0.01 * rng.standard_normal(N)
    columns = (rate, 0.5 + 2.0 * rate, rng.standard_normal(N), warm)
    channels = (Channel("out", "V", "rate.z"), Channel("raw", "V"), Channel("drive", "V"), *CHIP)
    run = sampled_run(Series("r.csv", "CVG", channels, columns, N, rate=10.0))
    assert set(run.extra) == {"drive"}
    assert np.array_equal(run.temperature_c, warm)


def test_an_output_of_a_run_can_be_brought_to_the_front():
    run = record_run(series((*GYRO, *CHIP)))
    for name in ("gy", "y", "2"):
        first = with_first(run, name)
        assert first.channels == ("gy", "gx")
        assert np.array_equal(first.y[:, 0], run.y[:, 1])
    with pytest.raises(FitError, match="there is no output"):
        with_first(run, "q")
