"""The compensated calibration for other programs: a C header, a document, a table."""

import csv
import io
from collections.abc import Sequence

import numpy as np

from core.arrays import FloatArray, frozen
from core.fit.result import FitResult
from core.model.effect import AXES
from core.procedures.calibration import Provenance
from core.procedures.drift.export import identifier
from core.procedures.thermal.cycle import ThermalCalibration
from core.procedures.thermal.record import RecordResult

FORMAT = "calrig-thermal"
VERSION = 1


def polynomials(calibration: ThermalCalibration) -> tuple[FloatArray, FloatArray]:
    """U0 (c, s) and the responses (c, 3, s) of every sensor to x, y, z, over the powers of t.

    A response that was not determined is zero.
    """
    order = 1 + max(_power(name) for one in calibration.channels for name in one.fit.names)
    c = len(calibration.channels)
    bias, k = np.zeros((c, order)), np.zeros((c, len(AXES), order))
    for row, channel in enumerate(calibration.channels):
        for name, value in zip(channel.fit.names, channel.fit.values, strict=True):
            base, power = name.partition("_t")[0], _power(name)
            if base == "bias":
                bias[row, power] = value
            else:
                axis = channel.axis if base == "scale_factor" else base[-1]
                k[row, AXES.index(axis), power] = value
    return frozen(bias), frozen(k)


def _power(name: str) -> int:
    return int(name.partition("_t")[2] or 0)


def c_header(calibration: ThermalCalibration, name: str) -> str:
    """Polynomials and the function that applies them, C99.

    Parameters
    ----------
    calibration : three sensors, one along each axis, become one function a(u, T); others one
        function for each
    name : becomes the prefix of every identifier
    """
    prefix = identifier(name)
    bias, k = polynomials(calibration)
    provenance = calibration.provenance
    triad = sorted(one.axis for one in calibration.channels) == list(AXES)
    place = (
        [[one.axis for one in calibration.channels].index(axis) for axis in AXES] if triad else []
    )
    if triad:
        bias, k = bias[place], k[place]
    channels = calibration.channels
    names = ", ".join(channels[p].channel for p in (place or range(len(channels))))
    body = _C_TRIAD if triad else _C_SENSORS
    responses = (
        _block(k)
        if triad
        else _block([k[c, AXES.index(one.axis)] for c, one in enumerate(channels)])
    )
    return (_C_HEAD + body + "\n#endif\n").format(
        prefix=prefix,
        upper=prefix.upper(),
        guard=f"{prefix.upper()}_H",
        device=_comment(provenance.device or "unknown device"),
        procedure=_comment(provenance.procedure),
        software=_comment(provenance.software),
        computed=provenance.computed_utc,
        names=_comment(names),
        unit=_comment(calibration.unit),
        sensors=len(channels),
        terms=bias.shape[1],
        reference=repr(calibration.reference_c),
        low=repr(calibration.low_c),
        high=repr(calibration.high_c),
        bias=_block(bias),
        responses=responses,
    )


def _block(values: FloatArray | Sequence[FloatArray]) -> str:
    rows = np.asarray(values)
    if rows.ndim == 1:
        return "{" + ", ".join(repr(float(value)) for value in rows) + "}"
    return "{" + ",\n    ".join(_block(row) for row in rows) + "}"


def _comment(text: str) -> str:
    return text.replace("*/", "* /").replace("/*", "/ *").replace("\n", " ")


def document(calibration: ThermalCalibration) -> dict[str, object]:
    """All that was found, for JSON."""
    bias, k = polynomials(calibration)
    return {
        "format": FORMAT,
        "version": VERSION,
        "provenance": calibration.provenance,
        "unit": calibration.unit,
        "conditions": calibration.conditions,
        "reference_c": calibration.reference_c,
        "low_c": calibration.low_c,
        "high_c": calibration.high_c,
        "bias_polynomials": bias,
        "response_polynomials": k,
        "channels": [
            {
                "channel": one.channel,
                "axis": one.axis,
                "bias_order": one.bias_order,
                "scale_order": one.scale_order,
                "parameters": _parameters(one.fit),
                "covariance": one.fit.covariance,
                "scores": one.scores,
                "points": one.points,
                "hysteresis": one.hysteresis,
                "notes": one.fit.notes,
            }
            for one in calibration.channels
        ],
        "notes": calibration.notes,
    }


