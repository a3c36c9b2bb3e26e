"""Main Graph: the measured sensors over time, with the accumulations marked."""

from PySide6.QtCore import QObject, QTimer

from core.samples.block import SampleBlock, chosen_columns
from gui.measuring.bench import Bench
from gui.measuring.sitting import Sitting
from gui.widgets.history import History
from gui.widgets.strip_charts import StripCharts
from gui.widgets.strip_view import Interval

_FRAME_MS = 33
_TAIL_S = 30.0


class MainGraph(QObject):
    """Feeds the charts; samples come straight from the bench.

    Parameters
    ----------
    charts : where they are drawn
    bench : whose samples
    sitting : whose accumulations are shaded
    """

    def __init__(self, charts: StripCharts, bench: Bench, sitting: Sitting) -> None:
        super().__init__(charts)
        self._charts = charts
        self._bench = bench
        self._sitting = sitting
        self._history: History | None = None
        self._columns: list[int] = []
        self._kept = -1
        self._fresh = False
        charts.track(_TAIL_S)
        bench.block.connect(self._on_block)
        bench.changed.connect(self._on_device)
        sitting.changed.connect(self._on_positions)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._refresh)
        self._timer.start(_FRAME_MS)
        self._on_device()

    def _on_device(self) -> None:
        device, bench = self._bench.device, self._bench
        if device is None:
            self._history = None
        else:
            self._columns = chosen_columns(bench.channels, device.checked)
            channels = tuple(bench.channels[place] for place in self._columns)
            self._history = History(channels, bench.rate)
        self._charts.set_history(self._history)
        self._charts.setVisible(self._history is not None)
        self._kept = -1

    def _on_block(self, block: SampleBlock) -> None:
        if self._history is not None:
            self._history.append(block.index, block.data[:, self._columns])
            self._fresh = True

    def _refresh(self) -> None:
        if self._fresh and self._charts.isVisible():
            self._fresh = False
            self._charts.refresh()

    def _on_positions(self) -> None:
        history = self._history
        kept = self._sitting.keeper.positions
        if history is None or len(kept) == self._kept:
            return
        self._kept = len(kept)
        self._charts.set_intervals(
            [
                Interval(
                    history.seconds(p.accumulation.first),
                    history.seconds(p.accumulation.first) + p.accumulation.seconds,
                    f"{p.step.number}",
                )
                for p in kept
                if p.accumulation.first >= history.first
            ]
        )
