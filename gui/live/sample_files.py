"""Samples of stretches as CSV or MATLAB files, written piece by piece."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.errors import FormatError
from core.records.atomic import atomic_file
from gui.live.trace import Excerpt

_BATCH = 2000
_MOST_MAT_BYTES = 2**31 - 1


def write_csv(excerpt: Excerpt, path: Path, separator: str = ",", decimal: str = ".") -> None:
    """Write number, time and channels of each sample, with a head of names and units."""
    channels = excerpt.history.channels
    names = [f"{c.name} [{c.unit}]" if c.unit else c.name for c in channels]
    row = separator.join(["%d", "%.6f", *["%.9g"] * len(channels)]) + "\r\n"
    # Spreadsheets of computers with decimal commas take UTF-8 without a mark for CP1251.
    mark = b"" if decimal == "." else b"\xef\xbb\xbf"
    with atomic_file(path) as file:
        file.write(mark + (separator.join(["index", "t [s]", *names]) + "\r\n").encode())
        for index, data in excerpt.pieces():
            t = (index - excerpt.first) / excerpt.history.rate
            for begin in range(0, len(index), _BATCH):
                part = slice(begin, begin + _BATCH)
                block = np.column_stack([index[part], t[part], data[part]])
                text = row * len(block) % tuple(block.ravel().tolist())
                file.write((text if decimal == "." else text.replace(".", decimal)).encode())


def write_excel(excerpt: Excerpt, path: Path) -> None:
    """The same with semicolons and decimal commas."""
    write_csv(excerpt, path, ";", ",")


def write_mat(excerpt: Excerpt, path: Path) -> None:
    """Write MATLAB (version 5): a structure ``record`` of index, t, data, names, units, rate.

    Raises
    ------
    FormatError
        The samples take more than the format can hold.
    """
    from scipy.io import savemat

    channels = excerpt.history.channels
    if excerpt.count * len(channels) * 8 > _MOST_MAT_BYTES:
        raise FormatError(path, "MATLAB 5 holds 2 GB at most: choose a shorter stretch, or CSV")
    index, data = excerpt.samples()
    names, units = np.empty(len(channels), dtype=object), np.empty(len(channels), dtype=object)
    names[:] = [channel.name for channel in channels]
    units[:] = [channel.unit for channel in channels]
    record = {
        "index": index[:, None],
        "t": ((index - excerpt.first) / excerpt.history.rate)[:, None],
        "data": data,
        "names": names,
        "units": units,
        "rate": excerpt.history.rate,
    }
    with atomic_file(path) as file:
        savemat(file, {"record": record})  # pyright: ignore[reportArgumentType]


FORMATS: dict[str, tuple[str, str, Callable[[Excerpt, Path], None]]] = {
    "csv": ("CSV (1.5, …)", ".csv", write_csv),
    "excel": ("CSV (1,5; …)", ".csv", write_excel),
    "mat": ("MATLAB", ".mat", write_mat),
}
"""Title, suffix and writer of each format of samples."""
