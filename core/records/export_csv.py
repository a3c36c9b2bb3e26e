"""A calibration as a table for spreadsheets.

Comment lines begin with ``#``; then one row a parameter, and for a triad one row an element of Q.
The second form is what spreadsheets of Ukrainian computers open by a double click: semicolons and
decimal commas (the file gets a BOM, without which they take UTF-8 for CP1251).
"""

import csv
import io
import math

from core.model.effect import AXES
from core.procedures.calibration import Calibration
from core.records.calibration_json import INPUT_UNITS, equation
from core.records.names import name_in_file

COLUMNS = ("channel", "axis", "parameter", "symbol", "value", "u", "U95", "dof", "unit")
"""Estimate, standard uncertainty, half width of the 95 % interval, its degrees of freedom."""

Cell = str | float


def csv_text(calibration: Calibration) -> str:
    """The table with commas and decimal points."""
    return _text(calibration, ",", ".")


def excel_text(calibration: Calibration) -> str:
    """The table with semicolons and decimal commas."""
    return _text(calibration, ";", ",")


def _text(calibration: Calibration, separator: str, decimal: str) -> str:
    out = io.StringIO()
    writer = csv.writer(out, delimiter=separator, lineterminator="\r\n")
    for line in _head(calibration):
        writer.writerow([f"# {line}"])
    writer.writerow(COLUMNS)
    for row in (*_parameters(calibration), *_matrix(calibration)):
        writer.writerow([_cell(cell, decimal) for cell in row])
    return out.getvalue()


def _head(calibration: Calibration) -> list[str]:
    provenance = calibration.provenance
    return [
        name_in_file(line)
        for line in (
            f"device: {provenance.device}, {calibration.sensor}",
            f"equation: {equation(calibration)}",
            f"procedure: {provenance.procedure}",
            f"profile: {provenance.profile or '-'}; plan: {provenance.plan or '-'}",
            f"local g: {calibration.conditions.g_mps2!r} m/s^2",
            f"temperature: {calibration.temperature_c!r} degC",
            f"measured: {provenance.measured_utc or '-'}",
            f"computed: {provenance.computed_utc or '-'} by {provenance.software or '-'}",
            *(f"data: {name}, SHA-256 {sha}" for name, sha in provenance.records),
            *(f"{note.severity.value}: {note.text}" for note in calibration.notes),
            *_effects(calibration),
        )
    ]


def _effects(calibration: Calibration) -> list[str]:
    """What was added to the plain model of each sensor."""
    return [
        f"added to {name}: {one.name}, {one.equation}; {one.reach}"
        for name, own in zip(calibration.channels, calibration.effects, strict=False)
        for one in own
    ]


def _parameters(calibration: Calibration) -> list[tuple[Cell, ...]]:
    return [
        (name, axis, p.name, p.symbol, *numbers, p.unit)
        for name, axis, fit in zip(
            calibration.channels, calibration.axes, calibration.fits, strict=True
        )
        for p, *numbers in zip(
            fit.parameters,
            fit.values.tolist(),
            fit.stderr.tolist(),
            fit.expanded().tolist(),
            fit.t_dof.tolist(),
            strict=True,
        )
    ]


def _matrix(calibration: Calibration) -> list[tuple[Cell, ...]]:
    if not calibration.is_triad:
        return []
    triad = calibration.triad()
    unit = f"({INPUT_UNITS[calibration.sensor]})/{calibration.unit}"
    return [
        (
            *("", AXES[i], f"Q_{AXES[i]}{AXES[j]}", f"q_{i + 1}{j + 1}"),
            *(float(triad.q[i, j]), float(triad.u_q()[i, j]), math.nan, math.nan, unit),
        )
        for i in range(3)
        for j in range(3)
    ]


def _cell(cell: Cell, decimal: str) -> str:
    if isinstance(cell, str):
        return cell
    return "" if math.isnan(cell) else repr(cell).replace(".", decimal)
