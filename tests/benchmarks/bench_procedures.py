"""The methods beside the dividing head: their speed, and the drift table against its rivals."""

import gzip
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.allan.model import NoiseModel
from core.plans.plan import load_plans
from core.procedures.drift.compensate import compensate
from core.procedures.drift.curves import Curves, curves_of
from core.procedures.drift.held_out import METHODS, broken_line, residuals_of
from core.procedures.drift.simulated import AMBIENTS, SHARP_NOISE, SMOOTH_NOISE, turn_on
from core.procedures.drift.turn_on import TurnOn
from core.procedures.fourier.readings import run_of_angles
from core.procedures.fourier.tumble import calibrate_tumble
from core.procedures.north_seeking import Seeking, heading_uncertainty
from core.procedures.prediction.bench import Bench
from core.procedures.prediction.propose import propose
from core.procedures.thermal.record import fit_record
from core.samples.run import Conditions, Run
from tests.plain_run import plain_run

DPH = 3600.0
DEVICES = 4
CALIBRATIONS, HELD = 5, 3
KNOTS = 10
RECORD = Path(__file__).parents[1] / "data" / "tofupilot_imu_thermal" / "imu_thermal.csv.gz"


class Rows:
    """Print the rows and count the targets that were missed."""

    def __init__(self) -> None:
        self.missed = 0

    def row(
        self, name: str, value: float, unit: str, peer: str, ratio: float, target: str, ok: bool
    ) -> None:
        self.missed += not ok
        print(
            f"{name:<46} {value:9.4g} {unit:<6} | {peer:<38} | x{ratio:<7.3g} | {target:<12} |"
            f" {'ok' if ok else 'MISSED'}"
        )


