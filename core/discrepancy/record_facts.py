"""Faults of the data of a record, found sample by sample and stated as facts.

Each test is exact or nearly so: its probability in sound data is far below any threshold of the
search. Samples that are at fault are left out of what follows.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from core.allan.faults import Tally
from core.arrays import BoolArray, FloatArray, IntArray, frozen_int
from core.discrepancy.record_problem import Samples
from core.discrepancy.result import Fitted

CHANCE = 1e-5
"""Probability in sound data below which something is a fact."""
_TREND = 64
_CLIP = 16.0
_WINDOWS = (32, 128, 512, 2048, 8192)
_FEWEST_WINDOWS = 12
_BURST, _BURST_RATIO = 7.0, 1.4
_AROUND, _EXPECTED, _EMPTY = 4, 8.0, 30.0
_FEWEST_CODES = 16
_SIXTEENTH = 16.0


@dataclass(frozen=True, slots=True, eq=False)
class Fact:
    """One fault of the data.

    Parameters
    ----------
    effect : identifier in the catalogue
    text : what was found, in words
    parameters : how many, where, how large
    chance : probability in sound data, at most
    rows : samples that are at fault
    """

    effect: str
    text: str
    parameters: tuple[Fitted, ...]
    chance: float
    rows: IntArray


def facts_of(samples: Samples) -> tuple[Fact, ...]:
    """Return all faults of the data of one output."""
    found = [*_dropouts(samples), *_stuck(samples), *_clipped(samples), *_missing_codes(samples)]
    stuck = [row for fact in found for row in fact.rows.tolist()]
    rest = samples.without(frozen_int(stuck))
    bursts = list(_bursts(rest))
    for fact in bursts:
        rest = rest.without(fact.rows)
    return (*found, *bursts, *_outliers(rest), *_stale(samples))


def _number(name: str, value: float, unit: str = "") -> Fitted:
    return Fitted(name, float(value), math.nan, unit)


def _none() -> IntArray:
    return np.zeros(0, dtype=np.int64)


def _dropouts(samples: Samples) -> Iterator[Fact]:
    steps = np.diff(samples.place)
    lost = int(np.sum(np.maximum(steps - 1, 0))) + int(np.sum(~np.isfinite(samples.y)))
    if not lost:
        return
    longest = float(steps.max() - 1) / samples.rate
    first = float(samples.run.t_s[int(np.argmax(steps > 1))])
    yield Fact(
        "dropouts",
        f"{lost} of {int(samples.place[-1]) + 1} samples never came, in {int(np.sum(steps > 1))}"
        f" gaps of up to {longest:.4g} s",
        (
            _number("lost", lost),
            _number("gaps", float(np.sum(steps > 1))),
            _number("longest", longest, "s"),
            _number("first", first, "s"),
        ),
        0.0,
        _none(),
    )


def _runs(values: FloatArray) -> tuple[IntArray, IntArray]:
    """First place and length of every run of equal values."""
    ends = np.flatnonzero(np.diff(values) != 0.0)
    first = np.concatenate([[0], ends + 1])
    return first, np.diff(np.concatenate([first, [len(values)]]))


def _longest_by_chance(length: IntArray, n: int) -> float:
    """Longest run of equal neighbours that chance alone gives, from the short runs."""
    typical = np.minimum(length, np.quantile(length, 0.999))
    share = 1.0 - len(length) / float(typical.sum())
    if share <= 0.0:
        share = 1.0 / n
    return 2.0 + math.log(n / CHANCE) / -math.log(share)


def _stuck(samples: Samples) -> Iterator[Fact]:
    rows = samples.usable
    first, length = _runs(samples.y[rows])
    long = length > _longest_by_chance(length, len(rows))
    if not np.any(long):
        return
    own = np.concatenate(
        [rows[a + 1 : a + b] for a, b in zip(first[long], length[long], strict=True)]
    )
    at = float(samples.run.t_s[rows[first[long][0]]])
    yield Fact(
        "stuck_reading",
        f"{int(length[long].max())} samples in succession are equal to the last bit, from"
        f" {at:.6g} s on",
        (
            _number("samples", float(length[long].max())),
            _number("places", float(long.sum())),
            _number("from", at, "s"),
        ),
        CHANCE,
        frozen_int(own),
    )


def _clipped(samples: Samples) -> Iterator[Fact]:
    values = samples.y[samples.usable]
    tally = Tally()
    tally.add(values)
    stretches = frozen_int([[0, len(values)]])
    for note in tally.notes(values, stretches):
        if note.subject == "clipped":
            yield Fact("clipping", note.text, (), CHANCE, _none())
            return


def _missing_codes(samples: Samples) -> Iterator[Fact]:
    values = samples.y[samples.usable]
    distinct = np.unique(values)
    if not _FEWEST_CODES <= len(distinct) < len(values):
        return
    bit = float(np.min(np.diff(distinct)))
    code = (values - distinct[0]) / bit
    if float(np.max(np.abs(code - np.rint(code)))) > 0.1 or code.max() > len(values):
        return
    count = np.bincount(np.rint(code).astype(np.int64)).astype(np.float64)
    window = np.ones(2 * _AROUND + 1)
    window[_AROUND] = 0.0
    expected = np.convolve(count, window, "same") / window.sum()
    empty = (count == 0.0) & (expected >= _EXPECTED)
    surprise = float(expected[empty].sum())
    if surprise < _EMPTY:
        return
    yield Fact(
        "missing_codes",
        f"{int(empty.sum())} codes of {bit:.4g} {samples.run.unit} never occur, where about"
        f" {expected[empty].mean():.0f} samples each were to be expected",
        (_number("codes", float(empty.sum())), _number("bit", bit, samples.run.unit)),
        math.exp(-min(surprise, 700.0)),
        _none(),
    )


def departures(samples: Samples) -> FloatArray:
    """(m,) usable samples less their trend, in units of their robust standard deviation."""
    y = samples.y[samples.usable]
    blocks = max(len(y) // _TREND, 3)
    parts = np.array_split(y, blocks)
    centre = np.cumsum([len(part) for part in parts]) - [0.5 * len(part) for part in parts]
    middle = np.array([np.median(part) for part in parts])
    # The outer half blocks go on as the trend goes there.
    first = middle[0] - 0.5 * (middle[1] - middle[0])
    last = middle[-1] + 0.5 * (middle[-1] - middle[-2])
    knots = np.concatenate([[0.0], centre, [float(len(y))]])
    trend = np.interp(np.arange(len(y)) + 0.5, knots, np.concatenate([[first], middle, [last]]))
    rest = y - trend
    scale = 1.4826 * float(np.median(np.abs(rest)))
    return rest / scale if scale > 0.0 else np.zeros_like(rest)


def loudest(size: int, windows: int) -> float:
    """Mean square of so many samples of unit noise that the loudest window hardly ever exceeds.

    The quantile of chi-square after Wilson and Hilferty (1931).
    """
    z = NormalDist().inv_cdf(1.0 - CHANCE / windows)
    part = 2.0 / (9.0 * size)
    return (1.0 - part + z * math.sqrt(part)) ** 3


def _bursts(samples: Samples) -> Iterator[Fact]:
    rest = departures(samples)
    power = np.minimum(rest**2, _CLIP)
    noisy: BoolArray = np.zeros(len(rest), dtype=np.bool_)
    for size in _WINDOWS:
        for start in (0, size // 2):
            count = (len(rest) - start) // size
            if count < _FEWEST_WINDOWS:
                continue
            means = power[start : start + count * size].reshape(count, size).mean(axis=1)
            middle = float(np.median(means))
            spread = 1.4826 * float(np.median(np.abs(means - middle)))
            least = max(loudest(size, count), _BURST_RATIO**2) * middle
            loud = means > np.maximum(middle + _BURST * spread, least)
            noisy[start : start + count * size] |= np.repeat(loud, size)
    if not np.any(noisy) or float(noisy.mean()) > 0.5:
        return
    rows = samples.usable[noisy]
    t = samples.run.t_s
    ratio = float(np.std(rest[noisy]) / np.std(rest[~noisy]))
    if ratio < _BURST_RATIO:
        return
    edges = np.flatnonzero(np.diff(noisy.astype(np.int64), prepend=0) == 1)
    yield Fact(
        "variance_burst",
        f"the scatter is {ratio:.2g} times as large as elsewhere in {len(edges)} stretches, the"
        f" first from {t[rows[0]]:.6g} s on",
        (
            _number("ratio", ratio),
            _number("stretches", float(len(edges))),
            _number("from", float(t[rows[0]]), "s"),
            _number("length", float(len(rows)) / samples.rate, "s"),
        ),
        CHANCE,
        frozen_int(rows),
    )


def _outliers(samples: Samples) -> Iterator[Fact]:
    rest = departures(samples)
    # Two-sided limit of a normal distribution that n samples exceed with a small chance.
    limit = math.sqrt(2.0 * math.log(len(rest) / CHANCE))
    far = np.flatnonzero(np.abs(rest) > limit)
    if not len(far) or len(far) > 0.01 * len(rest):
        return
    rows = samples.usable[far]
    worst = int(far[np.argmax(np.abs(rest[far]))])
    row = int(samples.usable[worst])
    yield Fact(
        "outlier",
        f"{len(far)} samples lie off, the farthest by {rest[worst]:+.1f} sigma at"
        f" {samples.run.t_s[row]:.6g} s",
        (
            _number("samples", float(len(far))),
            _number("row", float(row + 1)),
            _number("at", float(samples.run.t_s[row]), "s"),
            _number("sigmas", float(rest[worst])),
        ),
        CHANCE,
        frozen_int(rows),
    )


def _stale(samples: Samples) -> Iterator[Fact]:
    warm = samples.run.temperature_c
    rows = np.flatnonzero(np.isfinite(warm))
    if len(rows) < 0.5 * len(warm):
        return
    first, length = _runs(warm[rows])
    longest = int(np.argmax(length))
    if len(length) == 1:
        # A coarse thermometer may well stand still; one that shows thousandths may not.
        fine = float(warm[rows[0]]) * _SIXTEENTH
        if abs(fine - round(fine)) < 1e-9 or abs(10.0 * fine / _SIXTEENTH % 1.0) < 1e-9:
            return
    elif length[longest] <= 10.0 * _longest_by_chance(length, len(rows)):
        return
    at, value = float(samples.run.t_s[rows[first[longest]]]), float(warm[rows[first[longest]]])
    yield Fact(
        "stale_temperature",
        f"the temperature is {value:g} degC to the last bit in {int(length[longest])} samples in"
        f" succession from {at:.6g} s on",
        (
            _number("samples", float(length[longest])),
            _number("from", at, "s"),
            _number("temperature", value, "degC"),
        ),
        CHANCE,
        _none(),
    )
