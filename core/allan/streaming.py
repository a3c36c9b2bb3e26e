"""Multi-tau accumulation: the Allan curve of a record that still grows, in O(log n) memory.

Level l works on sums of 2^l samples. It keeps the phase of the last 2 x 31 of them and, for each
factor of 16 to 31 sums (1 to 31 at level 0), the running sum of squared second differences. The
phase is re-based to the newest point at every step, so its digits never run out; the result does
not depend on how the samples were cut into pushes.
"""

import math

import numpy as np

from core.allan.confidence import ONE_SIGMA
from core.allan.curve import AllanCurve, make_curve
from core.allan.squares import sum_of_squares
from core.allan.taus import SHORTEST_RECORD, multitau_factors, stride_of
from core.arrays import FloatArray, IntArray
from core.errors import FitError, Note, Severity

BATCH = 256
"""Increments a level waits for before it works: numpy calls cost more than the arithmetic."""
LONGEST = 1 << 40
"""Largest averaging factor a live curve can reach."""
CHUNK = 16384


class _Level:
    """One octave of factors: `steps` increments wide each."""

    __slots__ = ("_carry", "_tail", "_waiting", "_waiting_size", "depth", "pairs", "steps", "sums")

    def __init__(self, steps: tuple[int, ...]) -> None:
        self.steps = steps
        self.depth = 2 * max(steps, default=0)
        self.sums = [0.0] * len(steps)
        self.pairs = [0] * len(steps)
        self.cut()

    def cut(self) -> None:
        """Forget the past: what follows is not contiguous with it."""
        self._tail = np.zeros(1)
        self._carry = np.empty(0)
        self._waiting: list[FloatArray] = []
        self._waiting_size = 0

    def take(self, increments: FloatArray, flush: bool) -> FloatArray | None:
        """Add increments; return the pair sums for the next level once there was work to do."""
        if len(increments):
            self._waiting.append(increments)
            self._waiting_size += len(increments)
        if self._waiting_size == 0 or (self._waiting_size < BATCH and not flush):
            return None
        fresh = self._waiting[0] if len(self._waiting) == 1 else np.concatenate(self._waiting)
        self._waiting = []
        self._waiting_size = 0
        if self.steps:
            self._work(fresh)
        if len(self._carry):
            fresh = np.concatenate((self._carry, fresh))
        even = len(fresh) & ~1
        self._carry = fresh[even:].copy()
        return fresh[0:even:2] + fresh[1:even:2]

    def _work(self, fresh: FloatArray) -> None:
        known = len(self._tail)
        phase = np.empty(known + len(fresh))
        np.subtract(self._tail, self._tail[-1], out=phase[:known])
        np.cumsum(fresh, out=phase[known:])
        for place, step in enumerate(self.steps):
            begin = max(known - 2 * step, 0)
            length = len(phase) - 2 * step - begin
            if length <= 0:
                continue
            d = phase[begin + step :] - phase[begin:-step]
            second = d[step:]
            second = second - d[:-step]
            self.sums[place] += sum_of_squares(second)
            self.pairs[place] += length
        self._tail = phase[-self.depth :].copy()


