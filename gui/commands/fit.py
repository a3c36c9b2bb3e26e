"""FILE is a session's folder, a run file or a legacy text file.

Legacy files of Pointer's accuracy check, named after a file of positions, are evaluated with the
calibration from that: pitch and roll from the raw codes beside the unit's own.
"""

import argparse
import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from core.errors import FitError, Note
from core.fit.result import FitResult
from core.procedures.attitude import attitude
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import calibration_text, equation
from core.records.open import read_any
from core.samples.run import Run
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the files, the mounts and the laboratory's statements."""
    parser.add_argument("file", nargs="+", type=Path, help="what was measured")
    parser.add_argument(
        "--mount",
        action="append",
        metavar="MOUNT",
        help="how the unit stood in the 1st, 2nd, ... pass of a file that does not say it: X_from,"
        " Y_to@90, ...",
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Fit every file of positions and evaluate the accuracy files after it."""
    data: list[dict[str, object]] = []
    lines: list[str] = []
    calibration: Calibration | None = None
    for path in args.file:
        measured = read_any(path, mounts=args.mount)
        if measured.test == "accuracy":
            data.append(_accuracy(path, measured, calibration, lines))
            continue
        if measured.sensor != "accelerometer":
            raise FitError(f"{path}: holds no accelerometer on the dividing head")
        conditions, assumed = conditions_of(args, measured.conditions)
        calibration = calibrate(measured, conditions)
        data.append(_plain(path, calibration))
        lines += _report(path, calibration)
        if assumed:
            lines.append(f"  g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g")
    return Answer({"results": data}, "\n".join(lines))


def _plain(path: Path, calibration: Calibration) -> dict[str, object]:
    plain: dict[str, object] = {
        "file": path,
        "calibration": json.loads(calibration_text(calibration)),
        "bias_mps2": [calibration.bias_in_input(c)[0] for c in range(len(calibration.fits))],
        "misalignment_rad": [calibration.misalignment(c)[0] for c in range(len(calibration.fits))],
    }
    if calibration.is_triad:
        triad = calibration.triad()
        plain["bias_mps2"] = triad.q @ triad.bias
        plain["det_K"] = triad.determinant
        plain["cond_K"] = triad.condition
        plain["decomposition"] = triad.decompose()
    return plain


def _report(path: Path, calibration: Calibration) -> list[str]:
    lines = [f"{path}: {calibration.provenance.device}, {calibration.provenance.procedure}"]
    lines.append(f"  {equation(calibration)}; g = {calibration.conditions.g_mps2} m/s^2")
    for place, (name, fit) in enumerate(zip(calibration.channels, calibration.fits, strict=True)):
        lines.append(f"  {name}, axis {calibration.axes[place].upper()}")
        lines += [f"    {line}" for line in _parameters(fit)]
        bias, u = calibration.bias_in_input(place)
        lines.append(f"    bias  {bias:.6g} m/s^2, u = {u:.2g}")
        lines.append(f"    {_scatter(fit, calibration.unit)}")
        lines += _notes(fit.notes, "    ")
    if calibration.is_triad:
        lines += [f"  Q  {row}" for row in np.array2string(calibration.triad().q).splitlines()]
    return lines + _notes(calibration.notes, "  ")


def _parameters(fit: FitResult) -> list[str]:
    return [
        f"{p.symbol:<6} {value:>14.8g} +- {half:.2g} {p.unit}  (95 %)"
        for p, value, half in zip(fit.parameters, fit.values, fit.expanded(), strict=True)
    ]


def _scatter(fit: FitResult, unit: str) -> str:
    worst = float(np.abs(fit.residuals).max())
    sentence = f"largest residual {worst:.4g} {unit}, {fit.dof} degrees of freedom"
    if fit.lack_of_fit is not None:
        lack = fit.lack_of_fit
        sentence += f"; repeated positions scatter by {lack.pure_sd:.3g} (p = {lack.p_value:.2g})"
    return sentence


def _notes(notes: tuple[Note, ...], indent: str) -> list[str]:
    return [f"{indent}{note.severity.value}: {note.text}" for note in notes]


def _accuracy(
    path: Path, measured: Run, calibration: Calibration | None, lines: list[str]
) -> dict[str, object]:
    """Pitch and roll of each row by the calibration of the file before."""
    if calibration is None:
        raise FitError(f"{path}: name a file of positions before it, to calibrate the codes by")
    triad = calibration.triad()
    columns = [f"acc_{axis}" for axis in "xyz"]
    codes = _codes(path, measured, columns)
    a = triad.calibrated(codes)
    found = attitude(a, triad.calibrated_covariance(codes, np.zeros_like(codes)))
    lines.append(f"{path}: by the calibration of {calibration.provenance.device}")
    for row in range(len(codes)):
        own = measured.extra.get("unit_pitch_deg")
        beside = "" if own is None else f"; the unit itself says {own[row]:.2f}"
        lines.append(
            f"  pitch {found.pitch[row]:.4f} (u = {found.u_pitch[row]:.2g}) deg, roll"
            f" {found.roll[row]:.4f} deg{beside}"
        )
    return {"file": path, "a": a, "norm": np.linalg.norm(a, axis=1), "attitude": found}


def _codes(path: Path, measured: Run, columns: list[str]) -> np.ndarray:
    known: Mapping[str, np.ndarray] = {
        **measured.extra,
        **{name: measured.y[:, place] for place, name in enumerate(measured.channels)},
    }
    missing = [name for name in columns if name not in known]
    if missing:
        raise FitError(f"{path}: holds no raw codes of the accelerometers ({', '.join(missing)})")
    return np.column_stack([known[name] for name in columns])
