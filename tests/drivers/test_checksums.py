"""Checksums against catalogue values, the standard library and a bit-by-bit CRC."""

import zlib

import numpy as np
import pytest

from drivers.checksums import (
    CRC_PRESETS,
    Checksum,
    ChecksumSpec,
    Crc,
    CrcSpec,
    fletcher16,
    sum8,
    sum16,
    sum16w,
    xor8,
)
from tests.drivers.streams import stored

CHECK = np.frombuffer(b"123456789", dtype=np.uint8).reshape(1, -1)

CATALOGUE = {
    "crc-8": 0xF4, "crc-8/maxim": 0xA1, "crc-8/stim300": 0xFB, "crc-16/arc": 0xBB3D,
    "crc-16/modbus": 0x4B37, "crc-16/kermit": 0x2189, "crc-16/x-25": 0x906E,
    "crc-16/xmodem": 0x31C3, "crc-16/ccitt-false": 0x29B1, "crc-16/aug-ccitt": 0xE5CC,
    "crc-32": 0xCBF43926, "crc-32/bzip2": 0xFC891918, "crc-32/mpeg-2": 0x0376E6E7,
}  # fmt: skip


def bit_by_bit(data: bytes, spec: CrcSpec) -> int:
    """The definition, one bit at a time."""
    register, top, mask = spec.init, 1 << (spec.width - 1), (1 << spec.width) - 1
    for byte in data:
        bits = range(8) if spec.refin else range(7, -1, -1)
        for bit in bits:
            carry = bool(register & top) ^ bool(byte >> bit & 1)
            register = (register << 1) & mask
            if carry:
                register ^= spec.poly
    if spec.refout:
        register = int(f"{register:0{spec.width}b}"[::-1], 2)
    return register ^ spec.xorout


def rows(rng: np.random.Generator, count: int, width: int) -> np.ndarray:
    return rng.integers(0, 256, (count, width), dtype=np.uint8)


def test_every_preset_gives_its_catalogue_value():
    assert {name: int(Crc(spec)(CHECK)[0]) for name, spec in CRC_PRESETS.items()} == CATALOGUE


@pytest.mark.parametrize("width", [8, 16, 32])
@pytest.mark.parametrize("refin", [False, True])
@pytest.mark.parametrize("refout", [False, True])
def test_any_parameters_agree_with_the_definition(width: int, refin: bool, refout: bool):
    rng = np.random.default_rng(width)
    spec = CrcSpec(
        width, int(rng.integers(1, 2**width)) | 1, int(rng.integers(2**width)), refin, refout,
        int(rng.integers(2**width)),
    )  # fmt: skip
    crc = Crc(spec)
    for length in (1, 2, 17, 5):
        frames = rows(rng, 8, length)
        assert crc(frames).tolist() == [bit_by_bit(row.tobytes(), spec) for row in frames]


def test_crc32_agrees_with_zlib_and_not_with_the_one_of_stim300():
    frames = rows(np.random.default_rng(1), 20, 63)
    expected = [zlib.crc32(row.tobytes()) for row in frames]
    assert Crc(CRC_PRESETS["crc-32"])(frames).tolist() == expected
    assert Crc(CRC_PRESETS["crc-32/mpeg-2"])(frames).tolist() != expected


def test_dummy_zeros_count_as_if_they_were_there():
    frames = rows(np.random.default_rng(2), 5, 14)
    padded = np.pad(frames, ((0, 0), (0, 3)))
    spec = CRC_PRESETS["crc-32/mpeg-2"]
    assert Crc(spec, zeros=3)(frames).tolist() == Crc(spec)(padded).tolist()


def test_sums_wrap():
    frames = np.full((2, 600), 0xFF, dtype=np.uint8)
    assert sum8(frames).tolist() == [600 * 255 % 256] * 2
    assert sum16(frames).tolist() == [600 * 255 % 65536] * 2
    assert sum16w(frames, "little").tolist() == [300 * 65535 % 65536] * 2
    assert xor8(CHECK).tolist() == [0x31]


def test_word_sum_depends_on_the_byte_order():
    frame = np.array([[1, 2, 3, 4]], dtype=np.uint8)
    assert sum16w(frame, "little").tolist() == [0x0201 + 0x0403]
    assert sum16w(frame, "big").tolist() == [0x0102 + 0x0304]


@pytest.mark.parametrize(
    ("text", "value"), [(b"abcde", 0xC8F0), (b"abcdef", 0x2057), (b"abcdefgh", 0x0627)]
)
def test_fletcher_gives_its_published_values(text: bytes, value: int):
    assert fletcher16(np.frombuffer(text, dtype=np.uint8).reshape(1, -1)).tolist() == [value]


@pytest.mark.parametrize(
    "algorithm", ["sum8", "sum16", "sum16w", "xor8", "fletcher16", "crc-16/arc"]
)
@pytest.mark.parametrize("endian", ["little", "big"])
def test_a_stamped_frame_is_intact_until_a_bit_changes(algorithm: str, endian: str):
    rng = np.random.default_rng(3)
    size = 1 if algorithm in ("sum8", "xor8") else 2
    spec = ChecksumSpec(
        algorithm, 2, -size, -size, size, endian, negate=algorithm == "sum16",
        crc=CRC_PRESETS.get(algorithm),
    )  # fmt: skip
    checksum = Checksum(spec)
    frames = rows(rng, 50, 20 + size)
    checksum.stamp(frames)
    assert checksum.intact(frames).all()
    frames[:, 7] ^= 0x10
    assert not checksum.intact(frames).any()


def test_a_negated_word_sum_makes_the_whole_frame_add_up_to_zero():
    frame = stored("silicon_sensing_dmu")["dmu30_derived"]["bytes"]
    whole = np.frombuffer(frame, dtype=np.uint8).reshape(1, -1)
    assert sum16w(whole, "big").tolist() == [0]
    spec = ChecksumSpec("sum16w", 0, -2, -2, 2, "big", negate=True)
    assert Checksum(spec).intact(whole).all()


def test_the_utility_mode_of_stim300_writes_its_crc_in_decimal():
    crc = Crc(CRC_PRESETS["crc-8/stim300"])
    for name in ("utility_fig10_1", "utility_fig10_2", "utility_fig10_3"):
        body, _, digits = stored("stim300")[name]["ascii"].strip().rpartition(",")
        covered = np.frombuffer(f"{body},".encode("ascii"), dtype=np.uint8).reshape(1, -1)
        assert crc(covered).tolist() == [int(digits)]


def test_one_table_serves_frames_of_several_lengths():
    crc = Checksum(
        ChecksumSpec(
            "crc-32/mpeg-2", 0, -4, -4, 4, "big", pad_to=4, crc=CRC_PRESETS["crc-32/mpeg-2"]
        )
    )
    for name in ("normal_a7", "normal_90", "normal_94", "captured_full_aux_af", "normal_91"):
        frame = np.frombuffer(stored("stim300")[name]["bytes"], dtype=np.uint8).reshape(1, -1)
        assert crc.intact(frame).all(), name
