"""A `Calibration` as JSON and back, to the last bit.

Everything that a later program needs stands in the document: estimates with covariance and degrees
of freedom, residuals, notes, what the laboratory stated, where the data came from. The ``triad``
block (K, U0, Q) follows from the rest; it is written for other programs and not read back.
"""

from dataclasses import fields
from pathlib import Path

import numpy as np

from core.arrays import frozen
from core.errors import FormatError
from core.fit.result import FitResult, LackOfFit
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Parameter
from core.procedures.added import AddedEffect
from core.procedures.calibration import Calibration, Provenance
from core.procedures.compensation import has_effects
from core.records.atomic import write_text_atomic
from core.records.json_fields import (
    Fields,
    Json,
    dump,
    load_document,
    matrix_to_json,
    notes_to_json,
    number_to_json,
    numbers_to_json,
)
from core.records.text import decode, read_bytes
from core.samples.run import Conditions

SCHEMA, VERSION = "calrig-calibration", 1

_MAX_BYTES = 64 * 2**20
_TEXTS = ("procedure", "device", "profile", "plan", "software", "measured_utc", "computed_utc")
INPUT_UNITS = {"accelerometer": "m/s^2", "gyro": "deg/s"}
"""Unit of the quantity that a sensor kind measures."""


def write_calibration(calibration: Calibration, path: Path) -> None:
    """Write a calibration, replacing `path`.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    write_text_atomic(path, calibration_text(calibration))


def read_calibration(path: Path) -> Calibration:
    """Read a calibration.

    Raises
    ------
    FormatError
        The file is no calibration, is damaged, or from a newer program.
    """
    return parse_calibration(decode(read_bytes(path, max_bytes=_MAX_BYTES), path), str(path))


def calibration_text(calibration: Calibration) -> str:
    """The JSON text of a calibration."""
    document: dict[str, Json] = {
        "schema": SCHEMA,
        "schema_version": VERSION,
        "sensor": calibration.sensor,
        "unit": calibration.unit,
        "input_unit": INPUT_UNITS[calibration.sensor],
        "equation": equation(calibration),
        "temperature_c": number_to_json(calibration.temperature_c),
        "conditions": {
            item.name: number_to_json(getattr(calibration.conditions, item.name))
            for item in fields(Conditions)
        },
        "provenance": provenance_to_json(calibration.provenance),
        "channels": [
            {
                "name": name,
                "axis": axis,
                "fit": _fit_to_json(fit),
                **_effects_to_json(calibration, place),
            }
            for place, (name, axis, fit) in enumerate(
                zip(calibration.channels, calibration.axes, calibration.fits, strict=True)
            )
        ],
        "notes": notes_to_json(calibration.notes),
    }
    if calibration.is_triad:
        document["triad"] = _triad_to_json(calibration)
    return dump(document) + "\n"


def parse_calibration(text: str, path: str) -> Calibration:
    """Read the JSON text of a calibration; `path` stands in messages.

    Raises
    ------
    FormatError
        As `read_calibration`.
    """
    document = load_document(text, path, SCHEMA, VERSION)
    sensor = document.text("sensor")
    if sensor not in INPUT_UNITS:
        raise document.wrong("sensor", "accelerometer or gyro", sensor)
    channels = document.objects("channels")
    if not channels:
        raise document.wrong("channels", "at least one channel", [])
    stated = document.object("conditions")
    fits = tuple(_fit(channel.object("fit")) for channel in channels)
    effects = tuple(_effects(channel, fit) for channel, fit in zip(channels, fits, strict=True))
    return Calibration(
        sensor=sensor,
        unit=document.text("unit"),
        channels=tuple(channel.text("name") for channel in channels),
        axes=tuple(_axis(channel) for channel in channels),
        fits=fits,
        conditions=Conditions(
            **{
                item.name: stated.number(item.name)
                for item in fields(Conditions)
                if item.name in stated.data
            }
        ),
        temperature_c=document.number("temperature_c"),
        notes=document.notes("notes"),
        provenance=provenance_of_json(document.object("provenance")),
        effects=effects if any(effects) else (),
    )


def equation(calibration: Calibration) -> str:
    """The model in words of the practicum, with the units of its symbols."""
    symbol = "a" if calibration.sensor == "accelerometer" else "w"
    unit = INPUT_UNITS[calibration.sensor]
    units = f" U in {calibration.unit}, {symbol} in {unit}"
    bent = has_effects(calibration)
    if calibration.is_triad and bent:
        return (
            f"U = K {symbol} + U0 + e({symbol}), {symbol} = Q (U - U0 - e({symbol})), Q = K^-1,"
            f" e the added effects;{units}"
        )
    if calibration.is_triad:
        return f"U = K {symbol} + U0, {symbol} = Q (U - U0), Q = K^-1;{units}"
    more = " + e, the added effects" if bent else ""
    return f"U = U0 + sum of each parameter times its input{more};{units}"


def _axis(channel: Fields) -> str:
    axis = channel.text("axis")
    if axis not in (*AXES, ""):
        raise channel.wrong("axis", "x, y, z or empty", axis)
    return axis


def provenance_to_json(provenance: Provenance) -> Json:
    """Where a result comes from, as a JSON object."""
    document: dict[str, Json] = {name: getattr(provenance, name) for name in _TEXTS}
    document["records"] = [{"name": name, "sha256": sha} for name, sha in provenance.records]
    return document


def provenance_of_json(found: Fields) -> Provenance:
    """Where a result comes from, of a JSON object.

    Raises
    ------
    FormatError
        A member is missing or is no text.
    """
    records = tuple(
        (record.text("name"), record.text("sha256")) for record in found.objects("records")
    )
    return Provenance(**{name: found.text(name) for name in _TEXTS}, records=records)


def _effects_to_json(calibration: Calibration, place: int) -> dict[str, Json]:
    """What was added to the plain model of a channel; nothing where nothing was."""
    added = calibration.added_to(place)
    if not added:
        return {}
    names = calibration.fits[place].names
    return {
        "effects": [
            {
                "effect": one.effect,
                "name": one.name,
                "equation": one.equation,
                "shape": [
                    {"name": name, "value": number_to_json(value), "unit": unit}
                    for name, value, unit in one.shape
                ],
                "parameters": [names[i] for i in one.places],
                "in_use": one.in_use,
            }
            for one in added
        ]
    }


def _effects(channel: Fields, fit: FitResult) -> tuple[AddedEffect, ...]:
    """What was added to the plain model of a channel."""
    if "effects" not in channel.data:
        return ()
    return tuple(_effect(found, fit) for found in channel.objects("effects"))


def _effect(found: Fields, fit: FitResult) -> AddedEffect:
    identifier = found.text("effect")
    if identifier not in CATALOGUE:
        raise found.wrong("effect", "an identifier of the catalogue", identifier)
    names = found.items("parameters")
    unknown = [name for name in names if name not in fit.names]
    if unknown or not names:
        raise found.wrong("parameters", "names of parameters of the fit", names)
    return AddedEffect(
        effect=identifier,
        name=found.text("name"),
        equation=found.text("equation"),
        shape=tuple(
            (each.text("name"), each.number("value"), each.text("unit"))
            for each in found.objects("shape")
        ),
        places=tuple(fit.index(str(name)) for name in names),
    )


def _fit_to_json(fit: FitResult) -> Json:
    lack = fit.lack_of_fit
    return {
        "parameters": [
            {
                "name": parameter.name,
                "symbol": parameter.symbol,
                "unit": parameter.unit,
                "value": number_to_json(value),
                "u": number_to_json(u),
                "t_dof": number_to_json(dof),
            }
            for parameter, value, u, dof in zip(
                fit.parameters,
                fit.values.tolist(),
                fit.stderr.tolist(),
                fit.t_dof.tolist(),
                strict=True,
            )
        ],
        "covariance": matrix_to_json(fit.covariance),
        "shared": matrix_to_json(fit.shared),
        "fitted": numbers_to_json(fit.fitted),
        "residuals": numbers_to_json(fit.residuals),
        "sigma": numbers_to_json(fit.sigma),
        "free": numbers_to_json(fit.free),
        "sigma_source": fit.sigma_source,
        "chi2": number_to_json(fit.chi2),
        "dof": fit.dof,
        "p_value": number_to_json(fit.p_value),
        "condition": number_to_json(fit.condition),
        "lack_of_fit": None
        if lack is None
        else {
            "pure_sd": number_to_json(lack.pure_sd),
            "pure_dof": lack.pure_dof,
            "statistic": number_to_json(lack.statistic),
            "p_value": number_to_json(lack.p_value),
        },
        "notes": notes_to_json(fit.notes),
    }


def _fit(found: Fields) -> FitResult:
    items = found.objects("parameters")
    p = len(items)
    if not p:
        raise found.wrong("parameters", "at least one parameter", [])
    residuals = found.numbers("residuals")
    m = len(residuals)
    values = np.array([item.number("value") for item in items])
    if not np.all(np.isfinite(values)):
        raise FormatError(found.path, f"{found.where}: a parameter has no value")
    return FitResult(
        parameters=tuple(
            Parameter(item.text("name"), item.text("symbol"), item.text("unit")) for item in items
        ),
        values=frozen(values),
        covariance=found.matrix("covariance", p, p),
        shared=found.matrix("shared", p, _width(found, "shared")),
        t_dof=frozen([item.number("t_dof") for item in items]),
        fitted=found.numbers("fitted", m),
        residuals=residuals,
        sigma=found.numbers("sigma", m),
        # Files of the first version of the format do not hold it.
        free=found.numbers("free", m) if "free" in found.data else frozen(np.full(m, np.nan)),
        sigma_source=found.text("sigma_source"),
        chi2=found.number("chi2"),
        dof=found.integer("dof"),
        p_value=found.number("p_value"),
        condition=found.number("condition"),
        lack_of_fit=_lack(found),
        notes=found.notes("notes"),
    )


def _lack(found: Fields) -> LackOfFit | None:
    if found.data.get("lack_of_fit", 0) is None:
        return None
    lack = found.object("lack_of_fit")
    return LackOfFit(
        pure_sd=lack.number("pure_sd"),
        pure_dof=lack.integer("pure_dof"),
        statistic=lack.number("statistic"),
        p_value=lack.number("p_value"),
    )


def _width(found: Fields, key: str) -> int:
    """Number of columns of a matrix, by its first row."""
    rows = found.items(key)
    return len(rows[0]) if rows and isinstance(rows[0], list) else 0


def _triad_to_json(calibration: Calibration) -> Json:
    triad = calibration.triad()
    return {
        "axes": list(AXES),
        "channels": [calibration.channels[calibration.axes.index(axis)] for axis in AXES],
        "K": matrix_to_json(triad.k),
        "U0": numbers_to_json(triad.bias),
        "Q": matrix_to_json(triad.q),
        "u_K": matrix_to_json(triad.u_k()),
        "u_U0": numbers_to_json(triad.u_bias()),
        "u_Q": matrix_to_json(triad.u_q()),
        "covariance": matrix_to_json(triad.covariance),
        "covariance_of": [
            symbol for axis in AXES for symbol in ("U0_" + axis, *(f"K_{axis}{j}" for j in AXES))
        ],
    }