def seconds(work: Callable[[], object], repeats: int) -> float:
    """Median CPU time of one call."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return float(np.median(times))


def turn_ons(device: int, seed: int, count: int, kind: str, noise: float) -> list[TurnOn]:
    rng = np.random.default_rng(seed)
    made = []
    for ambient in AMBIENTS:
        for number in range(count):
            y, chip = turn_on(rng, float(ambient), device, kind=kind, noise=noise)
            made.append(TurnOn(f"{ambient:g}/{number}", float(ambient), y, 1000.0, chip))
    return made


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2))) * DPH


def left(calibrated: Curves, held: Curves) -> dict[str, float]:
    """What each method leaves on turn-ons that it has not seen, deg/h."""
    mean, t = calibrated.mean, calibrated.t
    found = {
        name: rms(held.y - fit(t, mean, KNOTS)[held.place])
        for name, fit in METHODS.items()
        if name != "table"
    }
    uniform = broken_line(t, mean, np.linspace(2.0, 120.0, KNOTS))
    found["uniform"] = rms(held.y - uniform[held.place])
    table = compensate(calibrated, "deg/s", knots=KNOTS).table
    found["table"] = rms(residuals_of(table, held))
    return found


def drift(rows: Rows, kind: str, noise: float) -> None:
    """Table 1 of source 003 on simulated devices; geometric means over them."""
    results: list[dict[str, float]] = []
    for device in range(DEVICES):
        calibrated = curves_of(turn_ons(device, device, CALIBRATIONS, kind, noise))
        held = curves_of(turn_ons(device, 100 + device, HELD, kind, noise))
        results.append(left(calibrated, held))
    mean = {
        name: float(np.exp(np.mean([np.log(one[name]) for one in results]))) for name in results[0]
    }
    table, title = mean["table"], f"drift, {kind}, {KNOTS} knots, held out"
    for name in ("none", "cubic", "quartic", "angles", "uniform", "mean"):
        ratio = mean[name] / table
        target, ok = "", True
        if kind == "sharp":
            target, ok = {
                "none": ("5 ... 20 x", ratio >= 5.0),
                "quartic": (">= 2.5 x", ratio >= 2.5),
                "mean": ("<= 1.15 fl.", table <= 1.15 * mean["mean"]),
            }.get(name, ("", True))
        peer = {"mean": "mean curve (floor)", "angles": "source's angles"}.get(name, name)
        rows.row(title, table, "deg/h", f"{peer} {mean[name]:.4g} deg/h", ratio, target, ok)


def between(rows: Rows) -> None:
    """Calibrated every 20 degC, tested halfway."""
    ratios, values = [], []
    for device in range(DEVICES):
        made = turn_ons(device, device, CALIBRATIONS, "sharp", SHARP_NOISE)
        coarse = curves_of([one for one in made if (one.ambient_c + 40.0) % 20.0 == 0.0])
        others = turn_ons(device, 200 + device, HELD, "sharp", SHARP_NOISE)
        halfway = curves_of([one for one in others if (one.ambient_c + 40.0) % 20.0 != 0.0])
        table = compensate(coarse, "deg/s", knots=KNOTS).table
        values.append(rms(residuals_of(table, halfway)))
        ratios.append(rms(halfway.y) / values[-1])
    value = float(np.exp(np.mean(np.log(values))))
    ratio = float(np.exp(np.mean(np.log(ratios))))
    rows.row(
        "drift, sharp, between temperatures 20 degC apart",
        value,
        "deg/h",
        f"none {value * ratio:.4g} deg/h",
        ratio,
        ">= 5 x",
        ratio >= 5.0,
    )


def speed(rows: Rows) -> None:
    made = turn_ons(0, 0, CALIBRATIONS, "sharp", SHARP_NOISE)
    joint = seconds(lambda: compensate(curves_of(made), "deg/s", limit=16), 5)
    rows.row(
        "joint knots, 11 T x 120 s x 1 kHz x 5, with CV",
        joint,
        "s",
        "",
        1.0 / joint,
        "< 1.0 s",
        joint < 1.0,
    )
    head = np.arange(5.0, 401.0, 5.0)
    readings = (
        2.5
        - np.sin(np.radians(head + 0.7))[:, None]
        + 1e-4 * np.random.default_rng(0).standard_normal((80, 5))
    )
    run, case = run_of_angles(head, readings, "V"), Conditions(g_mps2=9.8106)
    tumble = seconds(lambda: calibrate_tumble(run, case), 100)
    design = np.column_stack(
        [f(n * np.radians(np.tile(head, 5))) for n in (1, 2) for f in (np.sin, np.cos)]
    )
    bare = seconds(lambda: np.linalg.lstsq(design, readings.T.ravel(), rcond=None), 100)
    rows.row(
        "Fourier fit, 80 x 5, all uncertainties and checks",
        tumble * 1e3,
        "ms",
        f"bare lstsq {bare * 1e3:.3g} ms",
        tumble / bare,
        "< 5 ms",
        tumble < 5e-3,
    )
    record = standing()
    thermal = seconds(lambda: fit_record(record), 20)
    plain = seconds(lambda: np.polyfit(record.temperature_c, record.y, 3), 20)
    rows.row(
        "thermal record, 8400 rows x 3, order by CV",
        thermal * 1e3,
        "ms",
        f"polyfit of order 3 {plain * 1e3:.3g} ms",
        thermal / plain,
        "< 50 ms",
        thermal < 50e-3,
    )
    bench = Bench("accelerometer", NoiseModel(random_walk=3e-3, bias_instability=1e-4), case)
    plans = load_plans().values()
    proposed = seconds(lambda: propose(plans, bench), 5)
    rows.row(
        "propose: every plan predicted",
        proposed * 1e3,
        "ms",
        "",
        1.0,
        "< 100 ms",
        proposed < 0.1,
    )


def standing() -> Run:
    with gzip.open(RECORD, "rt", encoding="utf-8") as file:
        table = np.genfromtxt(file, delimiter=",", names=True)
    return plain_run(
        test="record",
        sensor="gyro",
        device="chamber",
        channels=("x", "y", "z"),
        unit="deg/s",
        y=np.column_stack([table[f"rate_{axis}"] for axis in "xyz"]),
        temperature_c=table["temperature_c"],
        t_s=table["t_s"],
    )


def compass(rows: Rows) -> None:
    """The source's figure, and what other steps would do in the same time."""
    noise = NoiseModel(random_walk=2.0e-5, bias_instability=1.0e-6, rate_random_walk=5e-8)
    quarters = heading_uncertainty(noise, Seeking(50.45), 10.0)
    for steps in (3, 8, 12):
        headings = tuple(np.arange(steps) * 360.0 / steps)
        average = (4 * 15.0 - steps * 5.0) / steps
        if average <= 0.0:
            continue
        other = heading_uncertainty(noise, Seeking(50.45, headings), average)
        rows.row(
            "heading, 4 steps of 90 deg, 10 s each",
            quarters,
            "deg",
            f"{steps} steps in the same minute {other:.3g} deg",
            other / quarters,
            "0.1 deg",
            quarters <= 0.1,
        )


def main() -> int:
    """Print the rows; return the number of targets missed."""
    rows = Rows()
    speed(rows)
    drift(rows, "sharp", SHARP_NOISE)
    drift(rows, "smooth", SMOOTH_NOISE)
    between(rows)
    compass(rows)
    return rows.missed


if __name__ == "__main__":
    raise SystemExit(main())
