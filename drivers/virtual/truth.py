"""Estimates beside the hidden truth of the rig, for demonstrations and tests."""

from dataclasses import dataclass

from core.procedures.calibration import Calibration
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
    hidden = {output.role: output for output in rig.truth()}
    rows: list[Compared] = []
    for name, fit in zip(calibration.channels, calibration.fits, strict=True):
        which = name.rpartition("_")[2]
        triad = "acc." if calibration.sensor == "accelerometer" else "rate."
        output = hidden[f"{triad if which in 'xyz' else 'adc.'}{which}"]
        for parameter, value, half in zip(fit.parameters, fit.values, fit.expanded(), strict=True):
            truth = output.value(parameter.name)
            covered = bool(abs(value - truth) <= half)
            rows.append(
                Compared(
                    name,
                    parameter.symbol,
                    parameter.unit,
                    float(value),
                    float(half),
                    truth,
                    covered,
                )
            )
    return tuple(rows)


def report(rows: tuple[Compared, ...]) -> list[str]:
    """The comparison as lines of text."""
    lines = [
        f"{row.channel:<6} {row.symbol:<6} {row.estimate:>13.6g} +- {row.expanded:<9.2g}"
        f" truth {row.truth:>13.6g} {row.unit}{'' if row.covered else '  outside'}"
        for row in rows
    ]
    held = sum(row.covered for row in rows)
    return [*lines, f"{held} of {len(rows)} intervals (95 %) hold the truth"]
