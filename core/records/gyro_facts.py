"""What a file tells of gyros, for the comparison of lab 6: calibrations, runs, Allan results."""

import csv
import io
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from core.errors import FitError, FormatError, Note, Severity
from core.fit.estimate import Estimate, parameter, quotient, ratio
from core.fit.result import FitResult
from core.procedures.comparison import Column, Gyro, difference
from core.procedures.g_sensitivity import fit_g_sensitivity
from core.procedures.rate_table import calibrate_rate_table
from core.records.calibration_json import read_calibration
from core.records.noise_tables import METHODS
from core.records.open import read_any
from core.records.session.record import START_NAME
from core.records.text import decode, read_bytes
from core.samples.run import Conditions, Run

_NOISE_HEAD = "device,channel,term,"
_NOISE = {
    "random_walk": ("random_walk", "deg/sqrt(s)", "deg/s/sqrt(Hz)"),
    "bias_instability": ("bias_instability", "deg/s", "deg/s"),
}
"""Row, unit in the file and in the table of each term; N is two-sided in both."""
_RATE_ROWS = ("scale_factor", "nonlinearity", "asymmetry", "bias")
_G, _BIAS = "g_sensitivity", "bias"
_G_UNIT, _RATE = "(deg/s)/(m/s^2)", "deg/s"
_DIFFERS = 2.6
"""Standard uncertainties between two sources of one number that are worth a note."""


@dataclass(frozen=True, slots=True)
class Facts:
    """What one file tells of one gyro.

    Parameters
    ----------
    device, channel : which gyro
    source : the file
    quantities : estimates by the identifiers of `core.procedures.comparison.ROWS`
    in_output : bias and g-sensitivity in units of the output, where the file has no scale factor
    notes : doubts
    """

    device: str
    channel: str
    source: str
    quantities: Mapping[str, Estimate]
    in_output: Mapping[str, Estimate]
    notes: tuple[Note, ...] = ()

    @property
    def name(self) -> str:
        """How the gyro is called until the operator says otherwise."""
        return f"{self.device} {self.channel}".strip()


def read_facts(path: Path, conditions: Conditions) -> tuple[Facts, ...]:
    """Read what a file tells, one entry a gyro.

    Parameters
    ----------
    path : calibration (``.cal.json``), run on the rate table or the head of any format, or the
        table of coefficients that the Allan tab exports
    conditions : g where the file states none

    Raises
    ------
    FormatError, FitError
        The file is none of these, or holds no gyros.
    """
    if path.suffix == ".json" and path.name != START_NAME:
        return _of_calibration(path)
    if path.is_file() and path.suffix == ".csv":
        text = decode(read_bytes(path), path)
        if text.startswith(_NOISE_HEAD):
            return _of_noise(text, path)
    return _of_run(read_any(path), path, conditions)


def column_of(name: str, facts: Sequence[Facts]) -> tuple[Column, tuple[Note, ...]]:
    """Everything that several files tell of one gyro.

    Where two tell the same, the later one counts; if they differ by more than their uncertainties
    allow, a note says so.
    """
    found: dict[str, Estimate] = {}
    notes: list[Note] = []
    for one in facts:
        notes.extend(one.notes)
        for row, estimate in one.quantities.items():
            before = found.get(row)
            if before is not None and before.unit == estimate.unit:
                apart = difference(before, estimate)
                if apart > _DIFFERS:
                    text = (
                        f"{name}: two files differ in the {row.replace('_', ' ')} by"
                        f" {apart:.1f} standard uncertainties; that of {one.source} is shown"
                    )
                    notes.append(Note(Severity.WARNING, "sources_differ", text))
            found[row] = estimate
    k = found.get("scale_factor")
    for one in facts:
        for row, estimate in one.in_output.items():
            if row in found:
                continue
            if k is None:
                text = (
                    f"{name}: the {row.replace('_', ' ')} of {one.source} is in"
                    f" {estimate.unit}; its scale factor is missing: add a run on the rate table"
                )
                notes.append(Note(Severity.INFO, "no_scale_factor", text))
            else:
                found[row] = quotient(estimate, k, _G_UNIT if row == _G else _RATE)
    return Column(name, found), tuple(dict.fromkeys(notes))


def _of_calibration(path: Path) -> tuple[Facts, ...]:
    calibration = read_calibration(path)
    if calibration.sensor != "gyro":
        raise FitError(f"{path.name} is a calibration of accelerometers; gyros are compared here")
    return tuple(
        _of_fit(calibration.provenance.device, channel, path.name, fit)
        for channel, fit in zip(calibration.channels, calibration.fits, strict=True)
    )


