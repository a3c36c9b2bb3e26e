"""What was measured, of whatever kind, as a certificate takes it."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

from core.certificates.conformity_json import conformity_of_json, conformity_to_json
from core.certificates.limits import Conformity, Stated, stated_of
from core.fit.quantiles import student_t
from core.procedures.calibration import Calibration, Provenance
from core.records.calibration_json import (
    calibration_text,
    parse_calibration,
    provenance_of_json,
    provenance_to_json,
)
from core.records.json_fields import Fields, Json, number_to_json
from core.samples.run import Conditions

LEVEL = 0.95
"""Coverage probability of all that a certificate states."""

_TEXTS, _NUMBERS = ("channel", "parameter", "symbol", "unit"), ("value", "expanded")
"""Members of a coefficient."""
Printed = Mapping[str, Json]
"""A part of the results as it is printed: a table, matrices, residuals, a doubt."""


@dataclass(frozen=True, slots=True, eq=False)
class Measured:
    """Results with all that must be told about them.

    Parameters
    ----------
    provenance : procedure, device, records
    conditions : what the laboratory stated
    temperature_c : of the item; NaN where unknown
    coverage : smallest and largest coverage factor of the uncertainties; empty where no degree of
        freedom is left to state one
    printed : the results in the order of reading
    calibration : the parameters; None for a check and for noise
    conformity : the verdict that a check brings with it; None for a calibration
    coefficients : of noise; empty for what is none
    """

    provenance: Provenance
    conditions: Conditions
    temperature_c: float
    coverage: tuple[float, ...]
    printed: tuple[Printed, ...]
    calibration: Calibration | None = None
    conformity: Conformity | None = None
    coefficients: tuple[Stated, ...] = ()

    @property
    def stated(self) -> tuple[Stated, ...]:
        """The numbers that limits can be set for; none for a check, which brings its verdict."""
        return self.coefficients if self.calibration is None else stated_of(self.calibration)

    @property
    def subject(self) -> str:
        """What was measured: a kind of sensor, ``"noise"`` or ``"check"``."""
        if self.calibration is not None:
            return self.calibration.sensor
        return "noise" if self.coefficients else "check"


def measured_of(calibration: Calibration, printed: Sequence[Printed]) -> Measured:
    """A calibration as a certificate takes it."""
    factors = [
        student_t(LEVEL, float(dof)) for fit in calibration.fits for dof in fit.t_dof if dof > 0
    ]
    return Measured(
        calibration.provenance,
        calibration.conditions,
        calibration.temperature_c,
        (min(factors), max(factors)) if factors else (),
        tuple(printed),
        calibration,
    )


def measured_to_json(measured: Measured) -> dict[str, Json]:
    """The results as a JSON object."""
    calibration = measured.calibration
    return {
        "provenance": provenance_to_json(measured.provenance),
        "conditions": {
            item.name: number_to_json(getattr(measured.conditions, item.name))
            for item in fields(Conditions)
        },
        "temperature_c": number_to_json(measured.temperature_c),
        "coverage": [number_to_json(k) for k in measured.coverage],
        "printed": [dict(part) for part in measured.printed],
        "calibration": None if calibration is None else json.loads(calibration_text(calibration)),
        "conformity": conformity_to_json(measured.conformity),
        "coefficients": [
            {
                **{name: getattr(one, name) for name in _TEXTS},
                **{name: number_to_json(getattr(one, name)) for name in _NUMBERS},
            }
            for one in measured.coefficients
        ],
    }


def measured_of_json(found: Fields) -> Measured:
    """The results of a JSON object.

    Raises
    ------
    FormatError
        A member is missing or is not what it should be.
    """
    stated = found.object("conditions")
    calibration: Calibration | None = None
    if found.data.get("calibration", 0) is not None:
        text = json.dumps(found.object("calibration").data)
        calibration = parse_calibration(text, found.path)
    return Measured(
        provenance_of_json(found.object("provenance")),
        Conditions(
            **{
                item.name: stated.number(item.name)
                for item in fields(Conditions)
                if item.name in stated.data
            }
        ),
        found.number("temperature_c"),
        tuple(found.numbers("coverage").tolist()),
        tuple(part.data for part in found.objects("printed")),
        calibration,
        conformity_of_json(found),
        # Certificates of the first programs know of no noise.
        tuple(map(_stated, found.objects("coefficients"))) if "coefficients" in found.data else (),
    )


def _stated(found: Fields) -> Stated:
    channel, parameter, symbol, unit = (found.text(name) for name in _TEXTS)
    value, expanded = (found.number(name) for name in _NUMBERS)
    return Stated(channel, parameter, symbol, unit, value, expanded)
