"""Twelve-byte CVG packets: stored frames, parameters in turn, several gyros."""

import math

import numpy as np
import pytest

from drivers.checksums import CRC_PRESETS, Crc
from drivers.profile import Profile, parse_profile
from drivers.protocols.cvg12 import Cvg12Decoder
from tests.drivers.streams import Outcome, bytewise, decode, same, stored

FRAMES = stored("cvg_innalabs")
NAMES = ("GyroOut", "Temperature", "AntinodePeriod", "ExcitationAmpl")


def profile(gyro: int = 0, controller: int = 0) -> Profile:
    text = f"""
schema = 1
[device]
name = "C"
kind = "gyro"
[port]
baud = [115200]
[protocol]
name = "cvgx12"
gyro = {gyro}
controller = {controller}
nominal_hz = 600
"""
    return parse_profile(text, "c")


def packet(gyro: int, second: int, one: float, two: float) -> bytes:
    body = bytes((gyro, second << 4)) + np.array([one, two], dtype="<f4").tobytes()
    row = np.frombuffer(body, dtype=np.uint8).reshape(1, -1)
    return b"\xaa" + body + bytes((int(Crc(CRC_PRESETS["crc-8/maxim"])(row)[0]),))


def run(data: bytes, gyro: int = 0, controller: int = 0) -> Outcome:
    whole = decode(Cvg12Decoder(profile(gyro, controller)), [data])
    same(decode(Cvg12Decoder(profile(gyro, controller)), bytewise(data)), whole)
    return whole


@pytest.mark.parametrize("name", ["cvgx12_0", "cvgx12_1", "cvgx12_2"])
def test_stored_packets(name: str):
    expected = FRAMES[name]["expected"]
    row = run(FRAMES[name]["bytes"], expected["gyro"]).row()
    assert {name: value for name, value in row.items() if not math.isnan(value)} == {
        NAMES[expected["param1"]]: expected["value1"],
        NAMES[expected["param2"]]: expected["value2"],
    }


def test_a_slow_parameter_keeps_its_value_until_its_next_turn():
    packets = [packet(0, 1 + n % 3, n / 4, 10.0 * n) for n in range(9)]
    got = run(b"".join(packets))
    assert got.names[:4] == NAMES
    assert np.isnan(got.data[:, 4:]).all()
    assert got.column("GyroOut").tolist() == [n / 4 for n in range(9)]
    assert got.column("Temperature").tolist() == [0, 0, 0, 30, 30, 30, 60, 60, 60]
    assert np.isnan(got.column("ExcitationAmpl")[:2]).all()
    assert got.column("ExcitationAmpl")[2:].tolist() == [20, 20, 20, 50, 50, 50, 80]
    assert got.index.tolist() == list(range(9))


def test_only_the_chosen_gyro_is_measured():
    stream = packet(0, 1, 1, 20) + packet(0x21, 1, 5, 30) + packet(0, 2, 2, 21)
    got = run(stream)
    assert got.column("GyroOut").tolist() == [1.0, 2.0]
    assert [kind for kind, _, _ in got.messages] == ["gyro 1 of controller 2"]
    assert run(stream, 1, 2).column("GyroOut").tolist() == [5.0]
    assert len(run(stream, 1, 0).data) == 0


def test_one_parameter_twice_or_an_unknown_one_is_no_column():
    got = run(packet(0, 0, 1.5, 2.5) + packet(0, 15, 3.5, 2.5))
    assert got.column("GyroOut").tolist() == [1.5, 3.5]
    assert np.isnan(got.data[:, 1:]).all()


def test_a_damaged_packet_is_lost():
    packets = [packet(0, 1, n, 20) for n in range(12)]
    packets[5] = packets[5][:6] + b"\x99" + packets[5][7:]
    got = run(b"".join(packets))
    assert got.lost == [(1, 6)]
    assert got.bad_checksum == 1
    assert got.garbage == 12
