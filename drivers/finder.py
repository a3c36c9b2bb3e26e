"""Whole frames in a stream of bytes, found many at a time.

One rule decides, and it does not depend on how the stream was cut into pieces: from the end of the
last frame on, the first place where the first bytes fit, the length is possible and the checksum is
right is a frame. A place whose frame has not come to its end yet makes everything behind it wait;
so the carry is never longer than the longest frame, and no sync is trusted for being the first.

Two ways lead to that one result. Behind a frame the next ones are taken to follow at the same
distance and are checked as one matrix (`_run`); where that ends, all places of a window that look
like a beginning are checked together (`_search`).
"""

from dataclasses import dataclass, field

import numpy as np

from core.arrays import IntArray
from drivers.shape import Batch, BoolArray, ByteArray, Shape, among, gather

_SAMPLE = 16
_FEWEST_ROWS = 32
_MOST_ROWS = 4096
_LARGEST_WINDOW = 1 << 16


@dataclass(slots=True)
class _Found:
    """What one call has found so far."""

    starts: list[IntArray] = field(default_factory=list[IntArray])
    lengths: list[IntArray] = field(default_factory=list[IntArray])
    gaps: list[IntArray] = field(default_factory=list[IntArray])
    garbage: int = 0
    sample: bytes = b""
    bad: int = 0
    checked: tuple[int, int, int, BoolArray] | None = None
    """First place, distance, length and outcome of the rows that were checked last."""

    def known(self, cursor: int, pitch: int, length: int) -> BoolArray | None:
        """Return the outcome for rows from `cursor` on if they were among those checked last.

        Damage within a frame leaves the frames behind it at their distance, and they need not be
        checked again.
        """
        if self.checked is None or self.checked[1:3] != (pitch, length):
            return None
        good = self.checked[3]
        row, off = divmod(cursor - self.checked[0], pitch)
        return good[row:] if off == 0 and 0 <= row < len(good) else None

    def waste(self, buffer: ByteArray, at: int, count: int) -> None:
        if count and not self.garbage:
            self.sample = buffer[at : at + min(count, _SAMPLE)].tobytes()
        self.garbage += count

    def batch(self, buffer: ByteArray) -> Batch:
        none = np.empty(0, dtype=np.int64)
        starts, lengths, gaps = (
            parts[0] if len(parts) == 1 else np.concatenate(parts) if parts else none
            for parts in (self.starts, self.lengths, self.gaps)
        )
        return Batch(buffer, starts, lengths, gaps, self.garbage, self.sample, self.bad)


def _greedy(starts: IntArray, ends: IntArray) -> IntArray:
    """Return which of these frames remain when each one excludes what begins inside it."""
    if bool(np.all(starts[1:] >= ends[:-1])):
        return np.arange(len(starts))
    kept: list[int] = []
    free = 0
    for position, (start, end) in enumerate(zip(starts.tolist(), ends.tolist(), strict=True)):
        if start >= free:
            kept.append(position)
            free = end
    return np.array(kept, dtype=np.int64)


def _outside(places: IntArray, starts: IntArray, ends: IntArray) -> IntArray:
    """Return those of `places` that lie in none of the sorted frames."""
    if not len(starts) or not len(places):
        return places
    before = np.searchsorted(starts, places, side="right") - 1
    return places[(before < 0) | (places >= ends[np.maximum(before, 0)])]


