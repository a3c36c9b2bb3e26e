"""A certificate and its JSON twin."""

import json
from dataclasses import replace

import numpy as np
import pytest

from core.certificates.certificate import (
    Certificate,
    Order,
    Surroundings,
    certificate_text,
    parse_certificate,
)
from core.certificates.laboratory import Standard
from core.certificates.limits import ParameterLimit, judge_stated, stated_of
from core.errors import FormatError


def test_the_twin_tells_the_same_to_the_last_bit(certificate: Certificate):
    limits = (ParameterLimit("scale_factor", "", 1000.0, 5.0),)
    calibration = certificate.measured.calibration
    assert calibration is not None
    judged = judge_stated(stated_of(calibration), limits, "guarded")
    issued = replace(certificate, conformity=judged)
    text = certificate_text(issued)
    back = parse_certificate(text, "twin.json")
    assert certificate_text(back) == text
    assert (back.number, back.laboratory, back.order) == (
        issued.number,
        issued.laboratory,
        issued.order,
    )
    assert back.conformity == judged
    again = back.measured.calibration
    assert again is not None
    assert np.array_equal(again.fits[2].values, calibration.fits[2].values)
    assert back.measured.printed == issued.measured.printed
    assert np.isnan(back.surroundings.pressure_hpa)
    assert back.surroundings.humidity_percent == 41.0


def test_what_the_standard_asks_for_is_named(certificate: Certificate):
    assert certificate.missing() == ()
    bare = replace(certificate.measured, printed=(), coverage=())
    without = replace(
        certificate,
        order=Order(customer="Plant", replaces="2026-0007"),
        measured=bare,
        surroundings=Surroundings(),
    )
    assert without.missing() == (
        "contact of the customer",
        "item",
        "serial number of the item",
        "condition of the item",
        "date of calibration",
        "date of issue",
        "ambient temperature",
        "results",
        "uncertainty of the results",
        "what was changed, and why",
    )


def test_dates_that_cannot_be_are_doubted(certificate: Certificate):
    assert certificate.doubts() == ()
    order = replace(certificate.order, received="2026-11-30", calibrated="20.11.2026")
    words = [note.text for note in replace(certificate, order=order).doubts()]
    assert words == [
        'calibrated: "20.11.2026" is no date; write it as 2026-03-31',
        "issued on 2026-11-22, before it was received on 2026-11-30",
    ]


def test_a_standard_counts_on_the_day_of_calibration(certificate: Certificate):
    standards = (
        Standard("head", "1", "UA-1", "2026-11-20"),
        Standard("level", "2", "UA-2", "2026-11-19"),
        Standard("clock"),
        Standard("thermometer", "3", "UA-3", "soon"),
    )
    laboratory = replace(certificate.laboratory, standards=standards)
    words = [note.text for note in replace(certificate, laboratory=laboratory).doubts()]
    assert words == [
        "level: its certificate was valid until 2026-11-19, not on 2026-11-20",
        "clock: no certificate is named, so that nothing can be traced",
        'thermometer: "soon" is no date; write it as 2026-03-31',
    ]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"schema": "other"}, "is no calrig-certificate"),
        ({"schema_version": 99}, "newer CalRig"),
        ({"number": 5}, "number must be a text"),
        ({"order": {}}, r"order\.customer is missing"),
        ({"conformity": {"rule": "", "verdict": "perhaps", "judged": []}}, "pass, fail or"),
        ({"measured": {}}, r"measured\.conditions is missing"),
    ],
)
def test_a_damaged_twin_is_refused_by_member(
    certificate: Certificate, change: dict[str, object], words: str
):
    document = {**json.loads(certificate_text(certificate)), **change}
    with pytest.raises(FormatError, match=words):
        parse_certificate(json.dumps(document), "twin.json")
