"""The Live tab's part of the demonstration: an hour of each of two CVGs, marked and averaged."""

import math
from dataclasses import replace
from pathlib import Path

from drivers.virtual.rig import Rig
from drivers.virtual.truth import Compared
from gui.live.state import Phase
from gui.live.tab import LiveTab
from gui.measuring.demonstrating import Stage, Told

TITLE = "Live"
DEVICES = ("25-143", "25-144")
HOUR_S = 3600.0
_SURE = 1.96


def play(stage: Stage) -> Told:
    """Record two gyros, compare their scatter with the truth, and average the records."""
    tab = stage.show(TITLE)
    if not isinstance(tab, LiveTab):
        raise TypeError(f"{TITLE} is a {type(tab).__name__}")
    found: list[Compared] = []
    folder = Path()
    for seed, device in enumerate(DEVICES, 1):
        rig = stage.connect("cvg25", speed="max", block=10, seed=seed)
        folder = _record(stage, tab, device)
        found.append(_scatter(tab, rig, device))
        if device == DEVICES[0]:
            stage.picture("live-record")
        tab.presenter.act("watch")
    # At a usual speed again, which leaves the rest of the demonstration some of the computer.
    stage.connect("cvg25")
    tab.measures.average_folder(folder)
    stage.until(lambda: bool(tab.means.state.rows), "the record was not averaged")
    stage.keep(folder / "means.dat")
    stage.picture("live-means")
    tab.view.pages.setCurrentIndex(0)
    return Told(TITLE, tuple(found), folder)


def _record(stage: Stage, tab: LiveTab, device: str) -> Path:
    """Record an hour; return the folder of the record."""
    presenter = tab.presenter
    stage.until(lambda: presenter.phase is Phase.WATCHING, "no samples came")
    presenter.set_settings(replace(presenter.settings, serial=device))
    tab.view.pages.setCurrentIndex(0)
    presenter.act("start")
    stage.until(lambda: presenter.status().seconds > 0.3 * HOUR_S, "nothing was recorded")
    presenter.mark("door opened")
    stage.until(lambda: presenter.status().seconds > HOUR_S, "the hour was not recorded")
    presenter.act("stop")
    recorder = tab.keeper.recorder
    if recorder is None:
        raise RuntimeError("there is no record to be stopped")
    recorder.flush()
    stage.keep(recorder.path)
    return recorder.path.parent


def _scatter(tab: LiveTab, rig: Rig, device: str) -> Compared:
    """Standard deviation between cursors over most of the hour, beside the white noise there is."""
    trace = tab.presenter.trace
    if trace is None:
        raise RuntimeError("there is no record on the charts")
    charts = tab.view.charts.charts
    charts.set_cursors(60.0, HOUR_S - 60.0)
    history = trace.history
    number = [channel.name for channel in history.channels].index("GyroOut")
    first, end = (history.number(t) for t in (60.0, HOUR_S - 60.0))
    statistics = history.statistics(number, first, end + 1)
    (output,) = rig.truth()
    truth = output.level.density * math.sqrt(rig.rate_hz / 2.0)
    half = _SURE * statistics.sigma / math.sqrt(2.0 * statistics.count)
    held = abs(statistics.sigma - truth) <= half
    return Compared(f"{device} GyroOut", "σ", "V", statistics.sigma, half, truth, held)
