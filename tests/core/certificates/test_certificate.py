"""A certificate and its JSON twin."""

import json
from dataclasses import replace

import numpy as np
import pytest

from core.certificates.certificate import (
    Certificate,
    Order,
    certificate_text,
    parse_certificate,
)
from core.certificates.limits import ParameterLimit, judge_calibration
from core.errors import FormatError


def test_the_twin_tells_the_same_to_the_last_bit(certificate: Certificate):
    limits = (ParameterLimit("scale_factor", "", 1000.0, 5.0),)
    judged = judge_calibration(certificate.calibration, limits, "guarded")
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
    assert np.array_equal(back.calibration.fits[2].values, issued.calibration.fits[2].values)
    assert np.isnan(back.surroundings.pressure_hpa)
    assert back.surroundings.humidity_percent == 41.0


def test_what_the_standard_asks_for_is_named(certificate: Certificate):
    assert certificate.missing() == ()
    without = replace(certificate, order=Order(customer="Plant"))
    assert without.missing() == (
        "serial number of the item",
        "date of calibration",
        "date of issue",
    )


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"schema": "other"}, "is no calrig-certificate"),
        ({"schema_version": 99}, "newer CalRig"),
        ({"number": 5}, "number must be a text"),
        ({"order": {}}, r"order\.customer is missing"),
        ({"conformity": {"rule": "", "verdict": "perhaps", "judged": []}}, "pass, fail or"),
        ({"calibration": {}}, "is no calrig-calibration"),
    ],
)
def test_a_damaged_twin_is_refused_by_member(
    certificate: Certificate, change: dict[str, object], words: str
):
    document = {**json.loads(certificate_text(certificate)), **change}
    with pytest.raises(FormatError, match=words):
        parse_certificate(json.dumps(document), "twin.json")
