"""Orders as lines of JSON."""

import json

import pytest

from drivers.virtual.orders import obey_line
from drivers.virtual.rig import Rig, RigOptions


@pytest.fixture
def rig() -> Rig:
    return Rig(RigOptions())


def told(rig: Rig, order: object) -> dict:
    return json.loads(obey_line(rig, json.dumps(order).encode()))


def test_every_order_does_what_it_says(rig):
    orders = [
        {"turn": 90},
        {"remount": "Y_from"},
        {"heat": 50.5},
        {"tilt_base": [1, 2, 3, 4]},
        {"faults": {"drop": 0.5, "stuck": [0, 3]}},
    ]
    for order in orders:
        assert told(rig, order) == {"ok": True}
    rig.produce(400)
    state = told(rig, {"state": True})["state"]
    assert state["head_target_deg"] == 90.0
    assert state["mount"] == "Y_from"
    assert state["chamber_c"] > 27.0
    assert state["base"] == {
        "alpha_arcmin": 1.0, "beta_arcmin": 2.0, "gamma_deg": 3.0, "psi_deg": 4.0
    }  # fmt: skip
    assert len(rig.damaged()) > 100
    assert told(rig, {"faults": {}}) == {"ok": True}
    assert told(rig, {"spin": -20, "axis": "x"}) == {"ok": True}
    assert told(rig, {"be_at": -10}) == {"ok": True}
    rig.produce(1)
    state = told(rig, {"state": True})["state"]
    assert (state["table_target_dps"], state["axis"], state["case_c"]) == (-20.0, "x", -10.0)
    assert told(rig, {"unplug": True}) == {"ok": True}
    assert not rig.state.plugged
    assert told(rig, {"plug_in": True}) == {"ok": True}
    assert rig.state.plugged


def test_truth_is_told_by_name(rig):
    truth = told(rig, {"truth": True})["truth"]
    assert truth["adc.1"]["scale_factor"] == 1328.0691
    assert set(truth) == {f"adc.{k}" for k in range(1, 10)}


@pytest.mark.parametrize(
    ("line", "why"),
    [
        (b"turn 90", "Expecting value"),
        (b"[1]", "an order is an object"),
        (b"{}", "unknown order"),
        (b'{"dance": 1}', "unknown order 'dance'"),
        (b'{"turn": "up"}', "'up' is no number"),
        (b'{"turn": true}', "True is no number"),
        (b'{"remount": "sideways"}', "unknown mount"),
        (b'{"spin": 1, "axis": "q"}', "expected x, y or z"),
        (b'{"tilt_base": [1, 2]}', "takes [alpha"),
        (b'{"faults": 3}', "takes an object"),
        (b'{"faults": {"stuck": [18]}}', "there are 18 channels"),
        (b'{"faults": {"sabotage": 1}}', "sabotage"),
        (b"\xfa\xfb", "codec"),
    ],
)
def test_wrong_orders_are_answered(rig, line, why):
    assert why in json.loads(obey_line(rig, line))["error"]
