"""Accelerometers on the head and the attitude that they give, for ``calrig fit``."""

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError
from core.fit.result import FitResult
from core.procedures.attitude import attitude
from core.procedures.calibration import Calibration
from core.procedures.dividing_head import calibrate
from core.records.calibration_json import calibration_text, equation
from core.samples.run import Run
from gui.commands.fitted import Fitted, note_lines


def fit_accelerometers(fitted: Fitted) -> None:
    """Bias, scale factor and cross-axis sensitivity of every accelerometer of a head run."""
    calibration = calibrate(fitted.run, fitted.conditions)
    fitted.calibration = calibration
    fitted.give(**_plain(calibration))
    fitted.say(*_report(fitted.path, calibration))


def _plain(calibration: Calibration) -> dict[str, object]:
    over_k = [calibration.bias_in_input(c)[0] for c in range(len(calibration.fits))]
    plain: dict[str, object] = {
        "calibration": json.loads(calibration_text(calibration)),
        "bias_over_k_mps2": over_k,
        "bias_mps2": over_k,  # what the unit reads at zero input; of a triad Q U0, (2.5)
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
        lines.append(f"    U0/k  {bias:.6g} m/s^2, u = {u:.2g}")
        lines.append(f"    {_scatter(fit, calibration.unit)}")
        lines += note_lines(fit.notes, "    ")
    if calibration.is_triad:
        lines += [f"  Q  {row}" for row in np.array2string(calibration.triad().q).splitlines()]
    return lines + note_lines(calibration.notes, "  ")


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


def fit_attitude(fitted: Fitted) -> None:
    """Pitch and roll of each row by the calibration of the file before."""
    path, measured, calibration = fitted.path, fitted.run, fitted.calibration
    if calibration is None:
        raise FitError(f"{path}: name a file of positions before it, to calibrate the codes by")
    triad = calibration.triad()
    codes = _codes(path, measured, [f"acc_{axis}" for axis in "xyz"])
    a = triad.calibrated(codes)
    found = attitude(a, triad.calibrated_covariance(codes, np.zeros_like(codes)))
    fitted.give(a=a, norm=np.linalg.norm(a, axis=1), attitude=found)
    fitted.say(f"{path}: by the calibration of {calibration.provenance.device}")
    own = measured.extra.get("unit_pitch_deg")
    for row in range(len(codes)):
        beside = "" if own is None else f"; the unit itself says {own[row]:.2f}"
        fitted.say(
            f"  pitch {found.pitch[row]:.4f} (u = {found.u_pitch[row]:.2g}) deg, roll"
            f" {found.roll[row]:.4f} deg{beside}"
        )


def _codes(path: Path, measured: Run, columns: list[str]) -> FloatArray:
    known: Mapping[str, FloatArray] = {
        **measured.extra,
        **{name: measured.y[:, place] for place, name in enumerate(measured.channels)},
    }
    missing = [name for name in columns if name not in known]
    if missing:
        raise FitError(f"{path}: holds no raw codes of the accelerometers ({', '.join(missing)})")
    return np.column_stack([known[name] for name in columns])
