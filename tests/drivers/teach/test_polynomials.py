"""The generator of a CRC comes out of differences of frames."""

import numpy as np
import pytest

from drivers.checksums import CRC_PRESETS, Crc
from drivers.teach.polynomials import codewords, generator, polynomial_gcd, reverse_bits


def test_gcd_of_products_is_the_common_factor():
    # (x + 1)(x^2 + x + 1) = x^3 + 1 and (x + 1) x = x^2 + x over GF(2)
    assert polynomial_gcd(0b1001, 0b110) == 0b11


def test_bits_of_each_byte_are_reversed():
    assert reverse_bits(b"\x01\xf0\x80") == b"\x80\x0f\x01"


@pytest.mark.parametrize("name", sorted(CRC_PRESETS))
def test_the_generator_of_every_named_crc_is_found(name: str):
    spec = CRC_PRESETS[name]
    rows = np.random.default_rng(3).integers(0, 256, (16, 20), np.uint8)
    checks = [int(value).to_bytes(spec.width // 8, "big") for value in Crc(spec)(rows)]
    messages = [row.tobytes() for row in rows]
    words = codewords(messages, checks, refin=spec.refin, refout=spec.refout, little=False)
    assert generator(words, spec.width) == spec.poly
    # By the wrong byte order there is none, but for one byte, which has no order.
    if spec.width > 8:
        wrong = codewords(messages, checks, refin=spec.refin, refout=spec.refout, little=True)
        assert generator(wrong, spec.width) is None


def test_too_few_differences_say_nothing():
    assert generator([0b1001, 0b110], 8) is None
