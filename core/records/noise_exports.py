"""Noise studies as files: Kalibr's ``imu.yaml``, MATLAB, CSV of coefficients and of curves."""

import csv
import io
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from core.allan.conventions import conventions
from core.errors import FitError
from core.records.atomic import write_bytes_atomic
from core.records.noise_study import NoiseStudy
from core.records.noise_tables import published_row, quote
from core.version import SOFTWARE

Studies = Sequence[NoiseStudy]


@dataclass(frozen=True, slots=True)
class NoiseExport:
    """One format.

    Parameters
    ----------
    title : for the list of formats
    suffix : of the file
    content : returns the bytes
    """

    title: str
    suffix: str
    content: Callable[[Studies], bytes]


def export_noise(studies: Studies, key: str, path: Path) -> None:
    """Write studies in the format `key` of NOISE_EXPORTS.

    Raises
    ------
    FitError
        The format cannot hold these studies.
    StorageError
        The file could not be written.
    """
    write_bytes_atomic(path, NOISE_EXPORTS[key].content(studies))


def kalibr_yaml(studies: Studies) -> str:
    """Return the text of Kalibr's ``imu.yaml``.

    Kalibr's noise density is the two-sided N in continuous time, its random walk is K. Axes of one
    sensor are joined by their root mean square; a K that was not detected is given by its limit.

    Raises
    ------
    FitError
        No record is in deg/s or m/s^2, or their rates differ.
    """
    kinds = {
        "accelerometer": ("m/s^2", "density", "m/s^2/sqrt(Hz)", "m/s^3/sqrt(Hz)"),
        "gyroscope": ("deg/s", "radian", "rad/s/sqrt(Hz)", "rad/s^2/sqrt(Hz)"),
    }
    used = [one for one in studies if one.unit in {kind[0] for kind in kinds.values()}]
    if not used:
        units = ", ".join(dict.fromkeys(one.unit for one in studies)) or "none"
        raise FitError(
            f"Kalibr needs records in deg/s or m/s^2, not in {units}: state the scale factor"
        )
    rates = {one.rate for one in used}
    if max(rates) > 1.001 * min(rates):
        said = ", ".join(f"{rate:g} Hz" for rate in sorted(rates))
        raise FitError(f"the records have different rates ({said}): choose those of one device")
    lines = [
        f"# {SOFTWARE}; continuous-time values as measured, sensor at rest.",
        "# Kalibr users often multiply them by 10 to 20 for what a record at rest does not show.",
    ]
    lines += [f"# {one.device} {one.channel}: {one.path}" for one in used]
    for sensor, (unit, convention, density, walk) in kinds.items():
        of_sensor = [one for one in used if one.unit == unit]
        if not of_sensor:
            lines.append(f"# {sensor}: no record")
            continue
        n, _ = _joined(of_sensor, "random_walk", convention)
        k, limited = _joined(of_sensor, "rate_random_walk", convention)
        doubt = ", upper limit: not detected" if limited else ""
        lines.append(f"{sensor}_noise_density: {n:.6e}  # {density}, N two-sided")
        lines.append(f"{sensor}_random_walk: {k:.6e}  # {walk}, K{doubt}")
    lines += ["rostopic: /imu0", f"update_rate: {max(rates):.9g}  # Hz", ""]
    return "\n".join(lines)


def _joined(studies: Studies, term: str, name: str) -> tuple[float, bool]:
    """Root mean square of the axes, and whether one of them is but a limit."""
    squares: list[float] = []
    limited = False
    for one in studies:
        row = published_row(one.published, term)
        if row is None:
            raise FitError(f"{one.device} {one.channel}: no noise model fits the record")
        chosen = next(c for c in conventions(term, one.unit) if c.name == name)
        squares.append(((row.upper if row.upper_limit else row.value) * chosen.factor) ** 2)
        limited = limited or row.upper_limit
    return math.sqrt(sum(squares) / len(squares)), limited