class Accumulator:
    """Sums of squared second differences for fixed factors, from samples in any portions.

    Parameters
    ----------
    m : (t,) increasing averaging factors, each a multiple of its stride (see `quantised`)
    """

    def __init__(self, m: IntArray) -> None:
        self._m = m
        self._strides = [stride_of(step) for step in m.tolist()]
        top = self._strides[-1].bit_length()
        by_level: list[list[int]] = [[] for _ in range(top)]
        for step, stride in zip(m.tolist(), self._strides, strict=True):
            if step % stride:
                raise ValueError(f"factor {step} is not a multiple of its stride {stride}")
            by_level[stride.bit_length() - 1].append(step // stride)
        self._levels = [_Level(tuple(steps)) for steps in by_level]

    def push(self, samples: FloatArray) -> None:
        """Add samples, already less any offset."""
        for at in range(0, len(samples), CHUNK):
            self._pass(samples[at : at + CHUNK], flush=False)

    def cut(self) -> None:
        """Mark a gap: no difference is taken across it."""
        self._settle()
        for level in self._levels:
            level.cut()

    def variance(self) -> tuple[FloatArray, IntArray]:
        """Return Allan variances in squared sample units, and the span of the differences.

        Both (t,), up to the largest factor that has a difference.
        """
        self._settle()
        sums = np.array([one for level in self._levels for one in level.sums])
        pairs = np.array([one for level in self._levels for one in level.pairs], dtype=np.int64)
        strides = np.array(self._strides, dtype=np.int64)
        seen = int(np.count_nonzero(pairs))
        m = self._m[:seen].astype(np.float64)
        return sums[:seen] / (2.0 * m**2 * pairs[:seen]), pairs[:seen] * strides[:seen]

    def _settle(self) -> None:
        self._pass(np.empty(0), flush=True)

    def _pass(self, increments: FloatArray, flush: bool) -> None:
        for level in self._levels:
            passed = level.take(increments, flush)
            if passed is None:
                if flush:
                    passed = np.empty(0)
                else:
                    return
            increments = passed


class LiveAllan:
    """The Allan curve of a running record.

    Parameters
    ----------
    rate : samples per second
    per_octave : factors an octave above 16

    Notes
    -----
    One push of 1000 samples takes some 0.2 ms. Feed the blocks of the reader as they come; call
    `cut` where the device's counter jumped.
    """

    def __init__(self, rate: float, per_octave: int = 4) -> None:
        if not (math.isfinite(rate) and rate > 0.0):
            raise ValueError(f"the sampling rate must be positive, not {rate}")
        self._rate = rate
        self._m = multitau_factors(LONGEST, per_octave)
        self._accumulator = Accumulator(self._m)
        self._reference: float | None = None
        self._count = 0
        self._cuts = 0

    @property
    def count(self) -> int:
        """Samples so far."""
        return self._count

    def push(self, samples: FloatArray) -> None:
        """Add samples in time order; one that is not finite is a lost sample."""
        if not len(samples):
            return
        if math.isfinite(float(np.sum(samples))):
            self._add(samples)
            return
        finite = np.isfinite(samples)
        edges = np.flatnonzero(np.diff(finite)) + 1
        for part, whole in zip(np.split(samples, edges), np.split(finite, edges), strict=True):
            if whole[0]:
                self._add(part)
            else:
                self.cut()

    def cut(self) -> None:
        """Mark lost samples: no difference is taken across them."""
        if self._count:
            self._accumulator.cut()
            self._cuts += 1

    def _add(self, samples: FloatArray) -> None:
        if self._reference is None:
            self._reference = float(samples[0])
        self._accumulator.push(np.asarray(samples, dtype=np.float64) - self._reference)
        self._count += len(samples)

    def curve(self, level: float = ONE_SIGMA) -> AllanCurve:
        """Return the curve of everything pushed so far, to a third of its length.

        Raises
        ------
        FitError
            Fewer than 9 samples so far, or all of them equal.
        """
        if self._count < SHORTEST_RECORD:
            raise FitError(f"{self._count} samples so far: an Allan curve needs {SHORTEST_RECORD}")
        variance, pairs = self._accumulator.variance()
        m = self._m[: len(variance)]
        # With m pairs the stretch (or all stretches together) holds three averages.
        seen = pairs >= m
        if not np.any(seen):
            raise FitError("no stretch without lost samples is long enough; check the link")
        m, variance, pairs = m[seen], variance[seen], pairs[seen]
        if not np.all(variance > 0.0):
            raise FitError(
                f"all {self._count} samples so far are equal: the channel is stuck or not connected"
            )
        notes: tuple[Note, ...] = ()
        if self._cuts:
            notes = (
                Note(
                    Severity.WARNING,
                    "gaps",
                    f"{self._cuts} gaps so far; no difference is taken across them",
                ),
            )
        return make_curve(
            m,
            variance,
            pairs,
            n=self._count,
            rate=self._rate,
            mode="streaming",
            notes=notes,
            level=level,
        )
