"""Reading and storing: legacy files, run files, positions of a session.

Peers: numpy's readers, which check nothing; for a stored position an append with one fsync.
"""

import os
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.arrays import frozen, frozen_int
from core.plans.plan import Plan, Step, load_plans
from core.procedures.dividing_head import calibrate
from core.records.legacy.reader import read_legacy
from core.records.run_file import read_run, write_run
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel
from core.samples.run import Conditions, Run

ROWS = 400
RECORD_ROWS = 100_000
STATED = Conditions(g_mps2=9.8106, u_g_mps2=1e-5, head_u_arcsec=5.0)


def legacy_file(folder: Path) -> Path:
    """Nine accelerometers through 16 passes of 25 positions."""
    path = folder / "OpticalDividingHead_202405131405.txt"
    rng = np.random.default_rng(1)
    lines = []
    for i in range(ROWS):
        angle = 15 * (i % 25)
        codes = 13000.0 * np.cos(np.radians(angle)) + rng.normal(0.0, 1.0, 9)
        cells = ["Colibrys", "+27", str(angle), str(angle // 15), "0", "0"]
        lines.append("\t".join([*cells, *(f"{code:.2f}" for code in codes), *["14798"] * 9]))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def record() -> Run:
    """Seven channels over a quarter of an hour at 100 Hz."""
    rng = np.random.default_rng(2)
    nan = frozen(np.full(RECORD_ROWS, np.nan))
    y = frozen(rng.normal(size=(RECORD_ROWS, 1)))
    return Run(
        test="record",
        sensor="gyro",
        device="25-143",
        channels=("y",),
        axes=("z",),
        unit="V",
        y=y,
        y_se=frozen(np.full_like(y, np.nan)),
        run=frozen_int(np.ones(RECORD_ROWS)),
        order=frozen_int(np.arange(RECORD_ROWS)),
        mount=("",) * RECORD_ROWS,
        head_deg=nan,
        set_rate_dps=nan,
        temperature_c=nan,
        t_s=frozen(np.arange(RECORD_ROWS) / 100.0),
        extra={f"c{i}": frozen(rng.normal(size=RECORD_ROWS)) for i in range(6)},
    )


def milliseconds(work: Callable[[], object], repeats: int) -> float:
    """Median wall time of one call."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1e3 * float(np.median(times))


def accept_ms(folder: Path) -> tuple[float, float]:
    """Wall time of storing one position: among the first 20 and among the last of `ROWS`."""
    channels = tuple(Channel(f"S{i}", "code", f"adc.{i}") for i in range(1, 10))
    channels += tuple(Channel(f"T{i}", "code", f"temp.adc.{i}") for i in range(1, 10))
    steps = tuple(Step(i + 1, "all", "X_from", 15.0 * (i % 25)) for i in range(ROWS))
    plan: Plan = replace(load_plans()["clbacc_24"], steps=steps)
    start = SessionStart(
        device="Colibrys",
        sensor="accelerometer",
        channels=channels,
        rate=100.0,
        plan=plan,
        started="2024-05-13T14:05:00+03:00",
        legacy="clbacc",
    )
    data = np.random.default_rng(3).normal(500.0, 1.0, (1000, 18))
    mean = accumulation_of(channels, np.arange(1000) / 100.0, data)
    times = []
    with Session.create(folder / "session", start) as session:
        for step in steps:
            began = time.perf_counter()
            session.accept(step, mean, set_temperature_c=27.0)
            times.append(time.perf_counter() - began)
    return 1e3 * float(np.median(times[:20])), 1e3 * float(np.median(times[-20:]))


def append_ms(folder: Path) -> float:
    """Wall time of one append of 3 kB with an fsync: what the disk itself takes."""
    handle = os.open(folder / "plain", os.O_WRONLY | os.O_CREAT | os.O_APPEND)

    def append() -> None:
        os.write(handle, b"x" * 3000)
        os.fsync(handle)

    took = milliseconds(append, 50)
    os.close(handle)
    return took


def row(name: str, value: float, peer: str, against: float, target: float) -> int:
    """Print one row; return whether its target was missed."""
    missed = value > target
    print(
        f"{name:<42} {value:9.2f} ms | {peer} {against:.2f} ms | x{value / against:.1f} |"
        f" target <= {target:g} ms | {'MISSED' if missed else 'ok'}"
    )
    return int(missed)


def main() -> int:
    """Print the rows; return the number of targets missed."""
    missed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = legacy_file(folder)

        def read() -> Run:
            return read_legacy(path).to_run(mounts=["X_from"])

        def numpy_legacy() -> object:
            return np.genfromtxt(path, usecols=range(1, 24))

        run = read()
        one = replace(
            run, channels=run.channels[:1], axes=run.axes[:1], y=run.y[:, :1], y_se=run.y_se[:, :1]
        )
        peer = milliseconds(numpy_legacy, 20)
        reading = milliseconds(read, 20)
        fit_one = milliseconds(lambda: calibrate(one, STATED), 5)
        fit_all = milliseconds(lambda: calibrate(run, STATED), 3)
        missed += row("legacy, 400 rows of 9 sensors: read", reading, "genfromtxt", peer, 30.0)
        missed += row("the same and fit one sensor", reading + fit_one, "genfromtxt", peer, 50.0)
        print(f"{'the same and fit all nine':<42} {reading + fit_all:9.2f} ms | no target")
        table = folder / "a.run.csv"
        write = milliseconds(lambda: write_run(record(), table), 1)
        slow = milliseconds(lambda: read_run(table), 3)
        skip = table.read_text(encoding="utf-8").count("#") + 1

        def numpy_table() -> object:
            return np.loadtxt(table, delimiter=",", skiprows=skip, ndmin=2)

        fast = milliseconds(numpy_table, 3)
        missed += row("run file, 100 000 rows of 10 columns: read", slow, "loadtxt", fast, 2000.0)
        print(f"{'the same: write':<42} {write:9.2f} ms | no target")
        first, last = accept_ms(folder)
        disk = append_ms(folder)
        missed += row("session: store a position, among 20", first, "append+fsync", disk, 50.0)
        missed += row("session: store a position, among 400", last, "append+fsync", disk, 100.0)
    return missed


if __name__ == "__main__":
    raise SystemExit(main())
