"""No sample lost while the window is worked: a CVG at 2 kHz through a pseudo-terminal, recorded.

``--minutes 10`` is the measurement; every recorded frame is compared with what the same unit sends
on a line without a computer behind it. The window is clicked, dragged and made to compute all the
while: pages, zoom, pause, cursors, statistics, channels, other tabs, means, exports. The time
between two turns of its event loop tells how long an operator has to wait.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import numpy as np
from PySide6.QtWidgets import QApplication

from drivers.decoders import make_decoder
from drivers.recording import Recording, read_recording
from drivers.virtual.address import rig_of
from drivers.virtual.pty_process import PtyProcess
from gui.app import Application, Options
from gui.devices.setup import DeviceSetup
from gui.live.state import Phase
from gui.live.tab import LiveTab

RATE = 2000
UNIT = f"sim://cvg25?rate={RATE}&seed=11"
ACT_S = 0.25
SLOWEST_MS = 250.0
_PIECE = 20_000


def row(name: str, value: float, unit: str, target: str, ok: bool) -> None:
    verdict = "ok" if ok else "MISSED"
    print(f"{name:<46} {value:12.3f} {unit:<7} | {'-':>6} | {'-':>6} | {target:<9} | {verdict}")


class Hands:
    """An operator who never rests."""

    def __init__(self, app: Application, live: LiveTab, folder: Path) -> None:
        self._app, self._live, self._folder = app, live, folder
        self._rng = np.random.default_rng(1)
        self._turn = 0

    def act(self) -> None:
        """Do the next thing."""
        view, charts = self._live.view, self._live.view.charts
        presenter, end = self._live.presenter, self._live.presenter.status().seconds
        a, b = np.sort(self._rng.uniform(0.0, end, 2)).tolist()
        turns = (
            lambda: charts.buttons["track"].click(),
            lambda: charts.charts.set_cursors(a, b),
            lambda: charts.buttons["all"].click(),
            lambda: presenter.mark("a note"),
            lambda: view.pages.setCurrentWidget(view.table),
            lambda: view.pages.setCurrentWidget(charts),
            lambda: charts.buttons["pause"].click(),
            lambda: presenter.show_channel("Temperature", shown=bool(self._turn % 2)),
            lambda: charts.buttons["pause"].click(),
            lambda: presenter.measures.add_interval(a, min(b, a + 20.0)),
            lambda: presenter.measures.average(),
            lambda: presenter.measures.remove_intervals(),
            lambda: self._app.window.tabs.setCurrentIndex(2),
            lambda: self._app.window.tabs.setCurrentWidget(self._live.widget),
            lambda: self._app.window.resize(1200 + self._turn % 300, 800),
            lambda: presenter.measures.export_samples("csv", str(self._folder / "part.csv")),
        )
        turns[self._turn % len(turns)]()
        self._turn += 1


def run(minutes: float, folder: Path) -> None:
    """Measure."""
    qt = QApplication.instance() or QApplication([])
    if not isinstance(qt, QApplication):
        raise TypeError("there is an application without widgets")
    app = Application(qt, Options(root=folder, settings=folder / "settings.json", quiet=True))
    app.start()
    while not app.tabs:
        qt.processEvents()
    live = app.tabs["Live"]
    if not isinstance(live, LiveTab):
        raise TypeError("the tab Live is another one")
    app.window.resize(1280, 800)
    app.window.tabs.setCurrentWidget(live.widget)
    profile = rig_of(UNIT).profile
    waits: list[float] = []
    with PtyProcess(UNIT) as rig:
        app.connection.open([DeviceSetup(rig.port, profile.port.bauds[0], profile.id, "25-143")])
        while live.presenter.phase is not Phase.WATCHING:
            qt.processEvents()
        live.presenter.act("start")
        recorder = live.keeper.recorder
        if recorder is None:
            raise RuntimeError("the record did not begin")
        hands = Hands(app, live, folder)
        began = acted = turned = time.monotonic()
        while turned - began < 60.0 * minutes:
            qt.processEvents()
            now = time.monotonic()
            waits.append(now - turned)
            turned = now
            if now - acted > ACT_S:
                acted = now
                hands.act()
            time.sleep(0.002)
        live.presenter.act("stop")
        lost = live.presenter.status().lost
        live.presenter.act("watch")
        recorder.close()
    record = read_recording(recorder.path)
    spent = 1e3 * np.array(waits)
    expected = 60.0 * minutes * RATE
    wrong = compared(record)
    count = len(record)
    row(f"frames recorded in {minutes:g} min", count, "frames", "> 0.99", count > 0.99 * expected)
    row("frames lost, by the reader", lost, "frames", "0", not lost)
    row("gaps in the record", len(record.gaps), "", "0", not record.gaps)
    row("frames missing or not as sent", wrong, "frames", "0", not wrong)
    row("turn of the window, median", float(np.median(spent)), "ms", "", True)
    slow = float(np.percentile(spent, 99.9))
    row("turn of the window, p99.9", slow, "ms", f"< {SLOWEST_MS:g}", slow < SLOWEST_MS)
    row("turn of the window, longest", float(spent.max()), "ms", "", True)
    app.window.close()
    app.close()


def sent() -> Iterator[np.ndarray]:
    """What the unit sends, from its first frame on, in pieces."""
    rig = rig_of(UNIT)
    decoder = make_decoder(rig.profile)
    while True:
        for event in decoder.feed(rig.produce(_PIECE)):
            if hasattr(event, "data"):
                yield event.data


def compared(record: Recording) -> int:
    """How many frames of the record are not, in their order, what the unit sent."""
    blocks = sent()
    ahead = next(blocks)
    wrong = 0
    begun = False
    for part in record.chunks():
        data = part.data
        while not begun:
            found = np.flatnonzero((ahead == data[0]).all(axis=1))
            if len(found):
                ahead, begun = ahead[int(found[0]) :], True
            else:
                ahead = next(blocks)
        while len(ahead) < len(data):
            ahead = np.concatenate([ahead, next(blocks)])
        wrong += int(np.count_nonzero((ahead[: len(data)] != data).any(axis=1)))
        ahead = ahead[len(data) :]
    return wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=0.5)
    minutes = parser.parse_args().minutes
    with tempfile.TemporaryDirectory() as name:
        run(minutes, Path(name))


if __name__ == "__main__":
    sys.exit(main())
