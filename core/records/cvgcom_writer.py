"""Writing CVGCom's text file while the samples come, averaged as CVGCom averaged them."""

import os
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import StorageError
from core.records.atomic import write_bytes_atomic
from core.records.cvgcom import (
    COUNT_KEY,
    DECIMALS,
    NAMES_KEY,
    SCALE_KEY,
    TIME_KEY,
    VERSION_KEY,
    CvgcomFile,
    CvgcomHead,
)

RATES_HZ = (1, 5, 10, 20, 50, 100, 200)
"""Sampling frequencies that CVGCom offers; the device sends 200 frames a second."""

_END = "\r\n"
_BATCH = 1000


class FrameMean:
    """Means of N neighbouring frames by their numbers, N = device rate / sampling frequency.

    A mean is of the frames that came; where none of the N did, it is NaN, so that a row's place
    remains its time.

    Parameters
    ----------
    frames : N
    channels : columns of the data
    """

    def __init__(self, frames: int, channels: int) -> None:
        self._frames = frames
        self._zero: int | None = None
        self._row = 0
        self._sum = np.zeros(channels)
        self._count = 0

    def feed(self, index: IntArray, data: FloatArray) -> FloatArray:
        """Return the rows that these frames complete, (m, c).

        Parameters
        ----------
        index : (n,) increasing frame numbers, beyond all earlier ones
        data : (n, c)
        """
        if not len(index):
            return np.empty((0, len(self._sum)))
        if self._zero is None:
            self._zero = int(index[0])
        rows = (index - self._zero) // self._frames
        ends = int((index[-1] + 1 - self._zero) // self._frames)
        last = max(ends, int(rows[-1]) + 1)
        sums = np.zeros((last - self._row, len(self._sum)))
        counts = np.zeros(last - self._row)
        np.add.at(sums, rows - self._row, data)
        np.add.at(counts, rows - self._row, 1.0)
        sums[0] += self._sum
        counts[0] += self._count
        done = ends - self._row
        with np.errstate(invalid="ignore"):
            means = sums[:done] / counts[:done, None]
        self._sum = sums[done] if done < len(sums) else np.zeros_like(self._sum)
        self._count = int(counts[done]) if done < len(sums) else 0
        self._row = ends
        return means


class CvgcomWriter:
    """Appends rows to a new file.

    Parameters
    ----------
    path : must not exist yet
    head : what stands above the rows
    frames : how many frames of the device make one row

    Raises
    ------
    StorageError
        The file exists or cannot be made.
    """

    def __init__(self, path: Path, head: CvgcomHead, frames: int = 1) -> None:
        self.path = path
        self._mean = FrameMean(frames, len(head.channels))
        flags = os.O_CREAT | os.O_EXCL | os.O_WRONLY | getattr(os, "O_BINARY", 0)
        try:
            self._fd = os.open(path, flags, 0o644)
        except OSError as error:
            raise StorageError(f"{path}: cannot be created: {error.strerror}") from error
        try:
            self._put(head_text(head))
        except OSError as error:
            os.close(self._fd)
            path.unlink(missing_ok=True)
            raise StorageError(f"{path}: cannot be created: {error.strerror}") from error

    def feed(self, index: IntArray, data: FloatArray) -> None:
        """Write the rows that these frames complete.

        Raises
        ------
        StorageError
            The disk took not all of them; the last row may be incomplete.
        """
        rows = self._mean.feed(index, data)
        if not len(rows):
            return
        try:
            self._put(rows_text(rows))
        except OSError as error:
            raise StorageError(f"{self.path}: cannot be written: {error.strerror}") from error

    def close(self) -> None:
        """Sync and close; may be called again.

        Raises
        ------
        StorageError
            The disk reports that the rows are not safe.
        """
        if self._fd < 0:
            return
        fd, self._fd = self._fd, -1
        try:
            try:
                os.fsync(fd)
            finally:
                os.close(fd)
        except OSError as error:
            raise StorageError(f"{self.path}: not safe on disk: {error.strerror}") from error

    def _put(self, text: str) -> None:
        rest = memoryview(text.encode("utf-8"))
        while rest:
            rest = rest[os.write(self._fd, rest) :]


def write_cvgcom(file: CvgcomFile, path: Path) -> None:
    """Write a whole file, replacing `path`.

    Raises
    ------
    StorageError
        It cannot be written; what stood there before is untouched.
    """
    write_bytes_atomic(path, (head_text(file.head) + rows_text(file.data)).encode("utf-8"))


def head_text(head: CvgcomHead) -> str:
    """The lines above the rows; each row begins with a line end, as in CVGCom."""
    lines = (
        f"{VERSION_KEY}\t\t= {head.version}",
        f"{TIME_KEY}\t\t= {head.sampling_s:1.9f}",
        f"{SCALE_KEY}\t\t= {head.scale_factor:1.9f}",
        f"{COUNT_KEY}\t\t= {len(head.channels)}",
        f"{NAMES_KEY}\t\t{' '.join(_one_word(channel.name) for channel in head.channels)}",
    )
    return _END.join(lines) + _END


def rows_text(rows: FloatArray) -> str:
    """Rows of values, each after a line end."""
    row = _END + "\t".join([f"%1.{DECIMALS}f"] * rows.shape[1])
    return "".join(
        row * len(part) % tuple(part.ravel().tolist())
        for part in (rows[begin : begin + _BATCH] for begin in range(0, len(rows), _BATCH))
    )


def _one_word(name: str) -> str:
    return "_".join(name.split()) or "_"
