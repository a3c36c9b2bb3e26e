"""Recording and opening records: the speed that the Live tab stands on.

Peers: numpy's own writer and readers, which check nothing. ``--hours 30`` runs the long soak: the
frames of so many hours with faults between, through reader and recorder.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np
from soaking import soak

from core.arrays import frozen, frozen_int
from core.records.cvgcom import CvgcomFile, CvgcomHead, channel_of, read_cvgcom
from core.records.cvgcom_writer import write_cvgcom
from core.samples.block import SampleBlock
from drivers import recorder
from drivers.recorder import SINGLE, Recorder, RecordLayout
from drivers.recording import read_recording
from gui.live.trace import trace_of

SEVEN = tuple(
    channel_of(name)
    for name in (
        "GyroOut",
        "Temperature",
        "AntiNodePeriod",
        "ExcitationDelay",
        "AntiNodeAmplitude",
        "ExcitationAmpl",
        "QuadratureAmpl",
    )
)
ROWS = 360_000
OPEN_HOURS = 10
CUTS = 10


def row(name: str, value: float, unit: str, peer: float, target: str, ok: bool) -> None:
    ratio = f"{peer / value:.2f}" if peer == peer else "-"
    verdict = "ok" if ok else "MISSED"
    print(
        f"{name:<46} {value:10.3f} {unit:<7} | {peer:10.3f} | {ratio:>6} | {target:<9} | {verdict}"
    )


def best(work, count: int = 3) -> float:
    times = []
    for _ in range(count):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def text_file(folder: Path) -> None:
    data = np.random.default_rng(1).normal(1.0, 0.1, size=(ROWS, 7))
    path = folder / "25-143.exp(001)_s_pr1.txt"
    head = CvgcomHead(0.01, 0.024, SEVEN)
    write_cvgcom(CvgcomFile(path, head, frozen(data), None, ()), path)
    ours = best(lambda: read_cvgcom(path))
    peer = best(lambda: np.loadtxt(path, skiprows=6), 1)
    row("CVGCom text 1 h x 100 Hz x 7, open", ours, "s", peer, "< 0.5 s", ours < 0.5)


def record(folder: Path) -> None:
    """Ten hours of a CVG at 200 Hz, recorded as fast as it goes, opened, and put on the screen."""
    path = folder / "long.calrec"
    # Blocks as small as those of an hour that lasts an hour.
    recorder._FLUSH_S = 0.0
    writer = Recorder(path, {}, RecordLayout(SEVEN, 200.0, SINGLE))
    count = OPEN_HOURS * 3600 * 200
    piece = 40
    values = frozen(np.random.default_rng(2).normal(size=(piece, 7)).astype(np.float32))
    noise = np.random.default_rng(3).bytes(piece * 48)
    start = time.perf_counter()
    for first in range(0, count, piece):
        writer.take(noise, time.monotonic())
        writer.say(SampleBlock(SEVEN, frozen_int(np.arange(first, first + piece)), values, 200.0))
    writer.close()
    rate = count / (time.perf_counter() - start)
    nan = float("nan")
    row("record 7 channels, bytes and samples", rate / 1e6, "Mrow/s", nan, "> 0.05", rate > 5e4)
    opened = best(lambda: read_recording(path))
    row(f"open {OPEN_HOURS} h x 200 Hz x 7", opened, "s", nan, "< 5 s", opened < 5.0)
    found = read_recording(path)
    column = best(lambda: found.column(0))
    row("  one channel as an array", column, "s", nan, "< 2 s", column < 2.0)
    recorder._FLUSH_S = 0.2
    shown = best(lambda: trace_of(found), 1)
    row("  onto the charts", shown, "s", nan, "< 10 s", shown < 10.0)


def endure(hours: float) -> None:
    with tempfile.TemporaryDirectory() as name:
        found = soak(hours, Path(name) / "soak.calrec", cuts=CUTS)
    print(
        f"{hours:g} h soaked in {found.spent_s:.0f} s: {found.sent} sent, {found.damaged} damaged, "
        f"cable pulled {found.reconnections} times"
    )
    nan = float("nan")
    for what in ("missing", "doubled", "foreign"):
        count = getattr(found, what)
        row(f"good frames {what} in the record", count, "frames", nan, "0", not count)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hours", type=float, default=0.0)
    hours = parser.parse_args().hours
    print(f"{'name':<46} {'value':>10} {'unit':<7} | {'peer':>10} | {'ratio':>6} | target    |")
    with tempfile.TemporaryDirectory() as name:
        text_file(Path(name))
        record(Path(name))
    if hours:
        endure(hours)


if __name__ == "__main__":
    main()
