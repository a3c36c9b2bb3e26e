"""What was printed comes back as it was."""

import math

import pytest

from core.errors import FormatError, Note, Severity
from core.records.json_fields import dump, load_object
from gui.measuring.page import CurveState, Part
from gui.measuring.printed import parts_of, printed_of
from gui.widgets.states import MatrixState, ResidualSeries, ResidualState, TableState

PARTS: tuple[Part, ...] = (
    TableState("Parameters", "U = k·a", ("Sensor", "Value"), (("acc_x", "1.5"),), 1),
    (MatrixState("K =", ((("1", "0.1"), ("2", "")),), "code", "(2.2)", ("x", "y")),),
    ResidualState(("1", "2"), (ResidualSeries("acc_x", (0.5, -0.25), (1.0, math.inf)),), "code"),
    Note(Severity.WARNING, "worn", "the head is worn"),
)


def test_every_kind_comes_back():
    text = dump({"printed": [dict(part) for part in printed_of(PARTS)]})
    back = [one.data for one in load_object(text, "t").objects("printed")]
    assert parts_of(back) == PARTS


def test_curves_come_back():
    curve = CurveState("Error", "rate", "error", (("own", (0.0, 1.0), (2.0, 3.0), ()),), False)
    (back,) = parts_of(printed_of((curve,)))
    assert isinstance(back, CurveState)
    assert (back.title, back.x_label, back.y_label) == ("Error", "rate", "error")
    assert (back.series, back.joined) == (curve.series, False)


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ({"kind": "hologram"}, r"printed\[0\]\.kind must be table or residuals"),
        ({"kind": "note", "severity": "mild", "subject": "", "text": ""}, "info, warning or"),
        ({"kind": "matrices", "matrices": [{"symbol": "K", "cells": [[["1"]]]}]}, "pairs of value"),
        ({"kind": "table", "title": 5}, "title must be a text"),
    ],
)
def test_what_is_damaged_is_named(part: dict[str, object], words: str):
    with pytest.raises(FormatError, match=words):
        parts_of((part,), "twin.json")
