"""Text lines: the stored examples, and never a number that was not sent."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.samples.block import SampleBlock
from core.units import STANDARD_GRAVITY
from drivers.line import LineDecoder
from drivers.lines import xor_sum
from drivers.profile import load_profiles, parse_profile
from drivers.profile_types import LineSpec
from tests.drivers.streams import Outcome, bytewise, decode, same, stored

PROFILES = load_profiles()
STREAMS = stored("ascii_streams")


def lines(section: str) -> LineDecoder:
    """A decoder of a [line] section."""
    text = (
        f'schema = 1\n[device]\nname = "L"\nkind = "imu"\n[port]\nbaud = [9600]\n[line]\n{section}'
    )
    spec = parse_profile(text, "lines").stream
    assert isinstance(spec, LineSpec)
    return LineDecoder(spec, 0.0)


def packaged(name: str) -> LineDecoder:
    spec = PROFILES[name].stream
    assert isinstance(spec, LineSpec)
    return LineDecoder(spec, PROFILES[name].nominal_hz)


def run(section: str, data: bytes) -> Outcome:
    whole = decode(lines(section), [data])
    same(decode(lines(section), bytewise(data)), whole)
    return whole


def example(name: str) -> bytes:
    return STREAMS[name]["bytes"]


def test_the_sketch_for_mpu6050_with_its_banner():
    data = (
        example("truncated_first_line") + example("arduino_banner") + example("arduino_banner2")
        + example("i2cdevlib_mpu6050") + example("garbage_utf8") + example("i2cdevlib_mpu6050")
    )  # fmt: skip
    got = decode(packaged("arduino_mpu6050"), [data])
    same(decode(packaged("arduino_mpu6050"), bytewise(data)), got)
    raw = np.array(STREAMS["i2cdevlib_mpu6050"]["expected"]["values"])
    scales = [STANDARD_GRAVITY / 16384] * 3 + [1 / 131] * 3
    np.testing.assert_allclose(got.data, [raw * scales] * 2, rtol=1e-14)
    assert got.units == ("m/s^2",) * 3 + ("deg/s",) * 3
    assert got.garbage == len(example("truncated_first_line"))
    assert [fields["text"] for _, _, fields in got.messages] == [
        "Initializing I2C devices...", "MPU6050 connection successful", "\xff\xfe\x80",
    ]  # fmt: skip
    assert got.lost == []


@pytest.mark.parametrize("name", ["csv_9", "semicolon_comma_decimal"])
def test_unnamed_columns_settle_after_five_lines(name: str):
    values = STREAMS[name]["expected"]["values"]
    device = packaged("generic_csv")
    assert device.feed(b"partial\n" + example(name) * 4)[1:] == []
    assert device.channels == ()
    (block,) = device.feed(example(name))
    assert isinstance(block, SampleBlock)
    assert block.data.tolist() == [values] * 5
    assert [channel.name for channel in block.channels] == [
        f"ch{n}" for n in range(1, len(values) + 1)
    ]
    data = b"partial\n" + example(name) * 9
    same(decode(packaged("generic_csv"), bytewise(data)), decode(packaged("generic_csv"), [data]))


def test_fewer_than_five_lines_that_agree_are_text():
    data = b"x\n" + b"1,2\n" * 3 + b"1,2,3\n" * 4 + b"hello\n" + b"4;5\n" * 2
    got = run('delimiter = "auto"', data)
    assert len(got.data) == 0
    assert len(got.messages) == 10


@pytest.mark.parametrize(
    ("line", "values"),
    [
        ("1;2,5;3", [1, 2.5, 3]), ("1\t2.5\t3", [1, 2.5, 3]), ("1\t2,5\t3", [1, 2.5, 3]),
        ("1, 2.5, 3", [1, 2.5, 3]), ("1 2.5  3", [1, 2.5, 3]), ("-1e3 +.5 7.", [-1000, 0.5, 7]),
        ("1,5 2,5", [1.5, 2.5]), ("3.25", [3.25]),
    ],
)  # fmt: skip
def test_delimiter_and_decimal_mark_are_found(line: str, values: list[float]):
    got = run("", b"-\n" + f"{line}\r\n".encode("ascii") * 6)
    assert got.data.tolist() == [values] * 6


def test_stored_examples_of_other_shapes():
    cases = {
        "serialplotter_labels": 'style = "labels"\ncolumns = ["ax", "ay", "az"]\ndelimiter = "tab"',
        "teleplot": 'style = "labels"\ncolumns = ["gyroX"]\nprefix = ">"',
        "json": 'style = "json"\ncolumns = ["ax", "ay", "az"]',
        "kvh_dsp3000": 'columns = ["rate_dps", "valid"]\ndelimiter = "ws"',
    }
    for name, section in cases.items():
        expected = STREAMS[name]["expected"]
        got = run(section, b"\n" + example(name))
        assert got.row() == expected.get("values", expected), name
    got = decode(packaged("adxl345_text"), [b"\n" + example("adafruit_adxl345")])
    assert got.row() == STREAMS["adafruit_adxl345"]["expected"]["values"]
    got = decode(packaged("kvh_dsp3000"), [b"\n" + example("kvh_dsp3000")])
    assert got.row() == {"rate": -0.012345, "valid": 1}


@pytest.mark.parametrize(
    "bad",
    [
        "1,2", "1,2,3,4", "1,,3", "1,x,3", "1,2,3x", "1,nan,3", "1,inf,3", "1,1e999,3", "1;2;3",
        "1,0x2,3", "1,2_0,3", "1,--2,3", "1,2,3,", "1,\u0662,3", "1,2.5.1,3", "{}", "1 2 3",
    ],
)  # fmt: skip
def test_what_does_not_fit_is_text_and_never_a_number(bad: str):
    section = 'columns = ["a", "b", "c"]\ndelimiter = ","'
    got = run(section, b"-\n1,2,3\n" + bad.encode("utf-8") + b"\n4,5,6\n")
    assert got.data.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert [kind for kind, _, _ in got.messages] == ["text"]
    assert len(got.lost) == (bad.count(",") == 2)


@pytest.mark.parametrize(
    "bad", ['{"a":1}', '{"a":1,"b":null}', '{"a":1,"b":true}', '{"a":1,"b":"2"}', '{"a":1,"b":NaN}',
            '{"a":1,"b":1e400}', "[1,2]", '{"a":1,"b":2', "[" * 3000, "1", '{"a":1,"b":[2]}'],
)  # fmt: skip
def test_json_that_does_not_fit_is_text(bad: str):
    got = run('style = "json"\ncolumns = ["a", "b"]', b"-\n" + bad.encode("ascii") + b"\n")
    assert len(got.data) == 0
    assert [kind for kind, _, _ in got.messages] == ["text"]


def test_json_may_hold_more_than_is_asked_for():
    got = run('style = "json"\ncolumns = ["b"]', b'-\n{"a":1,"b":2.5,"name":"x"}\n')
    assert got.row() == {"b": 2.5}


def test_nmea_lines_prove_themselves():
    def nmea(body: str) -> bytes:
        return f"${body}*{xor_sum(body):02X}\r\n".encode("ascii")

    section = 'prefix = "$PLAB,"\ndelimiter = ","\ncolumns = ["a", "b"]\nchecksum = "nmea"'
    stream = nmea("PLAB,1,2") + nmea("PLAB,3,4").replace(b"3,4", b"3,5") + nmea("GPGGA,9")
    stream += b"hello\r\n" + nmea("PLAB,5,6")
    got = run(section, stream)
    assert got.data.tolist() == [[1, 2], [5, 6]]
    assert got.bad_checksum == 1
    assert got.lost == [(1, 2)]
    assert [kind for kind, _, _ in got.messages] == ["text", "text"]


def test_a_column_can_be_the_counter():
    section = (
        'columns = ["t", "a"]\ndelimiter = ","\n'
        'counter = { field = "t", bits = 16, step = 5 }\nscale = ["1/1000", 1]'
    )
    times = [65525, 65530, 65535, 4, 9, 24, 29]
    got = run(section, b"-\n" + b"".join(f"{t},1\n".encode("ascii") for t in times))
    assert got.index.tolist() == [0, 1, 2, 3, 4, 7, 8]
    assert got.lost == [(2, 7)]
    assert got.column("t")[0] == 65.525


def test_scale_offset_and_decimal_comma():
    section = 'columns = ["a"]\ndecimal = ","\ndelimiter = ";"\nscale = ["1/4"]\noffset = [-1]'
    assert run(section, b"-\n6,5\n").row() == {"a": 0.625}


@given(data=st.binary(max_size=400), cuts=st.lists(st.integers(0, 400), max_size=8))
@pytest.mark.parametrize("name", ["generic_csv", "arduino_mpu6050", "adxl345_text"])
def test_random_bytes_never_raise_and_never_depend_on_the_pieces(
    name: str, data: bytes, cuts: list[int]
):
    edges = [0, *sorted(cut for cut in cuts if cut < len(data)), len(data)]
    pieces = [data[a:b] for a, b in itertools.pairwise(edges)]
    same(decode(packaged(name), pieces), decode(packaged(name), [data]))


@given(st.lists(st.text("0123456789.,;- e+\t", max_size=20), max_size=30))
def test_whatever_is_read_was_written(texts: list[str]):
    data = "-\n" + "\n".join(texts) + "\n"
    got = decode(packaged("generic_csv"), [data.encode("ascii")])
    assert all(map(math.isfinite, got.data.ravel().tolist()))
    assert len(got.data) + len(got.messages) == sum(bool(text.strip()) for text in texts)
