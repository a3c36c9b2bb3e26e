import json
import math
from dataclasses import fields, replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import FormatError
from core.plans.orientation import BaseOrientation
from core.records.session.start import start_from_text, start_to_text
from core.samples.run import Conditions


def test_a_start_document_comes_back_whole(start):
    full = replace(
        start,
        conditions=Conditions(g_mps2=9.8106, head_u_arcsec=5.0, latitude_deg=50.45),
        base=BaseOrientation(alpha_arcmin=1.5, psi_deg=12.0),
        tilter={"kind": "manual", "psi_deg": 1.0, "used": True},
    )
    back = start_from_text(start_to_text(full), "session.json")
    for item in fields(full):
        if item.name != "conditions":
            assert getattr(back, item.name) == getattr(full, item.name)
    for item in fields(Conditions):
        one, two = getattr(back.conditions, item.name), getattr(full.conditions, item.name)
        assert one == two or (math.isnan(one) and math.isnan(two))


def test_the_profile_is_stored_with_its_hash(start):
    document = json.loads(start_to_text(start))
    assert document["profile"]["text"] == start.profile_text
    assert len(document["profile"]["sha256"]) == 64
    document["profile"]["text"] += "#"
    with pytest.raises(FormatError, match="was changed"):
        start_from_text(json.dumps(document), "s")


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"schema_version": 2}, "newer CalRig .* version 2; .* up to version 1.*update"),
        ({"schema": "other"}, "is no calrig-session document"),
        ({"plan": 3}, "plan must be an object, found 3"),
        ({"started": "yesterday"}, "started must be a moment"),
        ({"started": "2024-05-14T09:30:05"}, "started must be a moment"),
        ({"legacy": "fancy"}, "legacy must be one of clbacc"),
        ({"rate": "100"}, "rate must be a number"),
        ({"settings": {"a": []}}, r"settings\.a must be"),
    ],
)
def test_wrong_documents_are_refused_by_name(start, change, why):
    document = {**json.loads(start_to_text(start)), **change}
    with pytest.raises(FormatError, match=why):
        start_from_text(json.dumps(document), "s")


def test_a_missing_member_is_named(start):
    document = json.loads(start_to_text(start))
    del document["plan"]["steps"][1]["mount"]
    with pytest.raises(FormatError, match=r"plan\.steps\[1\]\.mount is missing"):
        start_from_text(json.dumps(document), "s")


@given(st.text(max_size=60) | st.integers(0, 2000))
def test_any_text_is_a_start_or_a_format_error(text_or_cut):
    try:
        start_from_text(text_or_cut if isinstance(text_or_cut, str) else "{" * text_or_cut, "s")
    except FormatError:
        return
    raise AssertionError("no such text is a start document")
