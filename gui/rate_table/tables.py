"""Results of gyros as tables and plots; numbers have the digits that their uncertainties allow."""

from collections.abc import Mapping

import numpy as np

from core.fit.estimate import Estimate, parameter
from core.fit.lack import REJECTED
from core.procedures.calibration import Calibration
from core.procedures.g_sensitivity import GSensitivity, GSensor
from core.procedures.rate_table import RateSensor, RateTable
from core.procedures.two_files import Table37
from core.samples.run import Run
from gui.measuring.head_words import angle_words, mount_words
from gui.measuring.page import CurveState
from gui.widgets.number_text import fixed, value_and_uncertainty
from gui.widgets.states import TableState
from gui.widgets.table_picture import up_words

_LEVEL = 0.95
_WITH_BARS = 3
"""Up to so many sensors in one plot have bars of uncertainty."""
_NONE = "\N{EM DASH}"


def summary_table(table: RateTable) -> TableState:
    """One line a sensor: scale factor, zero, and whether the line is straight."""
    unit = table.unit
    rows = tuple(
        (
            sensor.channel,
            _verdict(sensor),
            *_pair(sensor.line.slope),
            *_pair(sensor.line.zero),
        )
        for sensor in table.sensors
    )
    return TableState(
        "Rate table: scale factor and zero (Table 3.6), U at 95 %",
        "U = k_z·ω + U0   (3.5), (3.6)",
        (
            "Sensor",
            "Straight line",
            f"k, {unit}/(deg/s)",
            "±U",
            f"Zero, {unit}",
            "±U",
        ),
        rows,
        2,
    )


def _verdict(sensor: RateSensor) -> str:
    """What the tests say of the straight line, in words."""
    probabilities = [term.p_value for term in sensor.bends]
    if np.isfinite(sensor.line.fit.p_value):
        probabilities.append(sensor.line.fit.p_value)
    if sensor.line.fit.lack_of_fit is not None:
        probabilities.append(sensor.line.fit.lack_of_fit.p_value)
    if not probabilities:
        return "not tested"
    worst = min(probabilities)
    if worst < REJECTED:
        return f"rejected, p = {worst:.1g}"
    return f"holds, p = {worst:.2g}"


def straightness_table(table: RateTable) -> TableState:
    """What else the rates tell of every sensor."""
    rows: list[tuple[str, ...]] = []
    for sensor in table.sensors:
        name = sensor.channel
        rows.append(_row(name, "Bias = zero / k", sensor.bias))
        scale = f"Nonlinearity of {sensor.nonlinearity.full_scale:g} deg/s"
        rows.append(_row(name, scale, sensor.nonlinearity.ppm))
        if sensor.slopes is not None:
            rows.append(_row(name, "k of positive rates", sensor.slopes[0]))
            rows.append(_row(name, "k of negative rates", sensor.slopes[1]))
            rows.append(_row(name, "Asymmetry (IEEE 528)", sensor.slopes[2]))
        if sensor.bias_asymmetry is not None:
            rows.append(_row(name, "Bias asymmetry", sensor.bias_asymmetry))
        if sensor.hysteresis is not None:
            rows.append(_row(name, "Hysteresis, up less down", sensor.hysteresis.mean))
        for term in sensor.bends:
            shape = "Parabola" if term.power == 2 else "Cubic"
            rows.append(_row(name, f"{shape}, p = {term.p_value:.2g}", term.coefficient))
        if sensor.threshold is not None:
            low, high = sensor.threshold.above, sensor.threshold.below
            text = f"{low:g} … {high:g}"
            rows.append((name, "Threshold, between", text, "", "deg/s"))
        rows += [
            _row(name, f"{line.symbol}, {up_words(line.mount)}", line.slope)
            for line in sensor.others
        ]
    return TableState(
        "Straightness, asymmetry, hysteresis, cross axes, U at 95 %",
        "",
        ("Sensor", "Quantity", "Value", "±U", "Unit"),
        tuple(rows),
        2,
    )


def parameter_table(calibration: Calibration) -> TableState:
    """Every fitted parameter with its expanded uncertainty."""
    rows = tuple(
        (
            name,
            found.symbol,
            *value_and_uncertainty(value, half),
            _unit(found.unit),
        )
        for name, fit in zip(calibration.channels, calibration.fits, strict=True)
        for found, value, half in zip(
            fit.parameters, fit.values.tolist(), fit.expanded(_LEVEL).tolist(), strict=True
        )
    )
    return TableState(
        "Parameters", "", ("Sensor", "Parameter", "Value", "±U (95 %)", "Unit"), rows, 2
    )


def error_plot(table: RateTable) -> CurveState:
    """Errors of the calibrated rates against the set rate; of few sensors with 95 % intervals."""
    series: list[tuple[str, tuple[float, ...], tuple[float, ...], tuple[float, ...]]] = []
    for sensor in table.sensors:
        order = np.argsort(sensor.line.set_rate, kind="stable")
        half = sensor.line.fit.residual_limits() / abs(sensor.line.slope.value)
        told = sensor.line.fit.sigma_source != "none" and len(table.sensors) <= _WITH_BARS
        series.append(
            (
                sensor.channel,
                tuple(sensor.line.set_rate[order].tolist()),
                tuple(sensor.residuals_dps[order].tolist()),
                tuple(half[order].tolist()) if told else (),
            )
        )
    return CurveState(
        "Error of the calibrated rate", "Set rate, deg/s", "Error, deg/s", tuple(series)
    )