def _of_fit(device: str, channel: str, source: str, fit: FitResult) -> Facts:
    """What the parameters of a fit tell."""
    names = [name for name in fit.names if name.startswith(f"{_G}_")]
    largest = max(names, key=lambda name: abs(parameter(fit, name).value), default="")
    quantities: dict[str, Estimate] = {}
    in_output: dict[str, Estimate] = {}
    if "scale_factor" in fit.names:
        quantities["scale_factor"] = parameter(fit, "scale_factor")
        quantities[_BIAS] = ratio(fit, _BIAS, "scale_factor", _RATE)
        if largest:
            quantities[_G] = ratio(fit, largest, "scale_factor", _G_UNIT)
    else:
        in_output[_BIAS] = parameter(fit, _BIAS)
        if largest:
            in_output[_G] = parameter(fit, largest)
    return Facts(device, channel, source, quantities, in_output)


def _of_run(run: Run, path: Path, conditions: Conditions) -> tuple[Facts, ...]:
    if run.sensor != "gyro":
        raise FitError(f"{path.name} holds accelerometers; gyros are compared here")
    conditions = _stated(run.conditions, conditions)
    if run.test == "rate_table":
        gyros = [
            (sensor.channel, Gyro(sensor.channel, rate=sensor), sensor.notes)
            for sensor in calibrate_rate_table(run, conditions).sensors
        ]
        return tuple(
            Facts(run.device, channel, path.name, _known(gyro, _RATE_ROWS), {}, notes)
            for channel, gyro, notes in gyros
        )
    if run.test == "static_positions":
        return tuple(
            _of_fit(run.device, sensor.channel, path.name, sensor.fit)
            for sensor in fit_g_sensitivity(run, conditions).sensors
        )
    raise FitError(f"{path.name} holds the test {run.test!r}; it tells nothing that is compared")


def _stated(of_run: Conditions, otherwise: Conditions) -> Conditions:
    """What the run states of g, latitude and settings, and the other where it states nothing."""
    names = ("g_mps2", "u_g_mps2", "latitude_deg", "head_u_arcsec", "rate_u_ppm", "rate_u_dps")
    told = {name: getattr(of_run, name) for name in names}
    stated = {name: value for name, value in told.items() if math.isfinite(value)}
    return replace(otherwise, **stated)


def _known(gyro: Gyro, rows: tuple[str, ...]) -> dict[str, Estimate]:
    found = {row: gyro.quantity(row) for row in rows}
    return {row: estimate for row, estimate in found.items() if estimate is not None}


def _of_noise(text: str, path: Path) -> tuple[Facts, ...]:
    """The best value of each term of each channel; after a regression, where there was one."""
    best: dict[tuple[str, str], dict[str, tuple[int, Estimate | None, float]]] = {}
    try:
        for line in csv.DictReader(io.StringIO(text)):
            row, unit, shown = _NOISE.get(line["term"], ("", "", ""))
            if not row or line["unit"] != unit or line["method"] not in METHODS:
                continue
            rank = METHODS.index(line["method"]) - (len(METHODS) if line["regressed"] else 0)
            terms = best.setdefault((line["device"], line["channel"]), {})
            if row in terms and terms[row][0] <= rank:
                continue
            estimate = Estimate(float(line["value"]), float(line["u"]), float("inf"), shown)
            limit = line["upper_limit"] != "0"
            terms[row] = (rank, None if limit else estimate, float(line["upper95"]))
    except (KeyError, TypeError, ValueError, csv.Error) as error:
        raise FormatError(path, f"is no table of noise coefficients: {error}") from error
    if not best:
        raise FitError(f"{path.name} holds no noise of a gyro in deg/s; state its scale factor")
    return tuple(
        Facts(
            device,
            channel,
            path.name,
            {row: estimate for row, (_, estimate, _) in terms.items() if estimate is not None},
            {},
            tuple(
                Note(
                    Severity.INFO,
                    "not_detected",
                    f"{device} {channel}: the {row.replace('_', ' ')} was not detected, it is"
                    f" below {upper:.2g} {_NOISE[row][2]} (95 %)",
                )
                for row, (_, estimate, upper) in terms.items()
                if estimate is None
            ),
        )
        for (device, channel), terms in best.items()
    )
