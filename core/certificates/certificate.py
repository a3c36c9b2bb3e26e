"""What one certificate states (ISO/IEC 17025:2017, 7.8.2, 7.8.4, 7.8.6), and its JSON twin."""

from dataclasses import dataclass, field, fields
from itertools import pairwise

import numpy as np

from core.certificates.conformity_json import conformity_of_json, conformity_to_json
from core.certificates.laboratory import (
    Laboratory,
    day_of,
    laboratory_of_json,
    laboratory_to_json,
    standard_doubts,
)
from core.certificates.limits import Conformity
from core.certificates.measured import Measured, measured_of_json, measured_to_json
from core.errors import Note, Severity
from core.records.json_fields import Json, dump, load_document, number_to_json

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
    replaces : number of the certificate that this one replaces (7.8.8); empty for none
    change : what was changed in it, and why
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
    replaces: str = ""
    change: str = ""


DATES = ("received", "calibrated", "issued")
"""Fields of an `Order` that are dates, in the order that they must have."""


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
    measured : the results with their uncertainties
    surroundings : ambient conditions
    conformity : the statement of conformity; None without limits
    """

    number: str
    laboratory: Laboratory
    order: Order
    measured: Measured
    surroundings: Surroundings = field(default_factory=Surroundings)
    conformity: Conformity | None = None

    def missing(self) -> tuple[str, ...]:
        """What the standard asks for and is not stated, in words."""
        order, air = self.order, self.surroundings
        asked = {
            "customer": order.customer,
            "contact of the customer": order.contact,
            "item": order.item,
            "serial number of the item": order.serial,
            "condition of the item": order.condition,
            "date of calibration": order.calibrated,
            "date of issue": order.issued,
            "ambient temperature": np.isfinite(air.temperature_c),
            "results": self.measured.printed,
            "uncertainty of the results": self.measured.coverage,
            "what was changed, and why": order.change or not order.replaces,
        }
        return (
            *self.laboratory.missing(),
            *(words for words, value in asked.items() if not value),
        )

    def doubts(self) -> tuple[Note, ...]:
        """What is stated and cannot be right: dates, standards that were not valid."""
        order = self.order
        notes: list[Note] = []
        told = [(name, getattr(order, name)) for name in DATES if getattr(order, name)]
        for name, text in told:
            if day_of(text) is None:
                words = f'{name}: "{text}" is no date; write it as 2026-03-31'
                notes.append(Note(Severity.WARNING, "date", words))
        days = [(name, text, day) for name, text in told if (day := day_of(text)) is not None]
        for (name, text, day), (later, other, after) in pairwise(days):
            if after < day:
                words = f"{later} on {other}, before it was {name} on {text}"
                notes.append(Note(Severity.WARNING, "date", words))
        return (*notes, *standard_doubts(self.laboratory, order.calibrated or order.issued))


def certificate_text(certificate: Certificate) -> str:
    """The JSON text of a certificate."""
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
        "conformity": conformity_to_json(certificate.conformity),
        "measured": measured_to_json(certificate.measured),
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
    return Certificate(
        number=document.text("number"),
        laboratory=laboratory_of_json(document.object("laboratory")),
        order=Order(**{item.name: order.text(item.name) for item in fields(Order)}),
        measured=measured_of_json(document.object("measured")),
        surroundings=Surroundings(
            **{item.name: surroundings.number(item.name) for item in fields(Surroundings)}
        ),
        conformity=conformity_of_json(document),
    )
