"""One noise coefficient in the units and conventions people quote.

A factor of 1.41 or 1.5 between two honest people is usually one of these:

* N: S(f) = N^2 is two-sided here (so N = sigma(1 s) on the -1/2 line, and 1 deg/sqrt(s) =
  60 deg/sqrt(h)); data sheets give the one-sided noise density sqrt(2) N in deg/s/sqrt(Hz).
* B: the flicker coefficient of (6.4); many give the floor of the curve, 0.664 B, under its name.
"""

import math
from dataclasses import dataclass

from core.allan.model import FLOOR
from core.units import (
    ARCSEC_PER_DEG,
    DEG_PER_RT_H_PER_DEG_PER_RT_S,
    DPH_PER_DPS,
    MICRO,
    RAD_PER_DEG,
    STANDARD_GRAVITY,
)


@dataclass(frozen=True, slots=True)
class Convention:
    """One way to quote a coefficient: multiply it by `factor`.

    Parameters
    ----------
    name : short stable identifier
    text : what is quoted, in words
    unit : unit of the product
    factor : from the coefficient in its own unit
    """

    name: str
    text: str
    unit: str
    factor: float


_ROOT_2 = math.sqrt(2.0)
_ROOT_HOUR = DEG_PER_RT_H_PER_DEG_PER_RT_S
_HOUR = DPH_PER_DPS
_MICRO_G = 1.0 / (MICRO * STANDARD_GRAVITY)
_TWO_SIDED = "random walk, two-sided S = N^2"
_ONE_SIDED = "noise density, one-sided"
_FLICKER = "flicker coefficient B"
_FLOOR = "floor of the Allan curve, 0.664 B"

CONVENTIONS: dict[tuple[str, str], tuple[Convention, ...]] = {
    # (unit of the record, term): the coefficient's own unit comes first
    ("deg/s", "quantization"): (
        Convention("si", "angle quantisation", "deg", 1.0),
        Convention("arcsec", "angle quantisation", "arcsec", ARCSEC_PER_DEG),
    ),
    ("deg/s", "random_walk"): (
        Convention("si", _TWO_SIDED, "deg/sqrt(s)", 1.0),
        Convention("per_root_hour", _TWO_SIDED, "deg/sqrt(h)", _ROOT_HOUR),
        Convention("one_sided", _ONE_SIDED, "deg/s/sqrt(Hz)", _ROOT_2),
        Convention("radian", _TWO_SIDED, "rad/s/sqrt(Hz)", RAD_PER_DEG),
    ),
    ("deg/s", "bias_instability"): (
        Convention("si", _FLICKER, "deg/s", 1.0),
        Convention("per_hour", _FLICKER, "deg/h", _HOUR),
        Convention("floor", _FLOOR, "deg/s", FLOOR),
        Convention("floor_per_hour", _FLOOR, "deg/h", FLOOR * _HOUR),
    ),
    ("deg/s", "rate_random_walk"): (
        Convention("si", "rate random walk", "deg/s/sqrt(s)", 1.0),
        Convention("per_root_hour", "rate random walk", "deg/h/sqrt(h)", _HOUR * _ROOT_HOUR),
        Convention("radian", "rate random walk", "rad/s^2/sqrt(Hz)", RAD_PER_DEG),
    ),
    ("deg/s", "rate_ramp"): (
        Convention("si", "rate ramp", "deg/s^2", 1.0),
        Convention("per_hour", "rate ramp", "deg/h/h", _HOUR * _HOUR),
    ),
    ("m/s^2", "quantization"): (Convention("si", "velocity quantisation", "m/s", 1.0),),
    ("m/s^2", "random_walk"): (
        Convention("si", _TWO_SIDED, "m/s/sqrt(s)", 1.0),
        Convention("per_root_hour", _TWO_SIDED, "m/s/sqrt(h)", _ROOT_HOUR),
        Convention("one_sided", _ONE_SIDED, "ug/sqrt(Hz)", _ROOT_2 * _MICRO_G),
        Convention("density", _TWO_SIDED, "m/s^2/sqrt(Hz)", 1.0),
    ),
    ("m/s^2", "bias_instability"): (
        Convention("si", _FLICKER, "m/s^2", 1.0),
        Convention("micro_g", _FLICKER, "ug", _MICRO_G),
        Convention("floor", _FLOOR, "m/s^2", FLOOR),
        Convention("floor_micro_g", _FLOOR, "ug", FLOOR * _MICRO_G),
    ),
    ("m/s^2", "rate_random_walk"): (
        Convention("si", "acceleration random walk", "m/s^2/sqrt(s)", 1.0),
        Convention("micro_g", "acceleration random walk", "ug/sqrt(h)", _MICRO_G * _ROOT_HOUR),
        Convention("density", "acceleration random walk", "m/s^3/sqrt(Hz)", 1.0),
    ),
    ("m/s^2", "rate_ramp"): (Convention("si", "acceleration ramp", "m/s^3", 1.0),),
}


def unit_of(term: str, unit: str) -> str:
    """Return the unit of a coefficient of a record in `unit`; any unit will do, e.g. ``"code"``."""
    known = CONVENTIONS.get((unit, term))
    if known is not None:
        return known[0].unit
    suffix = {
        "quantization": " s",
        "random_walk": "/sqrt(Hz)",
        "bias_instability": "",
        "rate_random_walk": "/sqrt(s)",
        "rate_ramp": "/s",
    }
    return unit + suffix[term]


def conventions(term: str, unit: str) -> tuple[Convention, ...]:
    """Return the ways to quote a coefficient of a record in `unit`, its own unit first."""
    known = CONVENTIONS.get((unit, term))
    if known is not None:
        return known
    own = Convention("si", term.replace("_", " "), unit_of(term, unit), 1.0)
    extra = {
        "random_walk": Convention("one_sided", _ONE_SIDED, unit_of(term, unit), _ROOT_2),
        "bias_instability": Convention("floor", _FLOOR, unit, FLOOR),
    }
    return (own, extra[term]) if term in extra else (own,)
