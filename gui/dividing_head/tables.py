"""A calibration as tables: 1.3 and 2.3 (what was measured), 1.4 and 2.7 (what came out), Q, checks.

The tables hold text; numbers have the digits that their uncertainties allow.
"""

import numpy as np

from core.arrays import FloatArray
from core.fit.quantiles import student_t
from core.fit.result import FitResult
from core.model.effect import AXES
from core.model.stimulus import stimulus_of
from core.plans.orientation import BaseOrientation
from core.procedures.attitude import attitude
from core.procedures.calibration import Calibration
from core.samples.run import Run
from core.units import DEG_PER_RAD, MILLI
from gui.measuring.head_words import angle_words, mount_words
from gui.widgets.number_text import fixed, value_and_uncertainty
from gui.widgets.states import MatrixState, ResidualSeries, ResidualState, TableState

_LEVEL = 0.95


def parameter_table(calibration: Calibration) -> TableState:
    """Every parameter of every sensor with its expanded uncertainty."""
    triad = calibration.is_triad
    rows = [
        (
            name,
            parameter.symbol,
            *value_and_uncertainty(value, u95),
            parameter.unit.replace("^2", "²"),
        )
        for name, fit in zip(calibration.channels, calibration.fits, strict=True)
        for parameter, value, u95 in zip(
            fit.parameters, fit.values.tolist(), fit.expanded(_LEVEL).tolist(), strict=True
        )
    ]
    return TableState(
        f"Parameters (Table {'2.7' if triad else '1.4'})",
        "U = K·a + U0   (2.2)" if triad else "U = k_z·a_z + k_zx·a_x + k_zy·a_y + U0   (1.3)",
        ("Sensor", "Parameter", "Value", "±U (95 %)", "Unit"),
        tuple(rows),
        2,
    )


def matrices(calibration: Calibration) -> tuple[tuple[MatrixState, ...], ...]:
    """K with U0, and Q, of a triad with their expanded uncertainties; nothing for other units."""
    if not calibration.is_triad:
        return ()
    triad = calibration.triad()
    half = _half_widths(calibration)
    unit = calibration.unit
    q, u_q = triad.q, student_t(_LEVEL, float(triad.t_dof.min())) * triad.u_q()
    power = int(np.floor(np.log10(np.abs(q).max())))
    return (
        (
            MatrixState("K =", _cells(triad.k, half[:, 1:]), f"{unit}/(m/s²)"),
            MatrixState(
                "U0 =",
                _cells(triad.bias[:, None], half[:, :1]),
                unit,
                "U = K·a + U0\n(2.2)",
            ),
        ),
        (
            MatrixState(
                f"Q = 10{_raised(power)} ·",
                _cells(q / 10.0**power, u_q / 10.0**power),
                f"(m/s²)/{unit}",
                "a = Q·(U − U0)   (2.5)\nQ = K⁻¹   (2.6)",
            ),
        ),
    )


def _half_widths(calibration: Calibration) -> FloatArray:
    """95 % half widths (3, 4) of (U0_i, K_ix, K_iy, K_iz), those of the table of parameters."""
    rows: list[list[float]] = []
    for axis in AXES:
        fit = calibration.fits[calibration.axes.index(axis)]
        half = dict(zip(fit.names, fit.expanded(_LEVEL).tolist(), strict=True))
        own = ("scale_factor" if other == axis else f"cross_axis_{other}" for other in AXES)
        rows.append([half["bias"], *(half[name] for name in own)])
    return np.array(rows)


def residuals(calibration: Calibration, run: Run) -> ResidualState:
    """Residuals by position with the 95 % limits of a right model."""
    step = run.extra.get("step", run.order + 1.0)
    return ResidualState(
        tuple(f"{number:g}" for number in step.tolist()),
        tuple(
            ResidualSeries(
                name,
                tuple(fit.residuals.tolist()),
                tuple(fit.residual_limits(_LEVEL).tolist()) if fit.sigma_source != "none" else (),
            )
            for name, fit in zip(calibration.channels, calibration.fits, strict=True)
        ),
        calibration.unit,
    )


def derived_table(calibration: Calibration) -> TableState:
    """Bias in units of the input, misalignment; mounting and non-orthogonality of a triad."""
    g = calibration.conditions.g_mps2
    rows: list[tuple[str, ...]] = []
    for place, name in enumerate(calibration.channels):
        value, u = calibration.bias_in_input(place)
        factor = _coverage(calibration.fits[place])
        mg = 1.0 / (g * MILLI)
        rows.append(
            (name, "Bias", *value_and_uncertainty(value * mg, factor * u * mg), "mg"),
        )
        angles, u_angles = calibration.misalignment(place)
        crosses = [n for n in calibration.fits[place].names if n.startswith("cross_axis")]
        for cross, angle, u_angle in zip(crosses, angles, u_angles, strict=True):
            axis = cross.removeprefix("cross_axis_")
            text = value_and_uncertainty(
                float(angle) * DEG_PER_RAD, factor * float(u_angle) * DEG_PER_RAD
            )
            rows.append((name, f"Misalignment towards {axis}", *text, "deg"))
    if calibration.is_triad:
        parts = calibration.triad().decompose()
        for pair, value in zip(("xy", "xz", "yz"), parts.skew_deg, strict=True):
            rows.append(("Triad", f"Non-orthogonality {pair}", fixed(float(value), 4), "", "deg"))
        for axis, value in zip("xyz", parts.mounting_deg, strict=True):
            rows.append(("Triad", f"Mounting about {axis}", fixed(float(value), 4), "", "deg"))
    return TableState(
        "Derived quantities",
        "",
        ("Sensor", "Quantity", "Value", "±U (95 %)", "Unit"),
        tuple(rows),
        2,
    )


