"""FILE is a run of three accelerometers in six orthogonal positions or more.

Twelve parameters are fitted and split as K = diag(k) T^-1 R; the nine parameters of the source
stand beside them.
"""

import argparse
from pathlib import Path

from core.procedures.six_position import SixPosition, calibrate_six
from core.records.open import read_any
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of
from gui.commands.fitted import estimate_text, note_lines


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the file and the laboratory's statements."""
    parser.add_argument("file", type=Path)
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Fit and split."""
    measured = read_any(args.file, sensor="accelerometer")
    conditions, assumed = conditions_of(args, measured.conditions)
    found = calibrate_six(measured, conditions)
    data = {
        "file": args.file,
        "g_mps2": conditions.g_mps2,
        "K": found.triad.k,
        "u_K": found.triad.u_k(),
        "U0": found.triad.bias,
        "u_U0": found.triad.u_bias(),
        "scale": found.scale,
        "skew": found.skew,
        "mounting": found.mounting,
        "residual_mg": found.residual_mg,
        "nine_parameters": found.nine,
        "notes": (*found.calibration.notes, *found.notes),
    }
    lines = [f"{args.file}: {measured.device}", *_lines(found)]
    if assumed:
        lines.append(f"  g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g")
    return Answer(data, "\n".join(lines))


def _lines(found: SixPosition) -> list[str]:
    lines = ["  U = diag(k) T^-1 R a + U0"]
    lines += [
        f"  {estimate_text(f'k_{axis}', one)}" for axis, one in zip("xyz", found.scale, strict=True)
    ]
    skew = {"a_yz": found.skew.yz, "a_zy": found.skew.zy, "a_zx": found.skew.zx}
    lines += [f"  {estimate_text(symbol, one)}" for symbol, one in skew.items()]
    lines += [
        f"  {estimate_text(f'mount {axis}', one)}"
        for axis, one in zip("xyz", found.mounting, strict=True)
    ]
    lines += [
        f"  U0_{axis}     {value:>14.8g} +- {u:.2g}  (u)"
        for axis, value, u in zip("xyz", found.triad.bias, found.triad.u_bias(), strict=True)
    ]
    twelve, nine = (
        ", ".join(f"{value:.3g}" for value in values)
        for values in (found.residual_mg, found.nine.residual_mg)
    )
    lines.append(f"  residual x, y, z: {twelve} mg; of the source's nine parameters {nine} mg")
    return lines + note_lines((*found.calibration.notes, *found.notes), "  ")
