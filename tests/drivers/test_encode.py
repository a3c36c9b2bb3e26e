"""Encoding is the inverse of decoding, for every profile that a simulated rig can speak."""

import numpy as np
import pytest

from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.fields import limits
from drivers.profile import Profile, load_profiles, parse_profile
from drivers.profile_types import FrameSpec, LineSpec
from drivers.protocols.inertial import message_fields
from tests.drivers.device_texts import GOOD, LINES
from tests.drivers.streams import Outcome, decode, stored

PROFILES = load_profiles()
SPOKEN = [
    name
    for name, profile in PROFILES.items()
    if isinstance(profile.stream, FrameSpec)
    or (isinstance(profile.stream, LineSpec) and profile.stream.channels)
    or name == "inertiallabs_ahrs"
]


def resolution(profile: Profile) -> np.ndarray:
    """Half of the smallest step of each column, with a margin for single precision."""
    stream = profile.stream
    if isinstance(stream, LineSpec):
        return np.array(stream.scales) * (0.5 * 10.0**-stream.digits + 1e-12)
    fields = (
        message_fields(0x33, profile.params["KG"], profile.params["KA"])
        if not isinstance(stream, FrameSpec)
        else tuple(field for field in stream.fields if not field.hide)
    )
    return np.array(
        [
            abs(field.scale) * (1e-4 if field.type[0] == "f" else 0.5 + 1e-9)
            for field in fields
            for _ in field.channels
        ]
    )


def within(profile: Profile, rng: np.random.Generator, count: int) -> np.ndarray:
    """Values that every column can hold."""
    columns = len(make_decoder(profile).channels)
    stream = profile.stream
    unit = rng.uniform(0, 1, (count, columns))
    if isinstance(stream, LineSpec):
        return (unit - 0.5) * 1000 * np.array(stream.scales)
    fields = (
        message_fields(0x33, profile.params["KG"], profile.params["KA"])
        if not isinstance(stream, FrameSpec)
        else tuple(field for field in stream.fields if not field.hide)
    )
    low, high = [], []
    for field in fields:
        raw = (-1000, 1000) if field.type[0] == "f" else limits(field)
        low += [raw[0] * field.scale + field.offset] * len(field.channels)
        high += [raw[1] * field.scale + field.offset] * len(field.channels)
    return np.array(low) + unit * (np.array(high) - np.array(low))


def back(profile: Profile, data: bytes) -> Outcome:
    # Text starts with a line that is dropped.
    before = b"\n" if isinstance(profile.stream, LineSpec) else b""
    return decode(make_decoder(profile), [before, data])


@pytest.mark.parametrize("name", SPOKEN)
def test_what_is_encoded_is_decoded(name: str):
    profile = PROFILES[name]
    rng = np.random.default_rng(7)
    data = within(profile, rng, 500)
    index = np.arange(500)
    got = back(profile, encode(profile, index, data))
    assert got.garbage == (1 if isinstance(profile.stream, LineSpec) else 0)
    assert (got.bad_checksum, got.bad_values, got.lost, got.messages) == (0, 0, [], [])
    np.testing.assert_array_equal(got.index, index)
    counted = {"counter", "count", "sequence", "time", "time_counter"}
    columns = [n for n, column in enumerate(got.names) if column not in counted]
    assert len(columns) >= 2
    error = np.abs(got.data - data)[:, columns]
    assert (error <= resolution(profile)[columns]).all()


@pytest.mark.parametrize("name", ["adc_board9", "pw09_raw", "dmu30", "aceinna_s1"])
def test_missing_indices_are_lost_samples(name: str):
    profile = PROFILES[name]
    index = np.delete(np.arange(40), [20, 21, 22])
    data = np.zeros((37, len(make_decoder(profile).channels)))
    got = back(profile, encode(profile, index, data))
    assert got.lost == [(3, 23)]
    np.testing.assert_array_equal(got.index, index)


def test_counters_wrap_as_in_the_device():
    profile = PROFILES["adc_board9"]
    index = np.arange(65530, 65545)
    raw = encode(profile, index, np.zeros((15, 18)))
    got = back(profile, raw)
    assert got.lost == []
    assert got.index.tolist() == list(range(15))


