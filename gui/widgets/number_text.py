"""Numbers as text: as many digits as the uncertainty allows (GUM 7.2.6), points aligned."""

import math
from collections.abc import Sequence
from decimal import ROUND_HALF_EVEN, Context, Decimal

MINUS = "\N{MINUS SIGN}"
# A double has at most 308 digits before the point; the default of 28 is not enough for 1e30.
_WIDE = Context(prec=700)
_GAP = "\N{NARROW NO-BREAK SPACE}"
_FIGURE = "\N{FIGURE SPACE}"
_PUNCTUATION = "\N{PUNCTUATION SPACE}"


def decimals_of(uncertainty: float, digits: int = 2) -> int:
    """Return the decimal places that show an uncertainty with so many significant digits.

    Negative where digits before the point are rounded away, e.g. -1 for 1234 shown as 1230.

    Raises
    ------
    ValueError
        `uncertainty` is not positive and finite.
    """
    if not (math.isfinite(uncertainty) and uncertainty > 0.0):
        raise ValueError(f"an uncertainty of {uncertainty} gives no number of digits")
    # 0.0996 shown with two digits is 0.10: the rounding itself may add a place in front.
    return digits - 1 - Decimal(f"{uncertainty:.{digits - 1}e}").adjusted()


def fixed(value: float, decimals: int) -> str:
    """Return `value` with so many decimal places and a true minus sign; words for no number."""
    if not math.isfinite(value):
        return "\N{EM DASH}" if math.isnan(value) else ("∞" if value > 0 else f"{MINUS}∞")
    # By the shortest decimal of the double, so that 2.675 rounds as it reads.
    exact = Decimal(repr(float(value)))
    rounded = exact.quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_EVEN, _WIDE)
    text = f"{rounded:f}" if rounded else f"{abs(rounded):f}"
    return text.replace("-", MINUS)


def value_and_uncertainty(value: float, uncertainty: float) -> tuple[str, str]:
    """Return a result and its uncertainty, both rounded to two digits of the uncertainty.

    To nearest: with two digits that takes less than 5 % off an uncertainty, so it need not be
    rounded up (EA-4/02, 6.3). Without a positive finite uncertainty the value has seven digits
    and the uncertainty a dash.
    """
    if not (math.isfinite(uncertainty) and uncertainty > 0.0):
        return significant(value, 7), "\N{EM DASH}"
    decimals = decimals_of(uncertainty)
    return fixed(value, decimals), fixed(uncertainty, decimals)


def significant(value: float, digits: int) -> str:
    """Return `value` with so many significant digits, without exponent between 1e-5 and 1e9."""
    if not math.isfinite(value) or value == 0.0:
        return fixed(value, 0)
    size = abs(value)
    if 1e-5 <= size < 1e9:
        return fixed(value, max(0, decimals_of(size, digits)))
    return f"{value:.{digits - 1}e}".replace("-", MINUS)


def grouped(value: int) -> str:
    """Return an integer in groups of three, ``12 480``; four digits stay together."""
    if -10000 < value < 10000:
        return str(value).replace("-", MINUS)
    return f"{value:,}".replace(",", _GAP).replace("-", MINUS)


def aligned(texts: Sequence[str]) -> list[str]:
    """Pad on the right so that, set flush right, the decimal points stand in one column.

    A figure space is as wide as a digit and a punctuation space as wide as a point.
    """
    tails = [text.partition(".")[2] if _is_number(text) else "" for text in texts]
    longest = max((len(tail) for tail in tails), default=0)
    padded: list[str] = []
    for text, tail in zip(texts, tails, strict=True):
        point = _PUNCTUATION if longest and not tail else ""
        padded.append(text + point + _FIGURE * (longest - len(tail)))
    return padded


def _is_number(text: str) -> bool:
    body = text.removeprefix(MINUS).replace(".", "", 1)
    return body.isdigit()
