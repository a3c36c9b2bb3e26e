"""Speed of the Allan analysis beside AllanTools, and with --table its accuracy and coverage.

    python tests/benchmarks/bench_allan.py            360 000 samples, streaming, noise fit
    python tests/benchmarks/bench_allan.py --full     also 86.4 million samples (minutes, 3 GB)
    python tests/benchmarks/bench_allan.py --table 500    coefficients, 500 hours for each case

All times are CPU seconds of the process: other work on the machine does not count.

Each deviation is timed in processes of its own, the call after the imports: a first call is what a
user waits for. The library makes temporary arrays of the size of the record; whether a repeated
call gets their memory back from the allocator or has it mapped afresh differs from process to
process by a factor of six, so repeated calls are printed too, without a target.
"""

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.allan.deviation import overlapping
from core.allan.noise import fit_noise
from core.allan.streaming import LiveAllan
from core.allan.taus import averaging_factors
from core.arrays import FloatArray

HOUR, DAY = 360_000, 86_400_000
RATE = {HOUR: 100.0, DAY: 1000.0}
EXACT, EQUIVALENT, MEMORY_MB = {HOUR: 8.0, DAY: 7.0}, {DAY: 15.0}, 700.0
PUSH_MS, FIT_S, EQUAL = 0.3, 0.5, 1e-12
PROCESSES = {HOUR: 5, DAY: 1}
ROOT = str(Path(__file__).parents[2])
CASES = {
    "A": (0.02, 0.0125, 3e-4),
    "B": (0.0025, 0.001, 5e-5),
    "C": (2e-4, 1.4e-5, 1e-7),
    "D": (0.0025, 0.0, 1e-4),
}
TERMS = ("random_walk", "bias_instability", "rate_random_walk")


def record(n: int) -> FloatArray:
    """White noise, drawn in pieces."""
    rng = np.random.default_rng(1)
    values = np.empty(n)
    for at in range(0, n, 1 << 20):
        values[at : at + (1 << 20)] = rng.normal(size=min(1 << 20, n - at))
    return values