def coefficients_csv(studies: Studies) -> str:
    """Return every coefficient by every method in every convention, one a line."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    head = "device channel term symbol method convention unit value u lower95 upper95 upper_limit"
    writer.writerow([*head.split(), "regressed", "file"])
    for one in studies:
        tables = [(one.coefficients, "")]
        if one.after is not None and one.regression is not None:
            tables.append((one.after, " ".join(one.regression.names)))
        for found, regressed in tables:
            for row in found.rows:
                for convention in conventions(row.term, one.unit):
                    q = quote(row, convention)
                    numbers = [repr(x) for x in (q.value, q.u, q.lower, q.upper)]
                    limit = int(q.upper_limit)
                    words = (one.device, one.channel, q.term, q.symbol, q.method, q.text, q.unit)
                    writer.writerow([*words, *numbers, limit, regressed, one.path])
    return out.getvalue()


def curves_csv(studies: Studies) -> str:
    """Return the points of every curve, one a line; limits are of one sigma.

    The last column tells which deviation it is: ``allan``, or a key of `core.allan.other.KINDS`,
    to which no model is fitted.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    names = "device channel unit regressed tau_s deviation lower upper edf model kind"
    writer.writerow(names.split())
    for one in studies:
        tables = [(one.coefficients, 0)] + ([] if one.after is None else [(one.after, 1)])
        for found, regressed in tables:
            curve = found.curve
            fitted = np.sqrt(found.model.variance(curve.taus))
            columns = (curve.taus, curve.deviation, curve.lower, curve.upper, curve.edf, fitted)
            for row in np.column_stack(columns).tolist():
                told = (one.device, one.channel, one.unit, regressed)
                writer.writerow([*told, *map(repr, row), "allan"])
        if one.beside is not None:
            curve, regressed = one.beside, int(one.after is not None)
            columns = (curve.taus, curve.deviation, curve.lower, curve.upper, curve.edf)
            for row in np.column_stack(columns).tolist():
                told = (one.device, one.channel, one.unit, regressed)
                writer.writerow([*told, *map(repr, row), "", curve.mode])
    return out.getvalue()


def mat_bytes(studies: Studies) -> bytes:
    """Return a MATLAB file (version 5): one structure array ``noise``.

    ``noise(i)`` has ``.device``, ``.channel``, ``.unit``, ``.rate``, ``.tau``, ``.deviation``,
    ``.lower``, ``.upper``, ``.edf``, ``.coefficient(j)``, ``.notes``, ``.file`` and ``.software``.
    """
    from scipy.io import savemat

    names = ("device", "channel", "unit", "rate", "tau", "deviation", "lower", "upper", "edf")
    kinds = [(name, object) for name in (*names, "coefficient", "notes", "file", "software")]
    noise = np.empty(len(studies), dtype=kinds)
    for place, one in enumerate(studies):
        curve = one.published.curve
        columns = [
            array[:, None]
            for array in (curve.taus, curve.deviation, curve.lower, curve.upper, curve.edf)
        ]
        notes = np.empty(len(one.notes), dtype=object)
        notes[:] = [note.text for note in one.notes]
        told = (one.device, one.channel, one.unit, one.rate)
        noise[place] = (*told, *columns, _mat_rows(one), notes, one.path, SOFTWARE)
    out = io.BytesIO()
    # The stubs do not know that it takes open files as well as names.
    savemat(cast(Any, out), {"noise": noise}, long_field_names=True)
    return out.getvalue()


def _mat_rows(one: NoiseStudy) -> Any:
    fields = ("symbol", "term", "method", "unit", "value", "u", "lower", "upper", "upper_limit")
    rows = np.empty(len(one.published.rows), dtype=[(name, object) for name in fields])
    for place, row in enumerate(one.published.rows):
        rows[place] = tuple(getattr(row, name) for name in fields)
    return rows


NOISE_EXPORTS: dict[str, NoiseExport] = {
    "coefficients": NoiseExport(
        "Coefficients, CSV", ".csv", lambda studies: coefficients_csv(studies).encode()
    ),
    "curves": NoiseExport(
        "Curves, CSV", ".curves.csv", lambda studies: curves_csv(studies).encode()
    ),
    "kalibr": NoiseExport(
        "Kalibr imu.yaml", ".yaml", lambda studies: kalibr_yaml(studies).encode()
    ),
    "matlab": NoiseExport("MATLAB", ".mat", mat_bytes),
}
