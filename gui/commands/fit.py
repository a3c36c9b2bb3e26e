"""FILE is a session's folder, a run file or a legacy text file.

A file of positions gives accelerometers their calibration and gyros their g-sensitivity; a file of
rates gives gyros their scale factor. Files of one unit named together are used together: rates
before positions make codes of g-sensitivity into deg/s, positions before an accuracy check
calibrate its raw codes.
"""

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.errors import FitError
from core.records.open import read_any
from core.samples.run import Run
from gui.commands.answer import Answer
from gui.commands.conditions import KYIV_G_MPS2, add_conditions, conditions_of
from gui.commands.fit_gyro import fit_positions, fit_rates
from gui.commands.fit_head import fit_accelerometers, fit_attitude
from gui.commands.fitted import Fitted

FITS: dict[tuple[str, str], Callable[[Fitted], None]] = {
    ("dividing_head", "accelerometer"): fit_accelerometers,
    ("rate_table", "gyro"): fit_rates,
    ("static_positions", "gyro"): fit_positions,
    ("accuracy", "accelerometer"): fit_attitude,
    ("accuracy", "gyro"): fit_attitude,
}
"""What is done with a run, by its test and its sensor."""


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
    parser.add_argument("--sensor", choices=["accelerometer", "gyro"], help="where a file has both")
    parser.add_argument("--full-scale", type=float, metavar="DPS", help="of the gyros, deg/s")
    parser.add_argument(
        "--same-unit", action="store_true", help="files of differently named units are of one"
    )
    add_conditions(parser)


def run(args: argparse.Namespace) -> Answer:
    """Fit every file in turn; later files may use what earlier ones gave."""
    fitted = Fitted(full_scale_dps=args.full_scale, same_unit=args.same_unit)
    for path in args.file:
        measured = read_any(path, sensor=args.sensor, mounts=args.mount)
        work = FITS.get((measured.test, measured.sensor))
        if work is None:
            raise FitError(f"{path}: nothing is fitted to a {measured.test} of {measured.sensor}")
        conditions, assumed = conditions_of(args, measured.conditions)
        fitted.take(path, measured, conditions)
        work(fitted)
        if assumed and _needs_g(measured):
            fitted.say(f"  g = {KYIV_G_MPS2} m/s^2 was assumed (Kyiv); state yours by --g")
    return Answer({"results": fitted.data}, "\n".join(fitted.lines))


def _needs_g(measured: Run) -> bool:
    return measured.test != "rate_table" and bool(np.isnan(measured.conditions.g_mps2))