def peak_mb() -> float:
    """Return the peak resident memory of this process."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    return int(status.split("VmHWM:")[1].split()[0]) / 1024.0


def alone(who: str, n: int) -> None:
    """Time one contestant in this process and print what came out as JSON."""
    import scipy.special  # noqa: F401  (loaded before memory is counted, as allantools does)

    values = record(n)
    m = averaging_factors(n)
    call: Callable[[], FloatArray]
    if who == "allantools":
        import allantools

        def call() -> FloatArray:
            taus = m / RATE[n]
            return allantools.oadev(values, rate=RATE[n], data_type="freq", taus=taus)[1]
    else:

        def call() -> FloatArray:
            return overlapping(values, RATE[n], m=m, mode=who).deviation

    before = peak_mb()
    times = []
    deviation = np.empty(0)
    for _ in range(1 if n == DAY else 8):
        start = time.process_time()
        deviation = call()
        times.append(time.process_time() - start)
    extra = peak_mb() - before
    answer = {"first": times[0], "best": min(times), "extra": extra, "adev": deviation.tolist()}
    print(json.dumps(answer))


def race(n: int) -> dict[str, dict[str, list[float]]]:
    """Run all contestants in turn, each in several fresh processes."""
    results: dict[str, dict[str, list[float]]] = {}
    for _ in range(PROCESSES[n]):
        for who in ("allantools", "exact", "equivalent"):
            command = [sys.executable, __file__, "--alone", who, "--samples", str(n)]
            # sys.path[0] of a script is its own folder.
            out = subprocess.run(
                command, capture_output=True, text=True, check=True, env={"PYTHONPATH": ROOT}
            ).stdout
            answer = json.loads(out)
            kept = results.setdefault(who, {"first": [], "best": [], "extra": [], "adev": []})
            for key in ("first", "best", "extra"):
                kept[key].append(answer[key])
            kept["adev"] = answer["adev"]
    return results


def row(name: str, ours: str, peer: str, ratio: str, target: str, ok: bool | None) -> int:
    """Print one row; return 1 for a missed target."""
    verdict = "" if ok is None else ("ok" if ok else "MISSED")
    print(f"{name:52s} {ours:>12s} | {peer:>12s} | {ratio:>7s} | {target:>10s} | {verdict}")
    return int(ok is False)


def deviations(n: int) -> int:
    """Print the rows of one length."""
    missed = 0
    results = race(n)
    peer = results["allantools"]
    label = f"{n / 1e6:g}M samples, 100 log taus"
    for who, targets in (("exact", EXACT), ("equivalent", EQUIVALENT)):
        ours = results[who]
        for kind in ("first", "best") if n == HOUR else ("first",):
            one, other = float(np.median(ours[kind])), float(np.median(peer[kind]))
            target = targets.get(n) if kind == "first" else None
            call = "first call" if kind == "first" else "repeated, best"
            missed += row(
                f"{label}, {who}, {call}",
                f"{one * 1e3:.1f} ms",
                f"{other * 1e3:.1f} ms",
                f"x{other / one:.1f}",
                f">= x{target:g}" if target else "-",
                None if target is None else other / one >= target,
            )
        if n == DAY:
            extra = max(ours["extra"])
            missed += row(
                f"{label}, {who}, memory above the data",
                f"{extra:.0f} MB",
                f"{max(peer['extra']):.0f} MB",
                "",
                f"<= {MEMORY_MB:g} MB",
                extra <= MEMORY_MB,
            )
    off = np.abs(np.array(results["exact"]["adev"]) / np.array(peer["adev"]) - 1.0).max()
    missed += row(
        f"{label}, exact, largest difference", f"{off:.1e}", "", "", f"<= {EQUAL:g}", off <= EQUAL
    )
    return missed


def streaming() -> int:
    """Print the rows of the live curve."""
    rng = np.random.default_rng(2)
    warmed = LiveAllan(1000.0)
    warmed.push(rng.normal(size=100_000))
    warmed.curve()
    live = LiveAllan(1000.0)
    times = []
    for _ in range(3000):
        samples = rng.normal(size=1000)
        start = time.process_time()
        live.push(samples)
        times.append(time.process_time() - start)
    median, late = np.median(times) * 1e3, np.percentile(times, 99) * 1e3
    missed = row(
        "streaming, push of 1000 samples, median",
        f"{median:.3f} ms",
        "",
        "",
        f"<= {PUSH_MS:g} ms",
        bool(median <= PUSH_MS),
    )
    row("streaming, push of 1000 samples, 99th percentile", f"{late:.3f} ms", "", "", "-", None)
    start = time.process_time()
    live.curve()
    taken = (time.process_time() - start) * 1e3
    row("streaming, the curve of 3 million samples", f"{taken:.1f} ms", "", "", "-", None)
    return missed


def hour(rng: np.random.Generator, case: str) -> FloatArray:
    """White noise, flicker by Fourier synthesis of four times the length, and a random walk."""
    n, b, k = CASES[case]
    y = rng.normal(size=HOUR) * n * 10.0 + np.cumsum(rng.normal(size=HOUR)) * k * 0.1
    if b:
        length = 1 << 21
        frequency = np.fft.rfftfreq(length, 0.01)
        density = np.zeros_like(frequency)
        density[1:] = b * b / (2.0 * np.pi * frequency[1:])
        parts = rng.normal(size=len(frequency)) + 1j * rng.normal(size=len(frequency))
        y += np.fft.irfft(parts * np.sqrt(50.0 * density * length), length)[:HOUR]
    return y


def noise_fit() -> int:
    """Print the row of the noise fit."""
    y = hour(np.random.default_rng(3), "B")
    fit_noise(y, 100.0)
    times = []
    for _ in range(10):
        start = time.process_time()
        fit_noise(y, 100.0)
        times.append(time.process_time() - start)
    taken = float(np.median(times))
    return row(
        "noise fit of 1 h x 100 Hz, all methods, intervals",
        f"{taken * 1e3:.0f} ms",
        "",
        "",
        f"<= {FIT_S:g} s",
        taken <= FIT_S,
    )


def table(repetitions: int) -> None:
    """Print accuracy and coverage of the coefficients."""
    print(f"\n{repetitions} records of 1 h at 100 Hz a case; errors in % of the truth")
    print("case method         term                  rmse    bias  covered  limits  mean limit")
    for case, truth in CASES.items():
        rng = np.random.default_rng(5)
        found: dict[tuple[str, str], list[tuple[float, bool, bool, float]]] = {}
        for _ in range(repetitions):
            for one in fit_noise(hour(rng, case), 100.0).rows:
                if one.term in TERMS:
                    true = truth[TERMS.index(one.term)]
                    inside = one.lower <= true <= one.upper
                    found.setdefault((one.method, one.term), []).append(
                        (one.value, inside, one.upper_limit, one.upper)
                    )
        for (method, term), rows in found.items():
            true = truth[TERMS.index(term)]
            values, inside, limits, uppers = (
                np.array(column) for column in zip(*rows, strict=True)
            )
            scale = 100.0 / true if true else 1.0
            rmse = np.sqrt(np.mean((values - true) ** 2)) * scale
            bias = (values.mean() - true) * scale
            limit = f"{uppers[limits].mean() * scale:.3g}" if limits.any() else "-"
            print(
                f"{case:4s} {method:14s} {term:18s} {rmse:8.3g} {bias:7.2g} {inside.mean():7.1%}"
                f" {limits.mean():7.1%}  {limit}"
            )


def main() -> int:
    """Print the rows; return the number of targets missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--full", action="store_true", help="also a day at 1 kHz")
    parser.add_argument("--table", type=int, default=0, metavar="N", help="accuracy, N records")
    parser.add_argument("--alone", help=argparse.SUPPRESS)
    parser.add_argument("--samples", type=int, default=HOUR, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.alone:
        alone(arguments.alone, arguments.samples)
        return 0
    missed = deviations(HOUR) + streaming() + noise_fit()
    if arguments.full:
        missed += deviations(DAY)
    if arguments.table:
        table(arguments.table)
    return missed


if __name__ == "__main__":
    raise SystemExit(main())
