"""A calibration as a C header (C99) that a firmware includes.

Every parameter is a constant of its own; a triad has Q, U0 and a function that applies them. All
numbers are doubles with 17 digits, which is every bit of them.
"""

import re
import unicodedata

from core.model.effect import AXES
from core.procedures.calibration import Calibration
from core.procedures.compensation import has_effects
from core.records.calibration_json import INPUT_UNITS, equation
from core.records.export_c_effects import effects_text
from core.records.names import name_in_file

_SHORT = {"accelerometer": "acc", "gyro": "gyro"}


def header_text(calibration: Calibration) -> str:
    """The text of the header."""
    device = c_name(calibration.provenance.device)
    prefix = f"{device}_{_SHORT[calibration.sensor]}"
    guard = f"CALRIG_{prefix.upper()}_H"
    lines = [
        f"#ifndef {guard}",
        f"#define {guard}",
        "",
        *_comment(calibration),
        "",
        *_parameters(calibration, prefix),
        *(_triad(calibration, prefix) if calibration.is_triad else []),
        f"#endif /* {guard} */",
        "",
    ]
    return "\n".join(lines)


def c_name(text: str) -> str:
    """Return an identifier of C for any text."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    name = re.sub(r"\W+", "_", plain).strip("_").lower()
    return name if re.match(r"[a-z]", name) else f"unit_{name}".rstrip("_")


def _comment(calibration: Calibration) -> list[str]:
    provenance = calibration.provenance
    facts = [
        ("Calibration of", f"{provenance.device}, {calibration.sensor}"),
        ("Equation", equation(calibration)),
        ("Procedure", provenance.procedure),
        ("Profile, plan", f"{provenance.profile or '-'}, {provenance.plan or '-'}"),
        ("Local g", f"{calibration.conditions.g_mps2:.9g} m/s^2"),
        ("Temperature", f"{calibration.temperature_c:.4g} degC"),
        ("Measured", provenance.measured_utc or "-"),
        ("Computed", f"{provenance.computed_utc or '-'} by {provenance.software or '-'}"),
        *(("Data", f"{name}, SHA-256 {sha}") for name, sha in provenance.records),
        *((note.severity.value.capitalize(), note.text) for note in calibration.notes),
    ]
    return ["/*", *(f" * {name}: {_inside(text)}" for name, text in facts), " */"]


def _inside(text: str) -> str:
    """Text that neither ends a comment nor begins one."""
    return name_in_file(text).replace("*/", "* /").replace("/*", "/ *").rstrip("\\")


def _parameters(calibration: Calibration, prefix: str) -> list[str]:
    lines: list[str] = []
    names = _channel_names(calibration)
    sensors = zip(calibration.channels, names, calibration.axes, calibration.fits, strict=True)
    for place, (channel, name, axis, fit) in enumerate(sensors):
        lines.append(f"/* {_inside(channel)}, input axis {axis or 'unknown'} */")
        for parameter, value, u in zip(fit.parameters, fit.values, fit.stderr, strict=True):
            lines.append(
                f"static const double {prefix}_{name}_{c_name(parameter.name)} = {_number(value)};"
                f" /* {_inside(parameter.unit)}, u = {u:.2g} */"
            )
        lines += [
            *(
                f"/* {_inside(f'{one.name}: {one.equation}; {one.reach}')} */"
                for one in calibration.added_to(place)
            ),
            "",
        ]
    return lines


def _channel_names(calibration: Calibration) -> tuple[str, ...]:
    """Channels as parts of C's names, no two alike."""
    taken: list[str] = []
    for place, channel in enumerate(calibration.channels, start=1):
        name = c_name(channel)
        while name in taken:
            name = f"{name}_{place}"
        taken.append(name)
    return tuple(taken)


def _triad(calibration: Calibration, prefix: str) -> list[str]:
    triad = calibration.triad()
    names = [calibration.channels[calibration.axes.index(axis)] for axis in AXES]
    unit, out = calibration.unit, INPUT_UNITS[calibration.sensor]
    return [
        f"/* Outputs and results in the order x, y, z: {_inside(', '.join(names))} */",
        f"static const double {prefix}_q[3][3] = {{ /* ({out})/{_inside(unit)} */",
        *(f"    {{{', '.join(map(_number, row))}}}," for row in triad.q),
        "};",
        f"static const double {prefix}_u0[3] = {{ /* {_inside(unit)} */",
        f"    {', '.join(map(_number, triad.bias))}",
        "};",
        "",
        f"static inline void {prefix}_apply(const double u[3], double result[3])",
        "{",
        "    for (int i = 0; i < 3; i++) {",
        "        result[i] = 0.0;",
        "        for (int j = 0; j < 3; j++)",
        f"            result[i] += {prefix}_q[i][j] * (u[j] - {prefix}_u0[j]);",
        "    }",
        "}",
        "",
        *(
            effects_text(calibration, prefix, _channel_names(calibration))
            if has_effects(calibration)
            else ()
        ),
    ]


def _number(value: float) -> str:
    text = f"{value:.17g}"
    return text if any(mark in text for mark in ".en") else f"{text}.0"