def measured_table(table: RateTable, run: Run) -> TableState:
    """What was measured, with the error of every calibrated rate."""
    errors: dict[str, dict[int, float]] = {
        sensor.channel: dict(
            zip(sensor.line.rows.tolist(), sensor.residuals_dps.tolist(), strict=True)
        )
        for sensor in table.sensors
    }
    rows = tuple(
        (
            str(i + 1),
            up_words(run.mount[i]) if run.mount[i] else _NONE,
            fixed(float(run.set_rate_dps[i]), 3),
            *(fixed(float(value), _decimals(run.y)) for value in run.y[i]),
            *(fixed(of[i], 4) if i in of else _NONE for of in errors.values()),
        )
        for i in range(len(run))
    )
    return TableState(
        f"Measured outputs, {run.unit}, and errors, deg/s (Table 3.4)",
        "",
        (
            "No.",
            "Mount",
            "ω set",
            *(f"U {name}" for name in run.channels),
            *(f"Δω {name}" for name in errors),
        ),
        rows,
        2,
    )


def g_table(found: GSensitivity) -> TableState:
    """g-sensitivity of every sensor in all its units."""
    rows: list[tuple[str, ...]] = []
    for sensor in found.sensors:
        rows.append(_row(sensor.channel, "Zero without gravity", parameter(sensor.fit, "bias")))
        for axis in sensor.axes:
            rows += _of_axis(sensor, axis)
    return TableState(
        "g-sensitivity on the head (Table 3.6)",
        "U = b_zx·a_x + b_zy·a_y + b_zz·a_z + U0   (3.7)",
        ("Sensor", "Quantity", "Value", "±U (95 %)", "Unit"),
        tuple(rows),
        2,
    )


def _of_axis(sensor: GSensor, axis: str) -> list[tuple[str, ...]]:
    name = f"b_{sensor.axis}{axis}"
    rows = [_row(sensor.channel, name, sensor.b(axis))]
    if sensor.scale_factor is not None:
        rows.append(_row(sensor.channel, name, sensor.b_dps(axis)))
        rows.append(_row(sensor.channel, name, sensor.b_dph_per_g(axis)))
    return rows


def positions_table(found: GSensitivity, run: Run) -> TableState:
    """What was measured at rest, with the residuals."""
    left = np.column_stack([sensor.fit.residuals for sensor in found.sensors])
    decimals = _decimals(run.y)
    rows = tuple(
        (
            str(i + 1),
            mount_words(run.mount[i]),
            angle_words(float(run.head_deg[i])),
            *(fixed(float(value), decimals) for value in run.y[i]),
            *(fixed(float(value), decimals) for value in left[i]),
        )
        for i in range(len(run))
    )
    return TableState(
        f"Measured outputs and residuals, {run.unit} (Table 3.5)",
        "",
        (
            "No.",
            "Mount",
            "Head",
            *(f"U {name}" for name in run.channels),
            *(f"Δ {sensor.channel}" for sensor in found.sensors),
        ),
        rows,
        2,
    )


def joint_table(joint: GSensitivity) -> TableState:
    """The whole model of table and head run together."""
    found = parameter_table(joint.calibration())
    return TableState(
        "Rate table and head together (3.3)",
        "U = k_z·ω_z + k_zx·ω_x + k_zy·ω_y + b_zx·a_x + b_zy·a_y + b_zz·a_z + U0   (3.3)",
        found.header,
        found.rows,
        2,
    )


def table_3_7(tables: Mapping[str, Table37]) -> TableState:
    """Set rates, calibrated rates by (3.10) and their errors."""
    rows = tuple(
        (
            channel,
            fixed(float(table.set_rate[i]), 3),
            fixed(float(table.measured[i]), 4),
            fixed(float(table.error[i]), 4),
        )
        for channel, table in tables.items()
        for i in range(len(table.set_rate))
    )
    return TableState(
        "Calibrated rates, deg/s (Table 3.7)",
        "ω = (U − U0 − b_zz·g) / k_z   (3.10)",
        ("Sensor", "ω set", "ω calibrated", "Δω"),
        rows,
    )


def table_3_7_plot(tables: Mapping[str, Table37]) -> CurveState:
    """The errors of Table 3.7."""
    series: list[tuple[str, tuple[float, ...], tuple[float, ...], tuple[float, ...]]] = []
    for channel, table in tables.items():
        order = np.argsort(table.set_rate, kind="stable")
        series.append(
            (
                channel,
                tuple(table.set_rate[order].tolist()),
                tuple(table.error[order].tolist()),
                (),
            )
        )
    return CurveState("Errors of Table 3.7", "Set rate, deg/s", "Error, deg/s", tuple(series))


def _row(sensor: str, quantity: str, estimate: Estimate) -> tuple[str, ...]:
    return (sensor, quantity, *_pair(estimate), _unit(estimate.unit))


def _pair(estimate: Estimate) -> tuple[str, str]:
    return value_and_uncertainty(estimate.value, estimate.expanded(_LEVEL))


def _unit(unit: str) -> str:
    return unit.replace("^2", "²").replace("^3", "³")


def _decimals(y: np.ndarray) -> int:
    """Codes have two decimals, volts six."""
    return 2 if float(np.abs(y).max(initial=0.0)) >= 100.0 else 6
