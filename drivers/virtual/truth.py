"""Estimates beside the hidden truth of the rig, for demonstrations and tests."""

from collections.abc import Iterable
from dataclasses import dataclass

from core.fit.estimate import Estimate
from core.fit.result import FitResult
from core.procedures.calibration import Calibration
from core.procedures.rate_table import RateTable
from drivers.virtual.devices import Output
from drivers.virtual.rig import Rig


@dataclass(frozen=True, slots=True)
class Compared:
    """One estimated parameter beside the hidden truth.

    Parameters
    ----------
    channel, symbol, unit : which parameter
    estimate, expanded : value and half width of its 95 % interval
    truth : what the rig really did
    covered : whether the interval holds the truth
    """

    channel: str
    symbol: str
    unit: str
    estimate: float
    expanded: float
    truth: float
    covered: bool


def compare(calibration: Calibration, rig: Rig) -> tuple[Compared, ...]:
    """Put every parameter of a calibration beside the truth of the rig that it was measured on."""
    pairs = zip(calibration.channels, calibration.fits, strict=True)
    triad = "acc." if calibration.sensor == "accelerometer" else "rate."
    return tuple(row for channel, fit in pairs for row in _of_fit(channel, fit, triad, rig))


def compare_rates(table: RateTable, rig: Rig) -> tuple[Compared, ...]:
    """Put scale factors and cross-axis sensitivities beside the truth.

    The zeros are left out: each mounting has its own, with what gravity adds to it.
    """
    rows: list[Compared] = []
    for sensor in table.sensors:
        hidden = _hidden(sensor.channel, "rate.", rig)
        for line in (sensor.line, *sensor.others):
            other = line.symbol.removeprefix("k_").removeprefix(sensor.axis)
            name = f"cross_axis_{other}" if other else "scale_factor"
            truth = hidden.value(name)
            rows.append(_compared(sensor.channel, line.symbol, line.slope, truth))
    return tuple(rows)


def _of_fit(channel: str, fit: FitResult, triad: str, rig: Rig) -> Iterable[Compared]:
    hidden = _hidden(channel, triad, rig)
    rows = zip(fit.parameters, fit.values, fit.stderr, fit.t_dof, strict=True)
    for parameter, value, u, dof in rows:
        estimate = Estimate(float(value), float(u), float(dof), parameter.unit)
        yield _compared(channel, parameter.symbol, estimate, hidden.value(parameter.name))


def _hidden(channel: str, triad: str, rig: Rig) -> Output:
    which = channel.rpartition("_")[2]
    role = f"{triad if which in 'xyz' else 'adc.'}{which}"
    return next(output for output in rig.truth() if output.role == role)


def _compared(channel: str, symbol: str, estimate: Estimate, truth: float) -> Compared:
    half = estimate.expanded()
    covered = bool(abs(estimate.value - truth) <= half)
    return Compared(channel, symbol, estimate.unit, estimate.value, half, truth, covered)


def report(rows: tuple[Compared, ...]) -> list[str]:
    """The comparison as lines of text."""
    lines = [
        f"{row.channel:<6} {row.symbol:<6} {row.estimate:>13.6g} +- {row.expanded:<9.2g}"
        f" truth {row.truth:>13.6g} {row.unit}{'' if row.covered else '  outside'}"
        for row in rows
    ]
    held = sum(row.covered for row in rows)
    return [*lines, f"{held} of {len(rows)} intervals (95 %) hold the truth"]
