"""What one certificate states (ISO/IEC 17025:2017, 7.8.2, 7.8.4, 7.8.6), and its JSON twin."""

import json
from dataclasses import dataclass, field, fields

import numpy as np

from core.certificates.laboratory import Laboratory, laboratory_of_json, laboratory_to_json
from core.certificates.limits import Conformity, Judged
from core.procedures.calibration import Calibration
from core.procedures.conformity import Verdict
from core.records.calibration_json import calibration_text, parse_calibration
from core.records.json_fields import Fields, Json, dump, load_document, number_to_json

SCHEMA, VERSION = "calrig-certificate", 1


@dataclass(frozen=True, slots=True)
class Order:
    """Customer and item.

    Parameters
    ----------
    customer, contact : who asked for the calibration
    item, model, serial : what was calibrated
    condition : in which state it came
    received, calibrated, issued : ISO dates; empty where unknown
    before : what was found before an adjustment, or that nothing was adjusted
    remarks : deviations from the method, opinions
    """

    customer: str = ""
    contact: str = ""
    item: str = ""
    model: str = ""
    serial: str = ""
    condition: str = ""
    received: str = ""
    calibrated: str = ""
    issued: str = ""
    before: str = ""
    remarks: str = ""


@dataclass(frozen=True, slots=True)
class Surroundings:
    """Ambient conditions; NaN where not measured.

    Parameters
    ----------
    temperature_c, humidity_percent, pressure_hpa, supply_v : air, and supply of the item
    """

    temperature_c: float = np.nan
    humidity_percent: float = np.nan
    pressure_hpa: float = np.nan
    supply_v: float = np.nan


@dataclass(frozen=True, slots=True, eq=False)
class Certificate:
    """A certificate.

    Parameters
    ----------
    number : unique in the laboratory
    laboratory : as it was on the day of issue
    order : customer and item
    surroundings : ambient conditions
    calibration : the results with their uncertainties
    conformity : the statement of conformity; None without limits
    """

    number: str
    laboratory: Laboratory
    order: Order
    calibration: Calibration
    surroundings: Surroundings = field(default_factory=Surroundings)
    conformity: Conformity | None = None

    def missing(self) -> tuple[str, ...]:
        """What the standard asks for and is not stated, in words."""
        asked = {
            "customer": self.order.customer,
            "serial number of the item": self.order.serial,
            "date of calibration": self.order.calibrated,
            "date of issue": self.order.issued,
        }
        return (
            *self.laboratory.missing(),
            *(words for words, value in asked.items() if not value),
        )


def certificate_text(certificate: Certificate) -> str:
    """The JSON text of a certificate."""
    conformity = certificate.conformity
    document: dict[str, Json] = {
        "schema": SCHEMA,
        "schema_version": VERSION,
        "number": certificate.number,
        "laboratory": laboratory_to_json(certificate.laboratory),
        "order": {item.name: getattr(certificate.order, item.name) for item in fields(Order)},
        "surroundings": {
            item.name: number_to_json(getattr(certificate.surroundings, item.name))
            for item in fields(Surroundings)
        },
        "calibration": json.loads(calibration_text(certificate.calibration)),
        "conformity": None
        if conformity is None
        else {
            "rule": conformity.rule,
            "verdict": conformity.verdict.value,
            "judged": [_judged_to_json(one) for one in conformity.judged],
        },
    }
    return dump(document) + "\n"


def parse_certificate(text: str, path: str) -> Certificate:
    """Read the JSON text of a certificate; `path` stands in messages.

    Raises
    ------
    FormatError
        It is none, is damaged, or from a newer program.
    """
    document = load_document(text, path, SCHEMA, VERSION)
    order, surroundings = document.object("order"), document.object("surroundings")
    calibration = json.dumps(document.object("calibration").data)
    return Certificate(
        number=document.text("number"),
        laboratory=laboratory_of_json(document.object("laboratory")),
        order=Order(**{item.name: order.text(item.name) for item in fields(Order)}),
        calibration=parse_calibration(calibration, path),
        surroundings=Surroundings(
            **{item.name: surroundings.number(item.name) for item in fields(Surroundings)}
        ),
        conformity=_conformity(document),
    )


def _judged_to_json(one: Judged) -> Json:
    return {
        "channel": one.channel,
        "symbol": one.symbol,
        "unit": one.unit,
        "deviation": number_to_json(one.deviation),
        "expanded": number_to_json(one.expanded),
        "limit": number_to_json(one.limit),
        "verdict": one.verdict.value,
    }


def _conformity(document: Fields) -> Conformity | None:
    if document.data.get("conformity", 0) is None:
        return None
    found = document.object("conformity")
    return Conformity(
        found.text("rule"),
        tuple(
            Judged(
                one.text("channel"),
                one.text("symbol"),
                one.text("unit"),
                one.number("deviation"),
                one.number("expanded"),
                one.number("limit"),
                _verdict(one),
            )
            for one in found.objects("judged")
        ),
        _verdict(found),
    )


def _verdict(found: Fields) -> Verdict:
    word = found.text("verdict")
    try:
        return Verdict(word)
    except ValueError:
        raise found.wrong("verdict", "pass, fail or undecided", word) from None
