"""The added effects of a triad as C: what they add to the outputs, and the input without them."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core.model.effect import AXES, Sensor
from core.procedures.added import bare_name, response_of
from core.procedures.calibration import Calibration
from core.procedures.compensation import needs_temperature
from core.units import MILLI, PPM, STANDARD_GRAVITY

_ROUNDS = 20


@dataclass(frozen=True, slots=True)
class _Sizes:
    """Numbers of one sensor: output per g (or deg/s), per mg (or deg/s), relative small unit."""

    gain: str
    small: str
    relative: str


_Term = Callable[[str, str, _Sizes], str]
_TERMS: dict[str, _Term] = {
    "second_order_nonlinearity": lambda p, _, s: f"{s.small} * {p} * x * x",
    "third_order_nonlinearity": lambda p, _, s: f"{s.small} * {p} * x * x * x",
    "odd_quadratic_nonlinearity": lambda p, _, s: f"{s.small} * {p} * x * (x < 0.0 ? -x : x)",
    "cross_axis_nonlinearity": lambda p, n, s: f"{s.small} * {p} * {_square(n)}",
    "cross_coupling": lambda p, n, s: f"{s.small} * {p} * {_product(n)}",
    "scale_factor_asymmetry": lambda p, _, s: (
        f"{s.gain} * {s.relative} * {p} * (x < 0.0 ? -x : x) / 2.0"
    ),
    "bias_asymmetry": lambda p, _, s: f"{s.small} * {p} * ((x > 0.0) - (x < 0.0)) / 2.0",
    "bias_temperature": lambda p, _, s: f"{s.small} * {p} * warmth",
    "scale_factor_temperature": lambda p, _, s: f"{s.gain} * {PPM!r} * {p} * warmth * x",
}
"""C of one parameter's term: name of the constant, name of the parameter, sizes -> text."""


def effects_text(calibration: Calibration, prefix: str, names: tuple[str, ...]) -> list[str]:
    """Lines of C for a triad.

    Parameters
    ----------
    calibration : a triad with effects of the sensors
    prefix : of all names
    names : (3,) of the channels in names of constants
    """
    warm = needs_temperature(calibration)
    celsius = ", double celsius" if warm else ""
    given = ", celsius" if warm else ""
    unit = STANDARD_GRAVITY if calibration.sensor == "accelerometer" else 1.0
    lines = [
        "/* What the added effects add to the outputs x, y, z at an input. */",
        f"static inline void {prefix}_added(const double input[3]{celsius}, double e[3])",
        "{",
        *(f"    const double s{i} = input[{i}] / {unit!r};" for i in range(3)),
    ]
    if warm:
        lines.append(f"    const double warmth = celsius - {calibration.temperature_c!r};")
    lines += ["    double x;", *(f"    (void)s{i};" for i in range(3))]
    for row, axis in enumerate(AXES):
        place = calibration.axes.index(axis)
        lines += _sensor(calibration, place, row, f"{prefix}_{names[place]}")
    return [
        *lines,
        "}",
        "",
        "/* The same as _apply, with the added effects taken out. */",
        f"static inline void {prefix}_compensate(const double u[3]{celsius}, double result[3])",
        "{",
        "    double e[3], v[3];",
        f"    {prefix}_apply(u, result);",
        f"    for (int round = 0; round < {_ROUNDS}; round++) {{",
        f"        {prefix}_added(result{given}, e);",
        "        for (int i = 0; i < 3; i++)",
        "            v[i] = u[i] - e[i];",
        f"        {prefix}_apply(v, result);",
        "    }",
        "}",
        "",
    ]


def _sensor(calibration: Calibration, place: int, row: int, name: str) -> list[str]:
    fit = calibration.fits[place]
    sensor = Sensor(calibration.sensor, calibration.axes[place], calibration.unit)
    response = np.array(response_of(sensor, fit))
    own = float(response[sensor.index])
    still = calibration.sensor == "accelerometer"
    gain = own * (STANDARD_GRAVITY if still else 1.0)
    sizes = _Sizes(
        repr(gain), repr(gain * (MILLI if still else 1.0)), repr(MILLI if still else PPM)
    )
    askew = " + ".join(f"{float(r / own)!r} * s{i}" for i, r in enumerate(response))
    terms = [
        _TERMS[one.effect](f"{name}_{fit.names[at]}", bare_name(fit.names[at]), sizes)
        for one in calibration.effects[place]
        if one.in_use
        for at in one.places
    ]
    return [
        f"    x = {askew};",
        f"    e[{row}] = {' + '.join(terms) if terms else '0.0 * x'};",
    ]


def _square(name: str) -> str:
    i = AXES.index(name[-1])
    return f"s{i} * s{i}"


def _product(name: str) -> str:
    return f"s{AXES.index(name[-2])} * s{AXES.index(name[-1])}"
