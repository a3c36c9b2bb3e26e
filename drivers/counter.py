"""Sample numbers from the device's own counter.

The counter is the time axis, so what it says must not depend on how the bytes arrived. Frames are
therefore numbered one after another by a rule without look-ahead:

* The step of a sample is given by the profile, or it is the first difference that was met four
  times (of 16 at most, then the commonest). Until it is known each frame counts as the next one.
* Then a difference of k steps, rounded, is k samples: k - 1 were lost. A counter of more than 16
  bits that jumps back was restarted, which is no loss.
* A step that was learned wrong, or changed by a command, is learned again when 16 frames in a row
  agree on another one.

Without a counter the garbage between two frames tells: each started half frame of it is one lost
sample. Bytes that vanished without a trace, in whole frames, cannot be seen then.
"""

from collections import Counter
from operator import itemgetter

import numpy as np

from core.arrays import IntArray
from drivers.events import Lost, Message

_VOTES = 4
_MOST_VOTES = 16
_AGREEING = 16
_CERTAIN_BITS = 16

Said = tuple[int, Lost | Message]


class SampleCounter:
    """Numbers samples.

    Parameters
    ----------
    bits : width of the device's counter; 0 where it has none
    step : counts a sample; None to learn it
    """

    def __init__(self, bits: int = 0, step: int | None = None) -> None:
        self._modulus = 1 << bits
        self._bits = bits
        self._given = step
        self.step = step or 0
        """Counts a sample; 0 while unknown."""
        self._next = 0
        self._last = -1
        self._since = 0
        """Samples without a counter since the last one with it."""
        self._votes: Counter[int] = Counter()
        self._other = 0
        self._agreeing = 0

    def number(self, counts: IntArray | None, losses: IntArray) -> tuple[IntArray, list[Said]]:
        """Return the sample numbers of the next frames.

        Parameters
        ----------
        counts : (n,) counter of each frame, -1 where a frame has none; None where none has
        losses : (n,) samples that the garbage before each frame may have been

        Returns
        -------
        index : (n,) int64, strictly increasing over all calls
        said : `Lost`, and a `Message` for each restart of the counter, with the frame's position
        """
        steps = np.ones(len(losses), dtype=np.int64)
        said: list[Said] = []
        if counts is None or not self._bits:
            steps += losses
            if self._next == 0:
                steps[0] = 1
        else:
            self._count(counts, losses, steps, said)
        index = self._next - 1 + np.cumsum(steps)
        said.extend(
            (position, Lost(int(steps[position]) - 1, int(index[position])))
            for position in np.flatnonzero(steps > 1).tolist()
        )
        self._next = int(index[-1]) + 1
        return index, sorted(said, key=itemgetter(0))

    def settle(self, step: int) -> None:
        """Take over a step that the device has told."""
        self._given = self.step = step

    def _count(self, counts: IntArray, losses: IntArray, steps: IntArray, said: list[Said]) -> None:
        """Set the steps by the counter."""
        at = 0
        while at < len(counts):
            if self.step and self._last >= 0 and counts[at] >= 0 and not self._since:
                at = self._stretch(counts, at, steps, said)
            else:
                loss = 0 if self._next == 0 and at == 0 else int(losses[at])
                steps[at] = self._single(int(counts[at]), loss, at, said)
                at += 1

    def _single(self, count: int, loss: int, at: int, said: list[Said]) -> int:
        """Return the step of a frame without counter, or while the step is not known."""
        step = 1 + loss if count < 0 or not self.step else 1
        if count < 0:
            self._since += step
            return step
        if self._last >= 0:
            step = max(1, self._advance(count, step + self._since, at, said) - self._since)
        self._last, self._since = count, 0
        return step

    def _stretch(self, counts: IntArray, at: int, steps: IntArray, said: list[Said]) -> int:
        """Set the steps from one frame on; return where the counter ends or its step changes."""
        missing = np.flatnonzero(counts[at:] < 0)
        end = at + int(missing[0]) if len(missing) else len(counts)
        known = self.step
        before = np.concatenate(([self._last], counts[at : end - 1]))
        regular = np.rint((counts[at:end] - before) % self._modulus / known) == 1
        previous = at - 1
        for position in (at + np.flatnonzero(~regular)).tolist():
            if position > previous + 1:
                self._agreeing = 0
            self._last = int(before[position - at])
            steps[position] = self._advance(int(counts[position]), 1, position, said)
            self._last = int(counts[position])
            previous = position
            if self.step != known:
                return position + 1
        if previous < end - 1:
            self._agreeing = 0
        self._last = int(counts[end - 1])
        return end

    def _advance(self, count: int, guess: int, at: int, said: list[Said]) -> int:
        """Return by how many samples a frame follows the one before."""
        change = (count - self._last) % self._modulus
        if not self.step:
            self._learn(change)
            return guess
        if self._bits > _CERTAIN_BITS and change > self._modulus // 2:
            fields = {"from": str(self._last), "to": str(count)}
            said.append((at, Message("counter restarted", b"", fields)))
            return 1
        ratio = max(1, round(change / self.step))
        self._doubt(change, agrees=round(change / self.step) == 1)
        return ratio

    def _learn(self, change: int) -> None:
        if change == 0:
            return
        self._votes[change] += 1
        value, votes = self._votes.most_common(1)[0]
        if votes >= _VOTES or self._votes.total() >= _MOST_VOTES:
            self.step = value
            self._votes.clear()

    def _doubt(self, change: int, *, agrees: bool) -> None:
        if agrees or change == 0 or self._given is not None:
            self._agreeing = 0
            return
        self._agreeing = self._agreeing + 1 if change == self._other else 1
        self._other = change
        if self._agreeing >= _AGREEING:
            self.step, self._agreeing = change, 0
