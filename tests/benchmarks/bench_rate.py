"""A file of 11 rates and 9 gyros with all statistics, beside scipy's bare line of each sensor.

The peer gives slope, intercept and their errors and nothing else; ours adds the robust search for
faults, the tests of bend and asymmetry with their uncertainties, threshold, and all notes.
"""

import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy import stats

from core.procedures.rate_table import calibrate_rate_table
from core.records.legacy.reader import read_legacy
from core.samples.run import Conditions, Run

LIMIT_MS = 5.0
RATES = np.arange(-100, 101, 20)
SENSORS = 9


def a_file(folder: Path) -> Path:
    """A RotationTable file as ClbDUS writes it."""
    rng = np.random.default_rng(1)
    lines: list[str] = []
    for number, rate in enumerate(RATES):
        codes = -438.0 - (79.4 + np.arange(SENSORS)) * rate + rng.normal(0.0, 1.3, SENSORS)
        temperatures = [24800 + int(t) for t in rng.integers(-10, 10, SENSORS)]
        columns = ["ADXRS610", number, 0, 0, rate, *(f"{c:.2f}" for c in codes), *temperatures]
        lines.append("\t".join(map(str, columns)))
    path = folder / "RotationTable_202405151000.txt"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def with_errors(run: Run) -> Run:
    """The same with a standard error in every row, each sensor's own."""
    se = np.tile(1.0 + 0.1 * np.arange(SENSORS), (len(run), 1))
    return replace(run, y_se=se)


def bare_lines(run: Run) -> None:
    """The line of each sensor by scipy."""
    for channel in range(SENSORS):
        stats.linregress(run.set_rate_dps, run.y[:, channel])


def milliseconds(work: Callable[[], object], repeats: int = 200) -> float:
    """Median CPU time of one call."""
    work()
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return float(np.median(times)) * 1e3


def main() -> int:
    """Print the rows; return the number of targets missed."""
    with tempfile.TemporaryDirectory() as folder:
        path = a_file(Path(folder))
        run = read_legacy(path).to_run()
        known, worn = with_errors(run), Conditions(rate_u_dps=0.02)
        plain = Conditions()
        peer = milliseconds(lambda: bare_lines(run))
        cases: tuple[tuple[str, Callable[[], object], float | None], ...] = (
            ("fit, no standard errors", lambda: calibrate_rate_table(run, plain), LIMIT_MS),
            (
                "file read and fitted",
                lambda: calibrate_rate_table(read_legacy(path).to_run(), plain),
                LIMIT_MS,
            ),
            ("fit, standard errors, worn table", lambda: calibrate_rate_table(known, worn), None),
            ("fit, worn table, no standard errors", lambda: calibrate_rate_table(run, worn), None),
        )
        missed = 0
        for name, work, limit in cases:
            ours = milliseconds(work)
            verdict = "" if limit is None else ("MISSED" if ours > limit else "ok")
            missed += verdict == "MISSED"
            target = "no target" if limit is None else f"target <= {limit} ms | {verdict}"
            print(
                f"11 rates, 9 gyros: {name}  {ours:.2f} ms | scipy.stats.linregress {peer:.2f} ms"
                f" | x{ours / peer:.1f} | {target}"
            )
    return missed


if __name__ == "__main__":
    raise SystemExit(main())
