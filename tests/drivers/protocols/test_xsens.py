"""Xsens messages: stored packets in all precisions, replies, items that come and go."""

from datetime import UTC, datetime
from typing import Any

import numpy as np
import pytest

from core.units import DEG_PER_RAD
from drivers.checksums import Checksum
from drivers.profile import load_profiles
from drivers.protocols.xsens import CHECKSUM, XsensDecoder
from tests.drivers.streams import Outcome, bytewise, decode, randomly, same, stored

FRAMES = stored("xsens_mti")
PROFILES = load_profiles()
SUM = Checksum(CHECKSUM)
RECORDED = [name for name in FRAMES if name.startswith("rec")]
CONFIGURATIONS = [
    name for name in FRAMES if name.startswith("outputconfig_") and name[-1].isdigit()
]
MESSAGES = [
    name for name in FRAMES if name not in [*RECORDED, *CONFIGURATIONS, "mti630", "mtdata2_empty"]
]
NAMES: dict[str, tuple[tuple[str, ...], float]] = {
    "Acceleration": (("acc_x", "acc_y", "acc_z"), 1.0),
    "FreeAcceleration": (("free_acc_x", "free_acc_y", "free_acc_z"), 1.0),
    "DeltaV": (("delta_v_x", "delta_v_y", "delta_v_z"), 1.0),
    "RateOfTurn": (("gyro_x", "gyro_y", "gyro_z"), DEG_PER_RAD),
    "DeltaQ": (("dq0", "dq1", "dq2", "dq3"), 1.0),
    "Quaternion": (("q0", "q1", "q2", "q3"), 1.0),
    "EulerAngles": (("roll", "pitch", "yaw"), 1.0),
    "MagneticField": (("mag_x", "mag_y", "mag_z"), 1.0),
    "VelocityXYZ": (("velocity_x", "velocity_y", "velocity_z"), 1.0),
    "LatLon": (("latitude", "longitude"), 1.0),
    "AltitudeEllipsoid": (("altitude",), 1.0),
    "Temperature": (("temp",), 1.0),
    "BaroPressure": (("pressure",), 1.0),
    "PacketCounter": (("packet_counter",), 1.0),
    "SampleTimeFine": (("sample_time",), 1e-4),
    "SampleTimeCoarse": (("sample_time_coarse",), 1.0),
}
"""Columns of each stored item; matrices and times are compared apart."""


def mti() -> XsensDecoder:
    return XsensDecoder(PROFILES["xsens_mti"])


def run(data: bytes) -> Outcome:
    whole = decode(mti(), [data])
    same(decode(mti(), bytewise(data)), whole)
    return whole


def message(id_: int, data: bytes) -> bytes:
    """A message with its checksum, extended where it is long."""
    size = bytes((len(data),)) if len(data) < 255 else b"\xff" + len(data).to_bytes(2, "big")
    whole = b"\xfa\xff" + bytes((id_,)) + size + data + b"\0"
    row = np.frombuffer(whole, dtype=np.uint8).reshape(1, -1).copy()
    SUM.stamp(row)
    return row.tobytes()


def item(id_: int, data: bytes) -> bytes:
    return id_.to_bytes(2, "big") + bytes((len(data),)) + data


def packet(time: int, *items: bytes) -> bytes:
    return message(0x36, item(0x1060, time.to_bytes(4, "big")) + b"".join(items))


ACC = item(0x4020, np.array([1, 2, 3], dtype=">f4").tobytes())
MAG = item(0xC020, np.array([4, 5, 6], dtype=">f4").tobytes())


def numbers(expected: Any) -> list[float]:
    return (
        [float(v) for v in expected.values()] if isinstance(expected, dict) else [float(expected)]
    )


@pytest.mark.parametrize("name", RECORDED)
def test_recorded_packets(name: str):
    expected = FRAMES[name]["expected"]
    got = run(FRAMES[name]["bytes"])
    assert (got.garbage, got.bad_checksum) == (0, 0)
    satellites = next((v for k, v in expected.items() if k.startswith("GNSS")), None)
    if satellites is not None:
        ((kind, _, fields),) = got.messages
        assert kind == "satellites"
        assert [float(value) for value in fields.values()] == numbers(satellites)
        return
    row = got.row()
    compared = 0
    for key, value in expected.items():
        kind = key.partition("(")[0]
        if kind in NAMES:
            columns, scale = NAMES[kind]
            wanted = [number * scale for number in numbers(value)]
            assert [row[column] for column in columns] == pytest.approx(wanted, rel=1e-14), key
        elif kind == "RotationMatrix":
            assert [row[f"matrix_{letter}"] for letter in "abcdefghi"] == numbers(value)
        elif kind == "UTCTime":
            moment = datetime.fromisoformat(value.replace("Z", "+00:00"))
            assert row["utc"] == pytest.approx(moment.timestamp(), abs=1e-5)
        else:
            assert kind in ("StatusByte", "StatusWord")
            assert row["status"] == int(value, 2)
        compared += 1
    assert compared == len(expected) >= 5


def test_packet_of_another_model():
    expected = FRAMES["mti630"]["expected"]
    row = run(FRAMES["mti630"]["bytes"]).row()
    assert [row[f"q{n}"] for n in range(4)] == expected["Quaternion"]
    assert row["packet_counter"] == expected["PacketCounter"]
    assert row["sample_time"] == pytest.approx(expected["SampleTimeFine"] * 1e-4, rel=1e-14)
    assert row["status"] == expected["StatusWord"]


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_recorded_output_configurations(name: str):
    got = run(message(0xC1, FRAMES[name]["bytes"]))
    wanted = " ".join(f"{e['id'][2:]}@{e['freq_hz']}" for e in FRAMES[name]["expected"])
    assert got.messages[0][2]["outputs"] == wanted


