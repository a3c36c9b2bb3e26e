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

import numpy as np

from core.arrays import IntArray
from drivers.events import Event, Lost, Message

_VOTES = 4
_MOST_VOTES = 16
_AGREEING = 16
_CERTAIN_BITS = 16


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
        self._votes: Counter[int] = Counter()
        self._other = 0
        self._agreeing = 0

    def number(self, counts: IntArray | None, losses: IntArray) -> tuple[IntArray, list[Event]]:
        """Return the sample numbers of the next frames.

        Parameters
        ----------
        counts : (n,) counter of each frame, -1 where a frame has none; None where none has
        losses : (n,) samples that the garbage before each frame may have been

        Returns
        -------
        index : (n,) int64, strictly increasing over all calls
        events : `Lost`, and a `Message` for each restart of the counter
        """
        if counts is None or not self._bits:
            steps = 1 + losses
            if self._next == 0:
                steps[0] = 1
        else:
            regular = self._regular(counts)
            if regular is None:
                return self._number_slowly(counts, losses)
            steps = regular
        index = self._next - 1 + np.cumsum(steps)
        events: list[Event] = [
            Lost(int(steps[position]) - 1, int(index[position]))
            for position in np.flatnonzero(steps > 1).tolist()
        ]
        self._next = int(index[-1]) + 1
        return index, events

    def settle(self, step: int) -> None:
        """Take over a step that the device has told."""
        self._given = self.step = step

    def _regular(self, counts: IntArray) -> IntArray | None:
        """Return ones if all frames follow each other by the known step, else None."""
        if not self.step or self._last < 0 or counts.min() < 0:
            return None
        before = np.concatenate(([self._last], counts[:-1]))
        ratios = np.rint((counts - before) % self._modulus / self.step)
        if not bool(np.all(ratios == 1)):
            return None
        self._last = int(counts[-1])
        self._agreeing = 0
        return np.ones(len(counts), dtype=np.int64)

    def _number_slowly(self, counts: IntArray, losses: IntArray) -> tuple[IntArray, list[Event]]:
        index: list[int] = []
        events: list[Event] = []
        for count, loss in zip(counts.tolist(), losses.tolist(), strict=True):
            step = 1
            if count < 0 or not self.step:
                step += loss if self._next else 0
            if count >= 0:
                if self._last >= 0:
                    step = self._advance(count, step, events)
                self._last = count
            if step > 1:
                events.append(Lost(step - 1, self._next + step - 1))
            index.append(self._next + step - 1)
            self._next = index[-1] + 1
        return np.array(index, dtype=np.int64), events

    def _advance(self, count: int, guess: int, events: list[Event]) -> int:
        """Return by how many samples a frame follows the one before."""
        change = (count - self._last) % self._modulus
        if not self.step:
            self._learn(change)
            return guess
        if self._bits > _CERTAIN_BITS and change > self._modulus // 2:
            fields = {"from": str(self._last), "to": str(count)}
            events.append(Message("counter restarted", b"", fields))
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
