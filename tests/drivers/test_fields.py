"""Fields: every type, both byte orders, bits, scales, and the way back."""

import numpy as np
import pytest

from core.samples.block import Channel
from drivers.fields import FieldTable, limits, read_raw
from drivers.profile_types import TYPES, FieldSpec

A, B = Channel("a"), Channel("b")


def rows(*frames: bytes) -> np.ndarray:
    return np.frombuffer(b"".join(frames), dtype=np.uint8).reshape(len(frames), -1)


@pytest.mark.parametrize("endian", ["little", "big"])
@pytest.mark.parametrize("kind", [kind for kind in TYPES if kind[0] != "f"])
def test_integers_of_every_size(kind: str, endian: str):
    size = TYPES[kind]
    spec = FieldSpec((A, B), kind, 1, endian=endian)
    low, high = limits(spec)
    values = [(low, high), (1, 0x12 if size == 1 else 0x1234), (max(low, -2), high - 1)]
    frames = [
        b"\xee" + b"".join(v.to_bytes(size, endian, signed=low < 0) for v in pair) + b"\xee"  # type: ignore[arg-type]
        for pair in values
    ]
    assert read_raw(rows(*frames), spec).tolist() == [list(pair) for pair in values]


@pytest.mark.parametrize("endian", ["little", "big"])
@pytest.mark.parametrize("kind", ["f32", "f64"])
def test_floats(kind: str, endian: str):
    order = "<" if endian == "little" else ">"
    numbers = np.array([1.5, -2.25], dtype=f"{order}f{TYPES[kind]}")
    spec = FieldSpec((A, B), kind, 2, endian=endian)
    assert read_raw(rows(b"\0\0" + numbers.tobytes()), spec).tolist() == [[1.5, -2.25]]


def test_small_integers_are_widened_before_they_are_scaled():
    spec = FieldSpec((A,), "i16", 0, scale=10.0, offset=-1.0)
    values = FieldTable([spec]).values(rows((4300).to_bytes(2, "little")))
    assert values.tolist() == [[42999.0]]


def test_bits_are_cut_out():
    byte = (0b1011_0110_0000_0001).to_bytes(2, "little")
    low = FieldSpec((A,), "u16", 0, bits=(0, 3))
    high = FieldSpec((B,), "u16", 0, bits=(9, 13))
    assert FieldTable([low, high]).values(rows(byte)).tolist() == [[1.0, 0b11011]]
    assert limits(high) == (0, 31)


def test_hidden_fields_are_no_columns_but_can_count():
    table = FieldTable([FieldSpec((A, B), "u8", 0, hide=True), FieldSpec((Channel("c"),), "u8", 2)])
    frames = rows(b"\1\2\3", b"\4\5\6")
    assert table.channels == (Channel("c"),)
    assert table.values(frames).tolist() == [[3.0], [6.0]]
    assert table.counts(frames, "b").tolist() == [2, 5]
    with pytest.raises(ValueError, match='no field "x"'):
        table.counts(frames, "x")


def test_a_signalling_not_a_number_is_one_and_no_warning():
    value = FieldTable([FieldSpec((A,), "f32", 0)]).values(rows(b"\x01\x00\xa0\x7f"))
    assert np.isnan(value).all()


@pytest.mark.parametrize("endian", ["little", "big"])
@pytest.mark.parametrize("kind", TYPES)
def test_writing_is_the_inverse_of_reading(kind: str, endian: str):
    rng = np.random.default_rng(1)
    spec = FieldSpec((A, B), kind, 3, scale=0.5, offset=2.0, endian=endian)
    table = FieldTable([spec])
    data = rng.integers(0, 100, (20, 2)) * 0.5 + 2.0
    frames = np.zeros((20, spec.end), dtype=np.uint8)
    table.write(frames, data)
    np.testing.assert_array_equal(table.values(frames), data)
    assert not frames[:, :3].any()


@pytest.mark.parametrize("kind", ["u8", "i8", "u16", "i16", "u24", "i24", "u32", "i32"])
def test_written_integers_are_rounded_and_held_at_the_ends_of_the_range(kind: str):
    spec = FieldSpec((A,), kind, 0)
    table = FieldTable([spec])
    low, high = limits(spec)
    frames = np.zeros((4, spec.end), dtype=np.uint8)
    table.write(frames, np.array([[-1e30], [1e30], [2.5001], [7.49]]))
    assert table.values(frames).ravel().tolist() == [low, high, 3.0, 7.0]


def test_written_bits_share_their_number():
    table = FieldTable(
        [FieldSpec((A,), "u16", 0, bits=(0, 3)), FieldSpec((B,), "u16", 0, bits=(4, 15))]
    )
    frames = np.zeros((1, 2), dtype=np.uint8)
    table.write(frames, np.array([[5.0, 1000.0]]))
    assert table.values(frames).tolist() == [[5.0, 1000.0]]


def test_counts_are_written_and_skipped_columns_left_to_them():
    spec = FieldSpec((A, B), "u16", 0)
    table = FieldTable([spec])
    frames = np.zeros((2, 4), dtype=np.uint8)
    table.write(frames, np.array([[9.0, 1.0], [9.0, 2.0]]), skip="a")
    table.write_counts(frames, "a", np.array([100, 101]))
    assert table.values(frames).tolist() == [[100.0, 1.0], [101.0, 2.0]]
