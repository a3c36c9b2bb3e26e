"""The generator of an unknown CRC.

A CRC is affine over GF(2). In the exclusive-or of two frames of one length its start value and its
final exclusive-or cancel, so message and checksum together, as a polynomial, are a multiple of the
generator. The greatest common divisor of several such differences is the generator itself, without
trying any polynomial (the method is that of the CRC RevEng program's manual).
"""

from collections.abc import Sequence
from itertools import pairwise

_REVERSED = bytes(int(f"{value:08b}"[::-1], 2) for value in range(256))


def reverse_bits(data: bytes) -> bytes:
    """Return the bytes with the bits of each in the opposite order."""
    return data.translate(_REVERSED)


def polynomial_gcd(first: int, second: int) -> int:
    """Return the greatest common divisor of two polynomials over GF(2), bit k for x^k."""
    while second:
        degree = second.bit_length()
        while (shift := first.bit_length() - degree) >= 0:
            first ^= second << shift
        first, second = second, first
    return first


def codewords(
    messages: Sequence[bytes], checks: Sequence[bytes], *, refin: bool, refout: bool, little: bool
) -> list[int]:
    """Return the differences of neighbouring frames as polynomials.

    Parameters
    ----------
    messages : (n,) covered bytes of each frame, all of one length
    checks : (n,) stored checksum of each
    refin, refout : whether bytes enter, and the register leaves, least significant bit first
    little : whether the stored checksum begins with its low byte
    """
    words: list[int] = []
    for message, check in zip(messages, checks, strict=True):
        register = check[::-1] if little else check
        if refout:
            # The whole register reversed: its bytes in the opposite order, and each one's bits.
            register = reverse_bits(register[::-1])
        words.append(
            int.from_bytes((reverse_bits(message) if refin else message) + register, "big")
        )
    return [one ^ other for one, other in pairwise(words) if one != other]


def generator(differences: Sequence[int], width: int) -> int | None:
    """Return the generator without its leading term, or None if these share none of this width.

    Parameters
    ----------
    differences : from `codewords`; a dozen different ones settle it
    width : bits of the CRC
    """
    if len(differences) < 4:
        return None
    common = differences[0]
    for difference in differences[1:]:
        common = polynomial_gcd(common, difference)
        if common.bit_length() <= width:
            return None
    # Trailing zeros are no part of a generator: they mean that the last bits never change.
    if common.bit_length() != width + 1 or not common & 1:
        return None
    return common & ((1 << width) - 1)