@pytest.mark.parametrize("name", MESSAGES)
def test_stored_messages_are_taken_whole(name: str):
    got = run(FRAMES[name]["bytes"])
    ((_, payload, _),) = got.messages
    assert payload == FRAMES[name]["bytes"]
    assert got.garbage == 0


def test_replies_are_read():
    def said(name: str) -> tuple[str, dict[str, str]]:
        kind, _, fields = run(FRAMES[name]["bytes"]).messages[0]
        return kind, fields

    assert said("firmware_rev_reply")[1]["firmware"] == "1.2.0"
    assert said("outputconfig_ack")[1]["outputs"] == "10A0@1"
    assert said("goto_config_ack") == ("reply", {"message": "0x31"})
    assert said("req_baudrate")[0] == "unknown 0x18"
    got = run(message(0x01, bytes.fromhex("077045D2")) + message(0x1D, b"MTi-630-8A1G6   "))
    assert [fields for _, _, fields in got.messages] == [
        {"serial": "077045D2", "message": "0x01"},
        {"model": "MTi-630-8A1G6", "message": "0x1D"},
    ]
    assert run(message(0x42, b"\x04")).messages[0][2]["error"] == "04"


def test_an_empty_packet_is_a_message():
    assert [kind for kind, _, _ in run(FRAMES["mtdata2_empty"]["bytes"]).messages] == ["packet"]


def test_the_whole_record_is_one_stream():
    """Packets of 100 Hz, satellites between them, angles that join from the second packet on."""
    stream = b"".join(FRAMES[name]["bytes"] for name in ("rec1_0", "rec1_1", "rec1_2"))
    whole = run(stream)
    assert whole.index.tolist() == [0, 1, 2]
    assert np.isnan(whole.column("roll")).tolist() == [True, False, False]
    assert np.isfinite(whole.column("acc_x")).all()


def test_sync_bytes_within_a_packet_mislead_nobody():
    """The data hold FA FF 36, which must not be taken for a beginning."""
    data = item(0x2020, b"\xfa\xff\x36\x07\xfa\xff" * 6)
    stream = b"".join(packet(100 * n, data, ACC) for n in range(20))
    got = run(stream)
    assert (len(got.data), got.garbage, got.bad_checksum) == (20, 0, 0)
    assert run(bytes.fromhex("faff3607e02004fa00fa01cb")).garbage == 0


def test_extended_length():
    filler = b"".join(item(0x5000 + n, bytes(200)) for n in range(4))
    stream = packet(0, filler, ACC) + packet(100, ACC) + packet(200, filler, ACC)
    assert len(packet(0, filler, ACC)) > 300
    got = run(stream)
    assert got.column("acc_z").tolist() == [3, 3, 3]
    assert got.garbage == 0


def test_items_of_a_lower_rate_are_not_a_number_between():
    stream = b"".join(packet(50 * n, *([ACC, MAG] if n % 2 else [ACC])) for n in range(40))
    got = run(stream)
    assert got.column("acc_x").tolist() == [1.0] * 40
    assert np.isnan(got.column("mag_x")).tolist() == [True, False] * 20
    assert got.lost == []


def test_the_sample_time_counts_samples_and_gives_the_rate():
    packets = [packet(100 * n, ACC) for n in range(60)]
    device = mti()
    got = decode(device, randomly(b"".join(packets[:30] + packets[33:]), np.random.default_rng(1)))
    assert got.lost == [(3, 33)]
    assert device.rate == 100.0
    device = mti()
    decode(device, [b"".join(packet(25 * n, ACC) for n in range(60))])
    assert device.rate == 400.0


def test_without_sample_time_the_packet_counter_counts():
    def counted(n: int) -> bytes:
        return message(0x36, item(0x1020, (n % 65536).to_bytes(2, "big")) + ACC)

    packets = [counted(65500 + n) for n in range(100)]
    got = run(b"".join(packets[:50] + packets[52:]))
    assert got.lost == [(2, 52)]
    assert got.row()["packet_counter"] == 65500


def test_items_of_a_wrong_size_or_unknown_are_left_out():
    stream = packet(0, item(0x4020, bytes(11)), item(0x7777, b"?"), MAG)
    assert set(run(stream).names) == {"sample_time", "mag_x", "mag_y", "mag_z"}
    torn = packet(0, MAG, b"\x40\x20\x0c\x00")
    assert "acc_x" not in run(torn).names


def test_a_date_before_the_reform_of_leap_years_is_right_too():
    def utc(moment: datetime) -> bytes:
        year = moment.year.to_bytes(2, "big")
        fields = (moment.month, moment.day, moment.hour, moment.minute, moment.second, 7)
        return item(0x1010, bytes(4) + year + bytes(fields))

    moments = [
        datetime(*when, tzinfo=UTC)
        for when in ((2000, 2, 29, 23, 59, 59), (1970, 1, 1), (2100, 3, 1, 12), (2024, 12, 31))
    ]
    got = run(b"".join(packet(100 * n, utc(moment), ACC) for n, moment in enumerate(moments)))
    assert got.column("utc").tolist() == [moment.timestamp() for moment in moments]