class FrameFinder:
    """Finds the frames of one `Shape`; feed it with pieces of any size."""

    def __init__(self, shape: Shape) -> None:
        self._shape = shape
        self._fixed = shape.lengths if isinstance(shape.lengths, int) else 0
        self._least = shape.least or shape.header
        self._tail = np.frombuffer(shape.tail, dtype=np.uint8)
        self._carry = b""
        self._passed = 0
        """Bytes of the stream before the carry."""
        self._gap = 0
        """Garbage since the last frame."""
        self._bad_until = 0
        """End, in the stream, of the last place that was counted as bad."""
        self._locked = False
        """Whether the carry begins right behind a frame."""
        self._tail_due = False
        """Whether the tail of that frame may still come."""
        self._tailed = False
        """Whether the last tail did come."""
        self._last = self._fixed
        self._rows = _FEWEST_ROWS
        # A damaged frame, and the next one behind it.
        self._smallest_window = 2 * (shape.longest + shape.follow + len(shape.tail)) + 16
        self._window = self._smallest_window

    @property
    def carried(self) -> int:
        """Bytes that wait for more."""
        return len(self._carry)

    def push(self, data: bytes) -> Batch:
        """Return the frames that are complete with this piece."""
        return self._scan(np.frombuffer(self._carry + data, dtype=np.uint8), final=False)

    def finish(self) -> Batch:
        """Return what is in the carry when nothing more will come: nothing waits any longer."""
        return self._scan(np.frombuffer(self._carry, dtype=np.uint8), final=True)

    def _scan(self, buffer: ByteArray, final: bool) -> Batch:
        found = _Found()
        cursor, size = 0, len(buffer)
        while cursor < size:
            before = cursor
            cursor = self._skip_tail(buffer, cursor)
            if self._locked:
                cursor = self._run(buffer, cursor, found)
            if cursor >= size or (not final and self._must_wait(buffer, cursor)):
                break
            if final and self._shape.follow:
                cursor = self._last_of_stream(buffer, cursor, found)
            cursor = self._search(buffer, cursor, found, final)
            if cursor == before:
                break
        self._carry = buffer[cursor:].tobytes()
        self._passed += cursor
        return found.batch(buffer)

    def _skip_tail(self, buffer: ByteArray, cursor: int) -> int:
        if not self._tail_due:
            return cursor
        piece = buffer[cursor : cursor + len(self._tail)].tobytes()
        if piece == self._shape.tail:
            self._tail_due, self._tailed = False, True
            return cursor + len(piece)
        if not self._shape.tail.startswith(piece):
            self._tail_due = self._tailed = False
        return cursor

    def _must_wait(self, buffer: ByteArray, cursor: int) -> bool:
        """Return whether a frame may begin right here whose end has not come."""
        if not self._locked:
            return False
        if self._tail_due:
            return True
        shape = self._shape
        head = buffer[cursor : cursor + shape.header]
        for byte, allowed in zip(head.tolist(), shape.starts, strict=False):
            if allowed is not None and byte not in allowed:
                return False
        if len(head) < self._least:
            return True
        length = int(self._lengths(head.reshape(1, -1))[0])
        return length > 0 and cursor + length + shape.follow > len(buffer)

    def _lengths(self, heads: ByteArray) -> IntArray:
        """Return the whole lengths by headers, which may be cut off; (n, any) uint8 -> (n,)."""
        if isinstance(self._shape.lengths, int):
            return np.full(len(heads), self._fixed)
        missing = self._shape.header - heads.shape[1]
        if missing > 0:
            heads = np.pad(heads, ((0, 0), (0, missing)))
        return self._shape.lengths(heads[:, : self._shape.header])

    def _accept(self, found: _Found, starts: IntArray, lengths: IntArray, gaps: IntArray) -> None:
        gaps[0] += self._gap
        self._gap = 0
        self._last = int(lengths[-1])
        found.starts.append(starts)
        found.lengths.append(lengths)
        found.gaps.append(gaps)

    def _run(self, buffer: ByteArray, cursor: int, found: _Found) -> int:
        """Take frames that follow each other at the distance of the last one."""
        shape, length = self._shape, self._last
        while True:
            pitch = length + (len(self._tail) if self._tailed else 0)
            width = length + shape.follow
            most = (len(buffer) - cursor - width) // pitch + 1
            count = min(most, self._rows)
            if count <= 0 or (self._tail_due and cursor < len(buffer)):
                return cursor
            good = found.known(cursor, pitch, length)
            if good is None:
                rows = np.ndarray((count, width), np.uint8, buffer, cursor, (pitch, 1))
                good = self._genuine(rows, length)
                if pitch > length and count > 1:
                    size = (count - 1, pitch - length)
                    tails = np.ndarray(size, np.uint8, buffer, cursor + length, (pitch, 1))
                    good[1:] &= (tails == self._tail).all(axis=1)
                found.checked = (cursor, pitch, length, good)
            count = len(good)
            taken = count if good.all() else int(good.argmin())
            if taken:
                starts = cursor + pitch * np.arange(taken)
                self._accept(found, starts, np.full(taken, length), np.zeros(taken, np.int64))
                cursor += pitch * (taken - 1) + length
                self._tail_due = bool(shape.tail)
                cursor = self._skip_tail(buffer, cursor)
                if taken >= 8:
                    self._window = self._smallest_window
            self._rows = min(2 * count, _MOST_ROWS) if taken == count else max(taken, _FEWEST_ROWS)
            if taken < count:
                return cursor

    def _genuine(self, rows: ByteArray, length: int) -> BoolArray:
        good = self._shape.intact(rows)
        for position, allowed in enumerate(self._shape.starts):
            if allowed is None:
                continue
            good = good & among(rows[:, position], allowed)
        if not self._fixed:
            good = good & (self._lengths(rows) == length)
        return good

    def _last_of_stream(self, buffer: ByteArray, cursor: int, found: _Found) -> int:
        """Take a last frame without checksum on trust if it stands right behind another one."""
        end = cursor + self._last
        if not self._locked or end > len(buffer):
            return cursor
        head = buffer[cursor : cursor + self._shape.header].reshape(1, -1)
        fits = all(
            allowed is None or head[0, position] in allowed
            for position, allowed in enumerate(self._shape.starts)
        )
        if not fits or self._lengths(head)[0] != self._last:
            return cursor
        one = np.array([cursor])
        self._accept(found, one, np.array([self._last]), np.zeros(1, np.int64))
        return end

    def _candidates(self, window: ByteArray) -> tuple[IntArray, IntArray, IntArray]:
        """Return places with a possible length, their lengths, and places cut off before it."""
        shape, size = self._shape, len(window)
        first = shape.starts[0]
        places = np.flatnonzero(among(window, first)) if first is not None else np.arange(size)
        split = int(np.searchsorted(places, size - self._least, side="right"))
        places, late = places[:split], places[split:]
        for position, allowed in enumerate(shape.starts[1:], start=1):
            if allowed is not None:
                places = places[among(window[places + position], allowed)]
        cut = [
            place
            for place in late.tolist()
            if all(
                allowed is None or byte in allowed
                for byte, allowed in zip(window[place:].tolist(), shape.starts, strict=False)
            )
        ]
        padded = np.concatenate((window, np.zeros(shape.header, dtype=np.uint8)))
        lengths = self._lengths(padded[places[:, None] + np.arange(shape.header)])
        possible = lengths > 0
        return places[possible], lengths[possible], np.array(cut, dtype=np.int64)

    def _search(self, buffer: ByteArray, cursor: int, found: _Found, final: bool) -> int:
        """Take all frames of the next window, and waste what can be no frame any more."""
        end = min(len(buffer), cursor + self._window)
        self._window = min(2 * self._window, max(_LARGEST_WINDOW, self._smallest_window))
        window = buffer[cursor:end]
        places, lengths, cut = self._candidates(window)
        whole = places + lengths + self._shape.follow <= len(window)
        good = np.zeros(len(places), dtype=np.bool_)
        for length in sorted(set(lengths[whole].tolist())):
            chosen = np.flatnonzero(whole & (lengths == length))
            rows = gather(window, places[chosen], length + self._shape.follow)
            good[chosen] = self._shape.intact(rows)
        starts = places[good]
        ends = starts + lengths[good]
        kept = _greedy(starts, ends)
        starts, ends = starts[kept], ends[kept]
        stop = len(window)
        if not final:
            waiting = _outside(np.concatenate((places[~whole], cut)), starts, ends)
            if len(waiting):
                stop = int(waiting[0])
                starts, ends = starts[starts < stop], ends[starts < stop]
        bad = _outside(places[whole & ~good], starts, ends)
        self._count_bad(bad, bad + lengths[np.searchsorted(places, bad)], stop, cursor, found)
        return cursor + self._settle(window, cursor, starts, ends, stop, found, final)

    def _count_bad(
        self, places: IntArray, ends: IntArray, stop: int, cursor: int, found: _Found
    ) -> None:
        """Count bad places, but none inside another one."""
        base = self._passed + cursor
        for place, end in zip(places.tolist(), ends.tolist(), strict=True):
            if place < stop and base + place >= self._bad_until:
                found.bad += 1
                self._bad_until = base + end

    def _settle(
        self, window: ByteArray, cursor: int, starts: IntArray, ends: IntArray, stop: int,
        found: _Found, final: bool,
    ) -> int:  # fmt: skip
        """Record the frames of a window and the garbage around them; return what is used up."""
        buffer, tail = window, len(self._tail)
        if not len(starts):
            if stop:
                found.waste(buffer, 0, stop)
                self._gap += stop
                self._locked = self._tail_due = False
            return stop
        gaps = starts.copy()
        gaps[1:] -= ends[:-1]
        rest = stop - int(ends[-1])
        if tail:
            followed = np.flatnonzero(gaps[1:] >= tail) + 1
            behind = gather(window, ends[followed - 1], tail) if len(followed) else None
            if behind is not None:
                gaps[followed[(behind == self._tail).all(axis=1)]] -= tail
        for position in np.flatnonzero(gaps)[:1].tolist():
            found.waste(buffer, int(starts[position] - gaps[position]), int(gaps.sum()))
        self._accept(found, starts + cursor, ends - starts, gaps)
        self._locked, self._tail_due = True, bool(tail)
        used = self._skip_tail(window[:stop], int(ends[-1]))
        if used == stop or (self._tail_due and rest < tail and not final):
            return used
        self._tail_due = False
        found.waste(buffer, used, stop - used)
        self._gap += stop - used
        self._locked = False
        return stop
