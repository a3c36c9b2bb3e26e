"""What earlier calibrations tell of a device, so that a wrong position is seen from the first."""

from pathlib import Path

import numpy as np

from core.errors import FormatError
from core.model.effect import AXES
from core.procedures.calibration import Calibration
from core.procedures.recognise import Nominal
from core.records.calibration_json import read_calibration
from core.records.names import NO_NAME

FILE = "calibration.cal.json"
"""Every processed session leaves its calibration under this name in its folder."""


def nominal_of(root: Path, device: str, sensor: str) -> Nominal | None:
    """What the newest calibration of a device's sensors under `root` says; None if there is none.

    Folders begin with the date, so that the last by name is the newest. A file that cannot be read
    is passed over: this knowledge is welcome, not needed.
    """
    if not device or device == NO_NAME:
        return None
    for path in sorted(root.glob(f"*/{FILE}"), reverse=True):
        try:
            calibration = read_calibration(path)
        except FormatError:
            continue
        of_device = calibration.provenance.device == device and calibration.sensor == sensor
        if of_device and all("scale_factor" in fit.names for fit in calibration.fits):
            return _nominal(calibration, path)
    return None


def _nominal(calibration: Calibration, path: Path) -> Nominal:
    k = np.zeros((len(calibration.fits), 3))
    bias = np.zeros(len(calibration.fits))
    for row, (axis, fit) in enumerate(zip(calibration.axes, calibration.fits, strict=True)):
        for name, value in zip(fit.names, fit.values.tolist(), strict=True):
            if name == "bias":
                bias[row] = value
            elif name == "scale_factor":
                k[row, AXES.index(axis)] = value
            elif name.startswith("cross_axis_"):
                k[row, AXES.index(name.removeprefix("cross_axis_"))] = value
    return Nominal(k, bias, path.parent.name)
