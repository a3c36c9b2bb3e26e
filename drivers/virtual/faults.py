"""What goes wrong between a device and the computer."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.arrays import FloatArray, IntArray

_MOST_GARBAGE = 40


@dataclass(frozen=True, slots=True)
class Faults:
    """How often what goes wrong; all zero is a perfect line.

    Parameters
    ----------
    bit_error : probability that a bit arrives wrong
    drop : probability that a frame never arrives
    half : probability that a frame arrives cut short
    garbage : probability that random bytes stand before a frame
    stuck : channels, by place, whose value no longer changes
    """

    bit_error: float = 0.0
    drop: float = 0.0
    half: float = 0.0
    garbage: float = 0.0
    stuck: tuple[int, ...] = ()


class Line:
    """The way of the frames, with its faults.

    Attributes
    ----------
    damaged : sample numbers of the frames that did not arrive whole, as they happened
    """

    def __init__(self, rng: np.random.Generator) -> None:
        self.damaged: list[IntArray] = []
        (
            self._drop_rng,
            self._half_rng,
            self._bit_rng,
            self._garbage_rng,
            self._detail_rng,
            self._noise_rng,
        ) = rng.spawn(6)
        self._held: FloatArray | None = None

    def freeze(self, data: FloatArray, faults: Faults) -> None:
        """Make stuck channels repeat their last value, in place."""
        if not faults.stuck:
            self._held = None
            return
        held = self._held = data[0].copy() if self._held is None else self._held
        stuck = list(faults.stuck)
        data[:, stuck] = held[stuck]

    def carry(self, data: bytes, first: int, count: int, faults: Faults) -> bytes:
        """Return what arrives of `count` frames, the first of them with sample number `first`."""
        if not (faults.bit_error or faults.drop or faults.half or faults.garbage):
            return data
        frames = self._frames(data, count)
        sizes = [8 * len(frame) for frame in frames]
        dropped = self._drop_rng.random(count) < faults.drop
        halved = self._half_rng.random(count) < faults.half
        flips = self._bit_rng.binomial(sizes, faults.bit_error)
        noisy = np.flatnonzero(self._garbage_rng.random(count) < faults.garbage)
        hit = dropped | halved | (flips > 0)
        self.damaged.append(first + np.flatnonzero(hit))
        for k in np.flatnonzero(hit):
            frames[k] = b"" if dropped[k] else self._spoilt(frames[k], int(flips[k]), halved[k])
        for k in noisy:
            frames[k] = self.noise(int(self._noise_rng.integers(1, _MOST_GARBAGE))) + frames[k]
        return b"".join(frames)

    def noise(self, count: int) -> bytes:
        """Return random bytes, as a wrong baud rate makes of any signal."""
        return self._noise_rng.bytes(count)

    def _spoilt(self, frame: bytes, flips: int, halved: bool) -> bytes:
        bits: NDArray[np.uint8] = np.unpackbits(np.frombuffer(frame, dtype=np.uint8))
        if flips:
            bits[self._detail_rng.choice(len(bits), flips, replace=False)] ^= 1
        whole = np.packbits(bits).tobytes()
        return whole[: int(self._detail_rng.integers(1, len(whole)))] if halved else whole

    @staticmethod
    def _frames(data: bytes, count: int) -> list[bytes]:
        """Cut into frames: of one length, or lines."""
        if data.count(b"\n") == count and data.endswith(b"\n"):
            return data.splitlines(keepends=True)
        size = len(data) // count
        return [data[k * size : (k + 1) * size] for k in range(count)]
