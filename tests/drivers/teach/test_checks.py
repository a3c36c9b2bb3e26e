"""Checksums are found on frames, whatever their parameters."""

import numpy as np
import pytest

from drivers.checksums import Checksum, ChecksumSpec, CrcSpec
from drivers.teach.checks import search_checks, share_of


def rows_with(spec: ChecksumSpec, seed: int = 1) -> np.ndarray:
    rows = np.random.default_rng(seed).integers(0, 256, (60, 21), np.uint8)
    rows[:, :3] = 0xAB, 0xCD, 0x17
    Checksum(spec).stamp(rows)
    return rows


@pytest.mark.parametrize(
    "spec",
    [
        ChecksumSpec("sum8", 0, -1, -1, 1, "little"),
        ChecksumSpec("sum8", 3, -1, -1, 1, "little", negate=True),
        ChecksumSpec("xor8", 2, -1, -1, 1, "little"),
        ChecksumSpec("sum16", 2, -2, -2, 2, "big"),
        ChecksumSpec("sum16w", 3, -2, -2, 2, "little"),
        ChecksumSpec("fletcher16", 1, -2, -2, 2, "big"),
    ],
)
def test_sums_are_found_with_their_range(spec: ChecksumSpec):
    best = search_checks(rows_with(spec), 3)[0]
    assert (best.share, best.spec) == (1.0, spec)


@pytest.mark.parametrize("width", [8, 16, 32])
@pytest.mark.parametrize("turned", [False, True])
def test_a_crc_of_any_parameters_is_found(width: int, turned: bool):
    crc = CrcSpec(width, 0x9B9B9B9B >> (32 - width) | 1, 0x5A, turned, turned, 0x3C)
    size = width // 8
    rows = rows_with(ChecksumSpec(f"crc{width}", 0, -size, -size, size, "little", crc=crc))
    best = search_checks(rows, 3)[0]
    assert best.share == 1.0
    assert best.spec.crc.poly == crc.poly
    assert f"poly 0x{crc.poly:0{width // 4}X}" in best.text
    # Frames that were not looked at hold it as well.
    fresh = rows_with(ChecksumSpec(f"crc{width}", 0, -size, -size, size, "little", crc=crc), 2)
    assert share_of(fresh, best.spec) == 1.0


def test_the_share_counts_damaged_frames():
    rows = rows_with(ChecksumSpec("sum8", 0, -1, -1, 1, "little"))
    rows[::4, 7] += 1
    assert search_checks(rows, 3)[0].share == pytest.approx(0.75)


def test_noise_holds_no_checksum():
    rows = np.random.default_rng(4).integers(0, 256, (60, 21), np.uint8)
    assert search_checks(rows, 3) == []
