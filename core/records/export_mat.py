"""A calibration as a MATLAB file (version 5): one structure ``calibration``.

``load('PW09_accelerometer.mat')`` gives ``calibration.Q``, ``.U0``, ``.K``, their uncertainties and
covariance for a triad, and ``calibration.channel(i)`` with ``.name``, ``.axis``, ``.parameter``
(cell of names), ``.value``, ``.u``, ``.t_dof``, ``.covariance``, ``.residuals`` for every sensor.
"""

import io
from typing import Any, cast

import numpy as np

from core.model.effect import AXES
from core.procedures.calibration import Calibration
from core.records.calibration_json import INPUT_UNITS, equation


def mat_bytes(calibration: Calibration) -> bytes:
    """The bytes of the file."""
    from scipy.io import savemat

    provenance = calibration.provenance
    members: dict[str, Any] = {
        "device": provenance.device,
        "sensor": calibration.sensor,
        "unit": calibration.unit,
        "input_unit": INPUT_UNITS[calibration.sensor],
        "equation": equation(calibration),
        "g_mps2": calibration.conditions.g_mps2,
        "temperature_c": calibration.temperature_c,
        "procedure": provenance.procedure,
        "profile": provenance.profile,
        "plan": provenance.plan,
        "software": provenance.software,
        "measured_utc": provenance.measured_utc,
        "computed_utc": provenance.computed_utc,
        "records": _cells([f"{name} {sha}" for name, sha in provenance.records]),
        "notes": _cells([note.text for note in calibration.notes]),
        "channel": _channels(calibration),
    }
    if calibration.is_triad:
        triad = calibration.triad()
        members |= {
            "order": _cells([calibration.channels[calibration.axes.index(a)] for a in AXES]),
            "K": triad.k,
            "U0": triad.bias[:, None],
            "Q": triad.q,
            "u_K": triad.u_k(),
            "u_U0": triad.u_bias()[:, None],
            "u_Q": triad.u_q(),
            "covariance": triad.covariance,
        }
    out = io.BytesIO()
    # The stubs do not know that it takes open files as well as names.
    savemat(cast(Any, out), {"calibration": members}, long_field_names=True)
    return out.getvalue()


def _channels(calibration: Calibration) -> Any:
    kinds = ("name", "axis", "parameter", "unit", "value", "u", "t_dof", "covariance", "residuals")
    channels = np.empty(len(calibration.fits), dtype=[(kind, object) for kind in kinds])
    for place, fit in enumerate(calibration.fits):
        channels[place] = (
            calibration.channels[place],
            calibration.axes[place],
            _cells(fit.names),
            _cells([parameter.unit for parameter in fit.parameters]),
            fit.values[:, None],
            fit.stderr[:, None],
            fit.t_dof[:, None],
            fit.covariance,
            fit.residuals[:, None],
        )
    return channels


def _cells(texts: list[str] | tuple[str, ...]) -> Any:
    """Texts as a cell array."""
    cells = np.empty(len(texts), dtype=object)
    cells[:] = texts
    return cells
