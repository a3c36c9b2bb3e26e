"""Overlapping Allan deviation of a whole record of uniformly sampled rate.

sigma^2(m) = sum over k of (x[k+2m] - 2 x[k+m] + x[k])^2 / (2 (m dt)^2 (n + 1 - 2m)), x the phase:
the running sum of (rate - mean) dt. Two algorithms:

* exact: the record is walked in blocks that stay in the cache and all taus are served from a block
  before the next is read; the result equals the plain sum over the whole record.
* equivalent: partial overlap, one start in m/16 to m/32, by the multi-tau accumulator. Its factors
  are rounded to 1/32; the degrees of freedom are those of full overlap within 1 %, the memory is
  that of a chunk.

The mean is taken off before the sum (with it, 24-bit codes lose the fourth digit over a day);
whole-number codes are summed without any rounding.
"""

import math

import numpy as np
from numpy.typing import NDArray

from core.allan.confidence import ONE_SIGMA
from core.allan.curve import AllanCurve, make_curve
from core.allan.faults import Record, chunks
from core.allan.record import GapPolicy, Survey, survey
from core.allan.squares import sum_of_squares
from core.allan.streaming import Accumulator
from core.allan.taus import averaging_factors, quantised
from core.arrays import FloatArray, IntArray
from core.errors import FitError

Phase = NDArray[np.float64] | NDArray[np.int64]

BLOCK = 32768
SHORT = 16384
"""Up to this factor the first differences of a block are shared between the two ends of it."""
EXACT_FLOAT = 2.0**51
"""Phases of whole numbers up to here leave second differences exact in float64."""
EXACT_INT = 2.0**61


def overlapping(
    values: Record,
    rate: float,
    *,
    m: IntArray | None = None,
    mode: str = "exact",
    gaps: GapPolicy = "refuse",
    index: IntArray | None = None,
    level: float = ONE_SIGMA,
) -> AllanCurve:
    """Return the overlapping Allan deviation of a rate record.

    Parameters
    ----------
    values : (n,) rate samples (not phase, not angle) in any unit and any real type; a memory map is
        read in chunks
    rate : samples per second
    m : (t,) averaging factors, increasing; 100 log-spaced ones to n/3 unless given
    mode : ``"exact"`` or ``"equivalent"``
    gaps : what to do with samples that are not finite or jumps of `index`
    index : (n,) sample numbers by the device's counter, where there are any
    level : confidence level of the limits

    Returns
    -------
    AllanCurve

    Raises
    ------
    FitError
        Record too short, with gaps that are not allowed, all samples equal, or a factor above n/3.
    """
    if not (np.isfinite(rate) and rate > 0.0):
        raise ValueError(f"the sampling rate must be positive, not {rate}")
    found = survey(values, index, gaps)
    start, stop = found.longest
    longest = stop - start
    factors = averaging_factors(longest) if m is None else m
    if int(factors[-1]) > longest // 3:
        raise FitError(
            f"tau = {factors[-1] / rate:.6g} s needs {3 * int(factors[-1])} samples without a gap, "
            f"there are {longest}: beyond a third of the record a point means nothing"
        )
    return curve_of(values, found, factors, rate, mode, level)


def curve_of(
    values: Record,
    found: Survey,
    m: IntArray,
    rate: float,
    mode: str,
    level: float = ONE_SIGMA,
) -> AllanCurve:
    """Return the curve of a record that was surveyed already; see `overlapping`."""
    factors = quantised(m) if mode == "equivalent" else m
    variance, pairs = ALGORITHMS[mode](values, found, factors)
    if not np.all(variance > 0.0):
        raise FitError(
            f"the Allan deviation at tau = {factors[int(np.argmin(variance))] / rate:.6g} s is "
            "zero: the samples repeat exactly (a synthetic or stuck record)"
        )
    return make_curve(
        factors,
        variance,
        pairs,
        n=found.n,
        rate=rate,
        mode=mode,
        notes=found.notes,
        level=level,
    )


def _exact(values: Record, found: Survey, m: IntArray) -> tuple[FloatArray, IntArray]:
    sums = np.zeros(len(m))
    pairs = np.zeros(len(m), dtype=np.int64)
    for start, stop in found.stretches.tolist():
        # One stretch at a time: its phase is freed before the next is built.
        sums += _sums(_phase(values, found, start, stop), m)
        pairs += np.maximum(stop - start + 1 - 2 * m, 0)
    return sums / (2.0 * m.astype(np.float64) ** 2 * pairs), pairs


