"""Hadamard, modified and total deviations, by the optional library AllanTools.

They answer questions the Allan deviation cannot: the Hadamard deviation is blind to a steady ramp,
the modified one tells white from flicker phase noise of angle outputs, the total one scatters less
at the longest taus. See docs/decisions/0010.
"""

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType

import numpy as np

from core.allan.confidence import ONE_SIGMA, interval, noise_types
from core.allan.curve import AllanCurve
from core.allan.faults import Record
from core.allan.record import GapPolicy, survey
from core.allan.taus import averaging_factors
from core.arrays import IntArray, frozen, frozen_int
from core.errors import FitError

MOST = 10_000_000
"""Samples above which the library's temporary arrays take gigabytes."""
ALPHA = {
    "quantization": 2,
    "random_walk": 0,
    "bias_instability": -1,
    "rate_random_walk": -2,
    "rate_ramp": -2,
}
"""Power law of each term in the frequency standards' numbering."""


@dataclass(frozen=True, slots=True)
class Kind:
    """One deviation.

    Parameters
    ----------
    function : its name in the library
    reach : samples a difference spans, in averaging factors
    edf : (library, alpha, m, n) -> degrees of freedom
    """

    function: str
    reach: int
    edf: Callable[[ModuleType, int, int, int], float]


def _hadamard(library: ModuleType, alpha: int, m: int, n: int) -> float:
    return float(library.edf_greenhall(alpha, 3, m, n + 1, overlapping=True, modified=False))


def _modified(library: ModuleType, alpha: int, m: int, n: int) -> float:
    return float(library.edf_greenhall(alpha, 2, m, n + 1, overlapping=True, modified=True))


def _total(library: ModuleType, alpha: int, m: int, n: int) -> float:
    # Its formula is for white, flicker and random walk; steeper in tau than that is white here.
    return float(library.edf_totdev(n + 1, m, min(alpha, 0)))


KINDS = {
    "hadamard": Kind("ohdev", 3, _hadamard),
    "modified": Kind("mdev", 3, _modified),
    "total": Kind("totdev", 2, _total),
}


def other_deviation(
    values: Record,
    rate: float,
    kind: str,
    *,
    count: int = 60,
    gaps: GapPolicy = "longest",
    index: IntArray | None = None,
    level: float = ONE_SIGMA,
) -> AllanCurve:
    """Return another deviation of a rate record as a curve whose `mode` names it.

    Parameters
    ----------
    values : (n,) rate samples
    rate : samples per second
    kind : key of KINDS
    count : log-spaced taus, to a quarter of the record
    gaps : ``"refuse"`` or ``"longest"``
    index : (n,) sample numbers by the device's counter, where there are any
    level : confidence level of the limits; the degrees of freedom are within 15 % from m = 10 on

    Raises
    ------
    FitError
        The library is not installed, or the record cannot be used.
    """
    if gaps == "stretches":
        raise ValueError("these deviations need one stretch without gaps: choose 'longest'")
    chosen = KINDS[kind]
    library = _library()
    found = survey(values, index, gaps)
    start, stop = found.longest
    n = stop - start
    if n > MOST:
        raise FitError(
            f"the {kind} deviation is offered up to {MOST} samples, the record has {n}: average "
            "neighbouring samples first"
        )
    m = averaging_factors(n, count=count)
    m = m[m <= n // (chosen.reach + 1)]
    samples = np.asarray(values[start:stop], dtype=np.float64)
    _, deviation, _, pairs = getattr(library, chosen.function)(
        samples - samples.mean(), rate=rate, data_type="freq", taus=m / rate
    )
    deviation = frozen(deviation)
    types = noise_types(m / rate, deviation, m, n)
    edf = np.array(
        [
            chosen.edf(library, ALPHA[name], one, n)
            for name, one in zip(types, m.tolist(), strict=True)
        ]
    )
    lower, upper = interval(deviation, edf, level)
    return AllanCurve(
        taus=frozen(m / rate),
        deviation=deviation,
        m=frozen_int(m),
        edf=frozen(edf),
        lower=lower,
        upper=upper,
        n=n,
        rate=rate,
        mode=kind,
        notes=found.notes,
        pairs=frozen_int(pairs),
        level=level,
    )


def _library() -> ModuleType:
    try:
        return importlib.import_module("allantools")
    except ImportError as error:
        raise FitError(
            "Hadamard, modified and total deviations need the optional package AllanTools: "
            'pip install "calrig[allan]"'
        ) from error
