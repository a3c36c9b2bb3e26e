"""Seven live charts at 1 kHz over histories of 1e5, 1e6 and 1e7 samples a channel.

A frame is what happens every 33 ms: 33 new samples a channel, then the picture. CPU time of the
GUI thread, offscreen, 1280 x 900. The peer is pyqtgraph with its own peak downsampling.
"""

import os
import time
from collections.abc import Callable, Iterator

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtWidgets import QApplication

from core.arrays import FloatArray
from core.samples.block import Channel
from gui.widgets.history import History
from gui.widgets.strip_charts import StripCharts
from gui.widgets.theme import apply_theme

CHANNELS = tuple(Channel(f"channel {number}", "V") for number in range(7))
RATE = 1000.0
BATCH = 33
FRAMES = 300
MEDIAN_MS, P99_MS = 12.0, 33.0
SPREAD = 1.5
"""Largest allowed ratio of the medians at 1e7 and 1e5 samples of history."""
PEER_FRAMES = 15


def batches(rng: np.random.Generator) -> Iterator[FloatArray]:
    """Endless noise with a slow wave, (BATCH, 7) each."""
    place = 0
    while True:
        wave = np.sin((place + np.arange(BATCH)) / 7e4)[:, None]
        yield wave + 0.1 * rng.normal(size=(BATCH, len(CHANNELS)))
        place += BATCH


def cpu_ms(frames: int, frame: Callable[[], None]) -> tuple[float, float]:
    """Median and 99th percentile of the thread's CPU time of a frame."""
    for _ in range(5):
        frame()
    times = []
    for _ in range(frames):
        start = time.thread_time()
        frame()
        times.append(time.thread_time() - start)
    return 1e3 * float(np.median(times)), 1e3 * float(np.percentile(times, 99))


def ours(app: QApplication, samples: int, track_s: float | None) -> tuple[float, float]:
    """Cost of our frame."""
    rng = np.random.default_rng(samples)
    history = History(CHANNELS, RATE)
    for first in range(0, samples, 500_000):
        count = min(500_000, samples - first)
        history.append(
            np.arange(first, first + count), rng.normal(size=(count, len(CHANNELS))) * 0.1
        )
    charts = StripCharts()
    charts.resize(1280, 900)
    charts.set_history(history)
    if track_s is not None:
        charts.track(track_s)
    charts.show()
    source = batches(rng)

    def frame() -> None:
        history.append(np.arange(history.end, history.end + BATCH), next(source))
        charts.refresh()
        app.processEvents()

    cost = cpu_ms(FRAMES, frame)
    charts.close()
    charts.deleteLater()
    app.processEvents()
    return cost


def peer(app: QApplication, samples: int) -> float:
    """Median cost of a frame of seven pyqtgraph plots, full time scale."""
    import pyqtgraph as pg

    rng = np.random.default_rng(samples)
    data = [rng.normal(size=samples) for _ in CHANNELS]
    times = np.arange(samples) / RATE
    layout = pg.GraphicsLayoutWidget()
    layout.resize(1280, 900)
    curves = []
    for row in range(len(CHANNELS)):
        plot = layout.addPlot(row=row, col=0)
        plot.setDownsampling(auto=True, mode="peak")
        plot.setClipToView(True)
        curves.append(plot.plot())
    layout.show()

    def frame() -> None:
        for curve, values in zip(curves, data, strict=True):
            curve.setData(times, values)
        app.processEvents()

    median, _ = cpu_ms(PEER_FRAMES, frame)
    layout.close()
    return median


def main() -> int:
    """Print the rows; return the number of targets missed."""
    app = QApplication.instance() or QApplication([])
    if not isinstance(app, QApplication):
        raise TypeError("a Qt application without widgets is already running")
    apply_theme(app, "light")
    missed = 0
    for name, track_s in (("full time scale", None), ("auto tracking 10 s", 10.0)):
        medians = []
        for samples in (10**5, 10**6, 10**7):
            median, p99 = ours(app, samples, track_s)
            medians.append(median)
            beside = "- | -"
            if track_s is None and samples < 10**7:
                other = peer(app, samples)
                beside = f"{other:.1f} ms | {other / median:.1f}x"
            for what, value, limit in (("median", median, MEDIAN_MS), ("p99", p99, P99_MS)):
                late = value > limit
                missed += late
                print(
                    f"7 charts, {name}, {samples:.0e} samples, CPU {what} {value:6.2f} ms"
                    f" | {beside} | <= {limit:.0f} ms | {'MISSED' if late else 'ok'}"
                )
                beside = "- | -"
        ratio = medians[-1] / medians[0]
        late = ratio > SPREAD
        missed += late
        print(
            f"7 charts, {name}, cost at 1e7 over cost at 1e5 {ratio:.2f} | - | -"
            f" | <= {SPREAD} | {'MISSED' if late else 'ok'}"
        )
    return missed


if __name__ == "__main__":
    raise SystemExit(main())