def measured_table(calibration: Calibration, run: Run) -> TableState:
    """What was measured, with the residuals of the fit (Tables 1.3 and 2.3)."""
    step = run.extra.get("step", run.order + 1.0)
    left = np.column_stack([fit.residuals for fit in calibration.fits])
    rows = tuple(
        (
            fixed(float(step[i]), 0),
            mount_words(run.mount[i]),
            angle_words(float(run.head_deg[i])),
            *(fixed(float(value), 2) for value in run.y[i]),
            *(fixed(float(value), 2) for value in left[i]),
        )
        for i in range(len(run))
    )
    outputs = tuple(f"U {name}" for name in run.channels)
    return TableState(
        f"Measured outputs and residuals, {run.unit} (Table"
        f" {'2.3' if calibration.is_triad else '1.3'})",
        "",
        ("No.", "Mount", "Head", *outputs, *(f"Δ {name}" for name in run.channels)),
        rows,
        2,
    )


def attitude_table(
    calibration: Calibration,
    run: Run,
    base: BaseOrientation,
    tilter_deg: tuple[float, float, float],
) -> TableState | None:
    """Pitch and roll of the calibrated unit against those of the plan; None without a triad."""
    if not calibration.is_triad:
        return None
    triad = calibration.triad()
    order = [calibration.axes.index(axis) for axis in ("x", "y", "z")]
    u, se = run.y[:, order], np.nan_to_num(run.y_se[:, order])
    found = attitude(triad.calibrated(u), triad.calibrated_covariance(u, se))
    g = calibration.conditions.g_mps2
    true_force = stimulus_of(run, g, base=base, tilter_deg=tilter_deg).a
    wanted = attitude(true_force, np.zeros((len(run), 3, 3)))
    rows = tuple(
        (
            angle_words(float(run.head_deg[i])),
            mount_words(run.mount[i]),
            *_pair(wanted.pitch[i], found.pitch[i], found.u_pitch[i]),
            *_pair(wanted.roll[i], found.roll[i], found.u_roll[i]),
        )
        for i in range(len(run))
    )
    return TableState(
        "Attitude check, deg",
        "θ = arcsin(a_y/|a|),   γ = −arctan(a_x/a_z)   (2.9)",
        ("Head", "Mount", "Pitch set", "found", "error", "Roll set", "found", "error"),
        rows,
        2,
    )


def accuracy_table(calibration: Calibration, run: Run) -> TableState:
    """Pitch and roll of an accuracy file by this calibration (Tables 2.5 and 2.6)."""
    triad = calibration.triad()
    u = run.y[:, [run.axes.index(axis) for axis in ("x", "y", "z")]]
    found = attitude(triad.calibrated(u), triad.calibrated_covariance(u, np.zeros_like(u)))
    unknown = np.full(len(run), np.nan)
    own_pitch = run.extra.get("unit_pitch_deg", unknown)
    own_roll = run.extra.get("unit_roll_deg", unknown)
    a = triad.calibrated(u)
    rows = tuple(
        (
            str(i + 1),
            *(fixed(float(value), 4) for value in a[i]),
            fixed(float(found.pitch[i]), 4),
            fixed(float(own_pitch[i]), 2),
            fixed(float(found.roll[i]), 4),
            fixed(float(own_roll[i]), 2),
        )
        for i in range(len(run))
    )
    return TableState(
        "Accuracy (Tables 2.5, 2.6): m/s² and deg",
        "θ = arcsin(a_y/|a|),   γ = −arctan(a_x/a_z)   (2.9)",
        ("Row", "a_x", "a_y", "a_z", "Pitch", "unit's own", "Roll", "unit's own"),
        rows,
    )


def _pair(wanted: float, found: float, u: float) -> tuple[str, str, str]:
    """Set angle, computed angle, and the difference with the digits of its uncertainty."""
    if not (np.isfinite(wanted) and np.isfinite(found)):
        return "—", "—", "—"
    error = float((found - wanted + 180.0) % 360.0 - 180.0)
    digits = 4 if not (np.isfinite(u) and u > 0) else max(2, min(5, int(1 - np.log10(u)) + 1))
    return fixed(float(wanted), 2), fixed(float(found), digits), fixed(error, digits)


def _coverage(fit: FitResult) -> float:
    """Factor from the standard to the expanded uncertainty of what follows from a fit."""
    return student_t(_LEVEL, float(fit.t_dof.min()))


def _cells(values: FloatArray, u95: FloatArray) -> tuple[tuple[tuple[str, str], ...], ...]:
    """Pairs of value and uncertainty."""
    return tuple(
        tuple(value_and_uncertainty(float(v), float(u)) for v, u in zip(row, row_u, strict=True))
        for row, row_u in zip(values, u95, strict=True)
    )


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