def test_the_ends_of_the_range_are_held():
    profile = PROFILES["adc_board9"]
    got = back(profile, encode(profile, np.arange(2), np.array([[1e9] * 18, [-1e9] * 18])))
    assert got.data[0].tolist() == [2**23 - 1] * 9 + [65535] * 9
    assert got.data[1].tolist() == [-(2**23)] * 9 + [0] * 9


def test_stored_frames_are_encoded_to_the_same_bytes():
    for file, name, frame in (
        ("cvg_innalabs", "cvgx48", "cvgx48_0"),
        ("silicon_sensing_dmu", "dmu11", "dmu11_40_derived"),
    ):  # fmt: skip
        raw = stored(file)[frame]["bytes"]
        profile = PROFILES[name]
        row = decode(make_decoder(profile), [raw]).data
        assert encode(profile, np.array([7]), row) == raw
    inertial = stored("inertiallabs")["imu_orientation_0x33"]["bytes"]
    profile = PROFILES["inertiallabs_ahrs"]
    row = decode(make_decoder(profile), [inertial]).data
    assert encode(profile, np.array([0]), row) == inertial


def test_bits_tails_and_told_lengths():
    text = GOOD.replace("reject_abs = 5", 'tail = "0D 0A"').replace(
        "length = 12", 'length = { at = 10, type = "u8", mul = 2, add = 2, min = 12, max = 12 }'
    )
    profile = parse_profile(text, "x")
    data = np.array([[1.5, -2.0, 3.0], [0.25, 4.0, 1.0]])
    raw = encode(profile, np.array([5, 6]), data)
    assert len(raw) == 28
    assert raw[12:14] == raw[26:] == b"\r\n"
    assert (raw[3], raw[10], raw[17]) == (10, 5, 12)
    got = back(profile, raw)
    assert got.garbage == 0
    assert got.data.tolist() == data.tolist()


@pytest.mark.parametrize(
    ("section", "text"),
    [
        ("", b"1.500000,-2.000000\n"),
        ('digits = 1\ndelimiter = ";"\ndecimal = ","\nend = "\\r\\n"', b"1,5;-2,0\r\n"),
        ('digits = 0\ndelimiter = "tab"\nprefix = "x:"', b"x:2\t-2\n"),
        ('digits = 1\nstyle = "labels"\nsuffix = " V"', b"a:1.5,b:-2.0 V\n"),
        ('digits = 1\nstyle = "json"', b'{"a":1.5,"b":-2.0}\n'),
        ('digits = 1\nprefix = "$X,"\nchecksum = "nmea"', b"$X,1.5,-2.0*73\n"),
        ('digits = 1\nscale = ["1/2", 1]\noffset = [1, 0]', b"1.0,-2.0\n"),
    ],
)
def test_lines(section: str, text: bytes):
    profile = parse_profile(LINES + section, "x")
    data = np.array([[1.5, -2.0]])
    assert encode(profile, np.array([0]), data) == text
    if "digits = 0" not in section:
        np.testing.assert_allclose(back(profile, text).data, data)


def test_a_counted_column_of_a_line_runs_with_the_index():
    text = LINES + 'counter = { field = "a", bits = 8, step = 2 }\n'
    profile = parse_profile(text, "x")
    data = np.array([[99.0, 1.0]] * 3)
    raw = encode(profile, np.array([126, 127, 128]), data)
    assert [line.split(b".")[0] for line in raw.splitlines()] == [b"252", b"254", b"0"]
    assert data[0, 0] == 99.0


def test_what_cannot_be_sent_is_refused():
    with pytest.raises(ValueError, match="18 channels"):
        encode(PROFILES["adc_board9"], np.arange(2), np.zeros((2, 3)))
    with pytest.raises(ValueError, match="finite"):
        encode(PROFILES["cvgx48"], np.arange(1), np.full((1, 11), np.nan))
    with pytest.raises(ValueError, match="no encoder"):
        encode(PROFILES["stim300"], np.arange(1), np.zeros((1, 3)))
