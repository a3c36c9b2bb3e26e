"""Samples of stretches as CSV or MATLAB files, charts as pictures; a name proposed and editable."""

import io
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, QSize, Signal

from core.arrays import FloatArray, IntArray
from core.errors import LabError, Severity
from core.records.atomic import write_bytes_atomic
from core.records.means import NAME, TABLE, RecordMean, write_means
from core.samples.block import Channel
from gui.jobs import Jobs
from gui.messages import Messages
from gui.widgets.chart_export import Paint, save_chart
from gui.widgets.states import BannerState

SOURCE = "export"
PICTURES = {"svg": "Charts, SVG", "png": "Charts, PNG", "pdf": "Charts, PDF"}
_BATCH = 2000


def csv_bytes(
    channels: tuple[Channel, ...],
    index: IntArray,
    data: FloatArray,
    rate: float,
    separator: str = ",",
    decimal: str = ".",
) -> bytes:
    """Number, time and channels of each sample, with a head of names and units."""
    names = [f"{c.name} [{c.unit}]" if c.unit else c.name for c in channels]
    out = io.StringIO()
    out.write(separator.join(["index", "t [s]", *names]) + "\r\n")
    t = (index - index[0]) / rate if len(index) else np.empty(0)
    row = separator.join(["%d", "%.6f", *["%.9g"] * len(channels)]) + "\r\n"
    for begin in range(0, len(index), _BATCH):
        part = slice(begin, begin + _BATCH)
        block = np.column_stack([index[part], t[part], data[part]])
        text = row * len(block) % tuple(block.ravel().tolist())
        out.write(text if decimal == "." else text.replace(".", decimal))
    # Spreadsheets of computers with decimal commas take UTF-8 without a mark for CP1251.
    return out.getvalue().encode("utf-8" if decimal == "." else "utf-8-sig")


def excel_bytes(
    channels: tuple[Channel, ...], index: IntArray, data: FloatArray, rate: float
) -> bytes:
    """The same with semicolons and decimal commas."""
    return csv_bytes(channels, index, data, rate, ";", ",")


def mat_bytes(
    channels: tuple[Channel, ...], index: IntArray, data: FloatArray, rate: float
) -> bytes:
    """A MATLAB file (version 5) with a structure ``record``: index, t, data, names, units, rate."""
    from scipy.io import savemat

    names, units = np.empty(len(channels), dtype=object), np.empty(len(channels), dtype=object)
    names[:] = [channel.name for channel in channels]
    units[:] = [channel.unit for channel in channels]
    t = (index - index[0]) / rate if len(index) else np.empty(0)
    record = {
        "index": index[:, None],
        "t": t[:, None],
        "data": data,
        "names": names,
        "units": units,
        "rate": rate,
    }
    out = io.BytesIO()
    savemat(out, {"record": record})  # pyright: ignore[reportArgumentType]
    return out.getvalue()


FORMATS: dict[
    str, tuple[str, str, Callable[[tuple[Channel, ...], IntArray, FloatArray, float], bytes]]
] = {
    "csv": ("CSV (1.5, …)", ".csv", csv_bytes),
    "excel": ("CSV (1,5; …)", ".csv", excel_bytes),
    "mat": ("MATLAB", ".mat", mat_bytes),
}
"""Title, suffix and writer of each format of samples."""


class Exporting(QObject):
    """Writes files in a worker; pictures at once, since they are painted."""

    averaged = Signal(object)
    """List of `RecordMean`."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages

    @property
    def formats(self) -> tuple[tuple[str, str], ...]:
        """Keys and titles."""
        return (*((key, one[0]) for key, one in FORMATS.items()), *PICTURES.items())

    def suffix(self, key: str) -> str:
        """File suffix of a format."""
        return FORMATS[key][1] if key in FORMATS else f".{key}"

    def samples(
        self,
        key: str,
        path: Path,
        channels: tuple[Channel, ...],
        samples: tuple[IntArray, FloatArray],
        rate: float,
    ) -> None:
        """Write samples."""
        write = FORMATS[key][2]
        index, data = samples

        def work() -> Path:
            write_bytes_atomic(path, write(channels, index, data, rate))
            return path

        self._jobs.start("export", work, self._on_done, self._on_failed)

    def means(self, make: Callable[[], list[RecordMean]], folder: Path) -> None:
        """Average in a worker, and write ``means.dat`` and ``means.csv``."""

        def work() -> list[RecordMean]:
            found = make()
            write_means(found, folder)
            return found

        self._jobs.start("means", work, self._on_means, self._on_failed)

    def picture(self, paint: Paint, size: QSize, path: Path) -> None:
        """Draw the charts into a file."""
        try:
            save_chart(paint, size, path, path.stem)
        except LabError as error:
            self._on_failed(error)
        else:
            self._on_done(path)

    def _on_means(self, found: object) -> None:
        self._messages.show(
            SOURCE, BannerState(Severity.INFO, "Averaged", f"{NAME} and {TABLE} stand beside it.")
        )
        self.averaged.emit(found)

    def _on_done(self, path: object) -> None:
        self._messages.show(SOURCE, BannerState(Severity.INFO, "Exported", str(path)))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(SOURCE, "Not exported", error)
