"""Block means of turn-ons, aligned at the start, averaged over each temperature."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FitError, Note, Severity
from core.procedures.drift.turn_on import TurnOn, check_turn_ons, with_ambients

_FEWEST_BLOCKS = 8
_WARM_C = 1.0
_WARM_SPREADS = 6.0


@dataclass(frozen=True, slots=True)
class Alignment:
    """How a turn-on is brought to zero at its start.

    Parameters
    ----------
    start_s, stop_s : the mean over this time is subtracted
    u : standard uncertainty of that mean, from the noise of the samples, output unit; every
        correction carries it, in the calibration and again in use
    """

    start_s: float
    stop_s: float
    u: float


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """What is left of all turn-ons.

    Parameters
    ----------
    t : (k,) middles of the blocks after the alignment, s
    y : (r, k) block means of every turn-on less its start
    place : (r,) row of `temperatures_c` that a turn-on belongs to
    labels : (r,) names of the turn-ons
    start_c : (r,) chip temperature at the start
    chip_c : (m, k) mean chip temperature of each set during the blocks; NaN if it is not measured
    temperatures_c : (m,) ascending: mean chip temperature at the start, or the chamber's
    alignment : how the starts were brought to zero
    horizon_s : end of the last block, s
    notes : turn-ons that were left out, and other doubts
    """

    t: FloatArray
    y: FloatArray
    place: IntArray
    labels: tuple[str, ...]
    start_c: FloatArray
    chip_c: FloatArray
    temperatures_c: FloatArray
    alignment: Alignment
    horizon_s: float
    notes: tuple[Note, ...]

    @property
    def mean(self) -> FloatArray:
        """Mean curve (m, k) of each temperature."""
        return self.mean_without(-1)

    @property
    def counts(self) -> IntArray:
        """Turn-ons (m,) at each temperature."""
        return np.bincount(self.place, minlength=len(self.temperatures_c)).astype(np.int64)

    @property
    def ranks(self) -> IntArray:
        """Which turn-on of its temperature each row (r,) is, from 0."""
        ranks = np.zeros_like(self.place)
        for at in range(len(self.temperatures_c)):
            chosen = self.place == at
            ranks[chosen] = np.arange(int(chosen.sum()))
        return ranks

    def mean_without(self, rank: int) -> FloatArray:
        """Mean curve (m, k) without the turn-on of this rank where there are others."""
        kept = self.ranks != rank
        lonely = np.bincount(self.place[kept], minlength=len(self.temperatures_c)) == 0
        kept |= lonely[self.place]
        sums = np.zeros((len(self.temperatures_c), len(self.t)))
        np.add.at(sums, self.place[kept], self.y[kept])
        counts = np.bincount(self.place[kept], minlength=len(self.temperatures_c))
        return sums / counts[:, None]


def curves_of(
    turn_ons: Sequence[TurnOn],
    *,
    window_s: tuple[float, float] = (1.5, 2.0),
    block_s: float = 1.0,
    horizon_s: float = np.nan,
) -> Curves:
    """Average turn-ons over blocks, after subtracting the mean over the start window.

    Parameters
    ----------
    turn_ons : in any order; turn-ons of one temperature have the same `ambient_c`,
        or none, and then those that began alike are one set
    window_s : start and end of the alignment; the compensation works from its end on
    block_s : length of a block, long against the noise and short against a bend
    horizon_s : how long the compensation shall work; NaN takes the common length

    Raises
    ------
    FitError
        As `check_turn_ons`; or the window or the blocks do not fit the records.
    """
    turn_ons = with_ambients(turn_ons)
    horizon_s = check_turn_ons(turn_ons, horizon_s)
    start, stop = window_s
    per_block = round(turn_ons[0].rate * block_s)
    latest = max(one.start_s for one in turn_ons)
    if not latest <= start < stop or round((stop - start) * turn_ons[0].rate) < 1:
        raise FitError(
            f"the start window {start:g} ... {stop:g} s holds no samples: the records begin at"
            f" {latest:g} s"
        )
    blocks = int((horizon_s - stop) / block_s + 1e-6)
    if per_block < 1 or blocks < _FEWEST_BLOCKS:
        raise FitError(
            f"{max(blocks, 0)} blocks of {block_s:g} s between {stop:g} s and {horizon_s:g} s; at"
            f" least {_FEWEST_BLOCKS} are needed, with one sample each"
        )
    kept, notes = _cold(turn_ons, window_s)
    rows: list[FloatArray] = []
    warmth: list[FloatArray] = []
    for one in kept:
        first = one.within(stop, stop).start
        used = slice(first, first + blocks * per_block)
        means = one.y[used].reshape(blocks, per_block).mean(axis=1)
        rows.append(means - one.y[one.within(start, stop)].mean())
        warmth.append(one.temperature_c[used].reshape(blocks, per_block).mean(axis=1))
    start_c = np.array([_start_temperature(one, window_s) for one in kept])
    ambients, place = np.unique([one.ambient_c for one in kept], return_inverse=True)
    temperatures, doubts = _abscissas(ambients, place, start_c)
    y, warm = np.array(rows), np.array(warmth)
    return Curves(
        t=frozen(stop + block_s * (np.arange(blocks) + 0.5)),
        y=frozen(y),
        place=frozen_int(place),
        labels=tuple(one.label for one in kept),
        start_c=frozen(start_c),
        chip_c=frozen([warm[place == at].mean(axis=0) for at in range(len(ambients))]),
        temperatures_c=frozen(temperatures),
        alignment=Alignment(start, stop, _alignment_u(kept, window_s)),
        horizon_s=stop + blocks * block_s,
        notes=(*notes, *doubts),
    )


def _start_temperature(one: TurnOn, window_s: tuple[float, float]) -> float:
    return float(one.temperature_c[one.within(*window_s)].mean())


def _alignment_u(turn_ons: Sequence[TurnOn], window_s: tuple[float, float]) -> float:
    """Standard uncertainty of a mean over the window, by the noise there.

    Differences of neighbouring tenths of the window are blind to drift; a tenth averages over
    the memory of a filter that is short against it.
    """
    squares: list[float] = []
    for one in turn_ons:
        window = one.y[one.within(*window_s)]
        parts = min(10, len(window))
        if parts < 2:
            return float("nan")
        means: FloatArray = window[: len(window) // parts * parts].reshape(parts, -1).mean(axis=1)
        squares.append(float(np.mean(np.diff(means) ** 2)) / 2.0 / parts)
    return float(np.sqrt(np.mean(squares)))


def _cold(
    turn_ons: Sequence[TurnOn], window_s: tuple[float, float]
) -> tuple[list[TurnOn], list[Note]]:
    """The turn-ons that began as cold as the others of their set."""
    kept: list[TurnOn] = []
    notes: list[Note] = []
    for ambient in dict.fromkeys(one.ambient_c for one in turn_ons):
        group = [one for one in turn_ons if one.ambient_c == ambient]
        starts = np.array([_start_temperature(one, window_s) for one in group])
        middle = float(np.median(starts))
        limit = max(_WARM_C, _WARM_SPREADS * float(np.median(np.abs(starts - middle))))
        for one, start in zip(group, starts, strict=True):
            if len(group) > 2 and start - middle > limit:
                notes.append(
                    Note(
                        Severity.WARNING,
                        "warm_start",
                        f"{one.label} began at {start:.1f} degC, the others of its set at"
                        f" {middle:.1f} degC: it had not cooled down and was left out; wait longer"
                        " between turn-ons (source 003 advises at least 5 minutes)",
                    )
                )
            else:
                kept.append(one)
    return kept, notes


def _abscissas(
    ambients: FloatArray, place: IntArray, start_c: FloatArray
) -> tuple[FloatArray, list[Note]]:
    """Temperatures (m,) by which the table is entered."""
    notes: list[Note] = []
    chip = np.array([start_c[place == at].mean() for at in range(len(ambients))])
    if not np.all(np.isfinite(chip)):
        notes.append(
            Note(
                Severity.WARNING,
                "no_chip_temperature",
                "the chip's temperature was not measured; the table is entered by the temperature"
                " of the chamber, which the unit does not know in use",
            )
        )
        chip = ambients
    elif np.any(np.diff(chip) <= 0):
        raise FitError(
            "the chip's temperature at the start does not rise with that of the chamber:"
            f" {', '.join(f'{value:.1f}' for value in chip)} degC; are sets mislabelled?"
        )
    if len(ambients) == 1:
        notes.append(
            Note(
                Severity.WARNING,
                "one_temperature",
                f"all turn-ons were made at {chip[0]:.1f} degC: the table holds at this"
                " temperature only",
            )
        )
    return chip, notes