def _equivalent(values: Record, found: Survey, m: IntArray) -> tuple[FloatArray, IntArray]:
    offset = round(found.mean) if found.integral else found.mean
    accumulator = Accumulator(m)
    for start, stop in found.stretches.tolist():
        for _, chunk in chunks(values, start, stop):
            accumulator.push(chunk - offset)
        accumulator.cut()
    return accumulator.variance()


ALGORITHMS = {"exact": _exact, "equivalent": _equivalent}


def _phase(values: Record, found: Survey, start: int, stop: int) -> Phase:
    """Return the (stop - start + 1,) running sum of samples less their mean, from 0."""
    reach = max(found.highest - found.mean, found.mean - found.lowest) + 1.0
    bound = reach * (stop - start)
    if found.integral and EXACT_FLOAT <= bound < EXACT_INT:
        return _whole_phase(values, round(found.mean), start, stop)
    offset = round(found.mean) if found.integral and bound < EXACT_FLOAT else found.mean
    phase = np.empty(stop - start + 1)
    phase[0] = carry = 0.0
    for at, chunk in chunks(values, start, stop):
        centred = chunk - offset
        centred[0] += carry
        part = phase[at - start + 1 : at - start + 1 + len(centred)]
        np.cumsum(centred, out=part)
        carry = float(part[-1])
    return phase


def _whole_phase(values: Record, offset: int, start: int, stop: int) -> NDArray[np.int64]:
    """Return the phase of codes too large for exact float64 sums, in int64."""
    phase = np.empty(stop - start + 1, dtype=np.int64)
    phase[0] = carry = 0
    for at in range(start, stop, BLOCK):
        centred = np.asarray(values[at : min(at + BLOCK, stop)]).astype(np.int64) - offset
        centred[0] += carry
        part = phase[at - start + 1 : at - start + 1 + len(centred)]
        np.cumsum(centred, out=part)
        carry = int(part[-1])
    return phase


def _sums(phase: Phase, m: IntArray) -> FloatArray:
    """Return (t,) sums of squared second differences of `phase`, in blocks, all taus a block."""
    factors: list[int] = m.tolist()
    sums = [0.0] * len(factors)
    points = len(phase)
    first = np.empty(BLOCK + SHORT, dtype=phase.dtype)
    square = np.empty(BLOCK)
    # Whole numbers are subtracted as such before they become float; floats need no third buffer,
    # and what stays in the cache is what the speed is made of.
    latest = square if phase.dtype == np.float64 else np.empty(BLOCK, dtype=phase.dtype)
    for k in range(0, points - 2 * factors[0], BLOCK):
        for place, step in enumerate(factors):
            length = min(BLOCK, points - 2 * step - k)
            if length <= 0:
                break
            second = square[:length]
            if step <= SHORT:
                d = first[: length + step]
                np.subtract(
                    phase[k + step : k + length + 2 * step], phase[k : k + length + step], d
                )
                np.subtract(d[step:], d[:length], second)
            else:
                middle = phase[k + step : k + step + length]
                late, early = latest[:length], first[:length]
                np.subtract(phase[k + 2 * step : k + 2 * step + length], middle, late)
                np.subtract(middle, phase[k : k + length], early)
                np.subtract(late, early, second)
            sums[place] += sum_of_squares(second)
    return np.array(sums)


def variance_of_phase(phase: FloatArray, m: IntArray, rate: float = 1.0) -> FloatArray:
    """Return the overlapping Allan variance of phase data at any factor up to half its length.

    Parameters
    ----------
    phase : (n + 1,) integral of the rate: unit of the rate times s
    m : (t,) averaging factors, increasing
    rate : samples per second
    """
    taus = m / rate
    return _sums(phase, m) / (2.0 * taus**2 * (len(phase) - 2 * m))


def nonoverlapping(values: Record, m: IntArray) -> FloatArray:
    """Return the (t,) Allan deviation of adjacent groups of `m` samples, as (6.2) is printed.

    Parameters
    ----------
    values : (n,) rate samples
    m : (t,) group lengths, each at most n/2

    Notes
    -----
    It uses one start in m: for comparison with tables only, its scatter is larger than that of
    `overlapping`.
    """
    result = np.empty(len(m))
    centred = np.asarray(values, dtype=np.float64)
    centred = centred - centred.mean()
    for place, size in enumerate(m.tolist()):
        groups = centred[: len(centred) // size * size].reshape(-1, size).mean(axis=1)
        steps = groups[1:] - groups[:-1]
        result[place] = math.sqrt(0.5 * float(steps.dot(steps)) / len(steps))
    return result