def record_document(result: RecordResult, provenance: Provenance) -> dict[str, object]:
    """The polynomials of a standing unit, for JSON."""
    return {
        "format": f"{FORMAT}-record",
        "version": VERSION,
        "provenance": provenance,
        "trends": result.trends,
        "notes": result.notes,
    }


def csv_text(calibration: ThermalCalibration | RecordResult) -> str:
    """Every coefficient with its uncertainty, one a line."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["output", "parameter", "value", "u", "dof", "unit", "reference_degC"])
    if isinstance(calibration, RecordResult):
        for trend in calibration.trends:
            for power, one in enumerate(trend.coefficients):
                line = [f"t^{power}", repr(one.value), repr(one.u), repr(one.dof), one.unit]
                writer.writerow([trend.channel, *line, repr(trend.reference_c)])
        return text.getvalue()
    for channel in calibration.channels:
        for name, value, u, dof, unit in _parameters(channel.fit):
            line = [name, repr(value), repr(u), repr(dof), unit]
            writer.writerow([channel.channel, *line, repr(calibration.reference_c)])
    return text.getvalue()


def _parameters(fit: FitResult) -> list[tuple[str, float, float, float, str]]:
    return [
        (p.name, float(value), float(u), float(dof), p.unit)
        for p, value, u, dof in zip(fit.parameters, fit.values, fit.stderr, fit.t_dof, strict=True)
    ]


_C_HEAD = """\
/* Calibration over temperature of {device}: {procedure}.
 *
 * {software}, {computed}
 * Sensors: {names}; outputs in {unit}.
 * Polynomials in t = T - {reference} degC, measured from {low} to {high} degC; beyond, those of the
 * nearest measured temperature are held and the function returns 1.
 */
#ifndef {guard}
#define {guard}

#define {upper}_TERMS {terms}

/* U0 over the powers of t. */
static const double {prefix}_u0[{sensors}][{terms}] =
    {bias};
"""

_C_TRIAD = """\
/* K over the powers of t: response of sensor i to input along axis j. */
static const double {prefix}_k[3][3][{terms}] =
    {responses};

static inline double {prefix}_at(const double c[{terms}], double t)
{{
    double sum = 0.0;
    for (int p = {terms} - 1; p >= 0; p--)
        sum = sum * t + c[p];
    return sum;
}}

/* Input a from outputs u at a temperature, degC: a = K^-1 (u - U0). */
static inline int {prefix}_apply(const double u[3], double temperature, double a[3])
{{
    const int outside = temperature < {low} || temperature > {high};
    const double held = temperature < {low} ? {low} : temperature > {high} ? {high} : temperature;
    const double t = held - {reference};
    double k[3][3], d[3], q[3][3], det;

    for (int i = 0; i < 3; i++) {{
        d[i] = u[i] - {prefix}_at({prefix}_u0[i], t);
        for (int j = 0; j < 3; j++)
            k[i][j] = {prefix}_at({prefix}_k[i][j], t);
    }}
    for (int i = 0; i < 3; i++) {{
        const int r = (i + 1) % 3, s = (i + 2) % 3;
        for (int j = 0; j < 3; j++) {{
            const int v = (j + 1) % 3, w = (j + 2) % 3;
            q[j][i] = k[r][v] * k[s][w] - k[r][w] * k[s][v];
        }}
    }}
    det = k[0][0] * q[0][0] + k[0][1] * q[1][0] + k[0][2] * q[2][0];
    for (int i = 0; i < 3; i++)
        a[i] = (q[i][0] * d[0] + q[i][1] * d[1] + q[i][2] * d[2]) / det;
    return outside;
}}
"""

_C_SENSORS = """\
/* Response of each sensor along its own axis over the powers of t. */
static const double {prefix}_k[{sensors}][{terms}] =
    {responses};

static inline double {prefix}_at(const double c[{terms}], double t)
{{
    double sum = 0.0;
    for (int p = {terms} - 1; p >= 0; p--)
        sum = sum * t + c[p];
    return sum;
}}

/* Input a along a sensor's axis from its output u at a temperature, degC. */
static inline int {prefix}_apply(int sensor, double u, double temperature, double *a)
{{
    const int outside = temperature < {low} || temperature > {high};
    const double held = temperature < {low} ? {low} : temperature > {high} ? {high} : temperature;
    const double t = held - {reference};

    *a = (u - {prefix}_at({prefix}_u0[sensor], t)) / {prefix}_at({prefix}_k[sensor], t);
    return outside;
}}
"""
