"""What is measured on the samples on the screen: cursors, intervals, means, exports."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.records.means import RecordMean, mean_of
from drivers.records import open_record, record_means, records_in
from gui.live.exporting import Exporting
from gui.live.figures import cursor_table
from gui.live.keeper import Keeper
from gui.live.means import Means
from gui.live.trace import Trace
from gui.widgets.states import TableState


class Measures(QObject):
    """Cursors and intervals of the trace on the screen.

    Parameters
    ----------
    keeper : knows where records stand
    exporting : writes files
    means : shows what was averaged
    """

    changed = Signal()
    """The table, the cursors or the intervals are others."""
    averaged = Signal()
    """There are other means."""

    def __init__(
        self,
        keeper: Keeper,
        exporting: Exporting,
        means: Means,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._means = means
        self._keeper = keeper
        self._exporting = exporting
        self.trace: Trace | None = None
        self.cursors: tuple[float | None, float | None] = (None, None)
        self.table = TableState("", "", (), ())
        self._shown: list[int] = []
        self._serial = ""
        exporting.averaged.connect(self._on_averaged)

    def take(self, trace: Trace | None, shown: list[int], serial: str) -> None:
        """Measure on another trace, of a device of this number."""
        self.trace = trace
        self.cursors = (None, None)
        self.show(shown, serial)

    def show(self, shown: list[int], serial: str) -> None:
        """Other channels are shown, or the device has another number."""
        self._shown, self._serial = shown, serial
        self._retable()

    def set_cursors(self, a: float | None, b: float | None) -> None:
        """The cursors stand there, s."""
        self.cursors = (a, b)
        self._retable()

    def add_interval(self, start: float, stop: float) -> None:
        """Select one more stretch, s."""
        if self.trace is not None:
            self.trace.add_interval(start, stop)
            self.changed.emit()

    def select_all(self, on: bool) -> None:
        """Select all intervals, or none."""
        if self.trace is not None:
            self.trace.select_all(on)
            self.changed.emit()

    def remove_intervals(self) -> None:
        """Forget all intervals."""
        if self.trace is not None:
            self.trace.intervals.clear()
            self.changed.emit()

    def average(self) -> None:
        """Means of the selected intervals, with ``means.dat`` beside the record."""
        trace = self.trace
        if trace is None or not trace.history.end:
            return
        stretches = trace.chosen(*self.cursors)
        name, channels, rate = trace.name or "live", trace.channels, trace.history.rate
        names = [f"{name}[{start:.3f}..{stop:.3f}]" for start, stop in stretches]
        excerpts = [trace.excerpt([part]) for part in stretches]

        def make() -> list[RecordMean]:
            return [
                mean_of(label, channels, *excerpt.samples(), rate)
                for label, excerpt in zip(names, excerpts, strict=True)
            ]

        self._exporting.means(make, self._keeper.folder(self._serial))

    def average_folder(self, folder: Path) -> None:
        """Means of every record of a folder."""
        self._exporting.means(
            lambda: [
                mean for path in records_in(folder) for mean in record_means(open_record(path))
            ],
            folder,
        )

    def proposed_export(self, key: str) -> str:
        """File name for a format."""
        name = self.trace.name if self.trace is not None and self.trace.name else "live"
        stem = name.removesuffix(".calrec").removesuffix(".txt")
        return str(self._keeper.folder(self._serial) / f"{stem}{self._exporting.suffix(key)}")

    def export_samples(self, key: str, name: str) -> None:
        """Write the chosen stretch."""
        if self.trace is None or not name.strip():
            return
        path = self._keeper.folder(self._serial) / Path(name.strip()).expanduser()
        self._exporting.samples(key, path, self.trace.excerpt(self.trace.chosen(*self.cursors)))

    def _on_averaged(self, means: list[RecordMean], folder: Path) -> None:
        self._means.take(means, folder, self._serial)
        self.averaged.emit()

    def _retable(self) -> None:
        if self.trace is None:
            self.table = TableState("", "", (), ())
        else:
            self.table = cursor_table(self.trace, self._shown, *self.cursors)
        self.changed.emit()
