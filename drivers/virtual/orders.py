"""Orders to a rig as JSON objects, one a line: for a rig in another process.

========================================  ==============================================
``{"turn": 90}``                          turn the head
``{"remount": "Y_from"}``                 bolt the unit on another way
``{"spin": 20, "axis": "z"}``             go to a rate on the table
``{"heat": 50}``, ``{"be_at": 50}``       set the chamber; be at a temperature at once
``{"tilt_base": [alpha, beta, gamma, psi]}``  set the base plate: arcmin, arcmin, deg, deg
``{"faults": {"drop": 0.01}}``            let things go wrong; ``{}`` mends all
``{"unplug": true}``, ``{"plug_in": true}``  pull the cable, put it back
``{"state": true}``, ``{"truth": true}``  ask
========================================  ==============================================
"""

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from typing import cast

from core.plans.orientation import BaseOrientation
from drivers.virtual.faults import Faults
from drivers.virtual.rig import Rig

Order = Mapping[str, object]
Reply = dict[str, object]


def obey_line(rig: Rig, line: bytes) -> bytes:
    """Carry out the order of a line and return the line of the answer, without line ends.

    The answer holds ``"ok": true`` and what was asked for, or ``"error"`` with the reason.
    """
    try:
        order = json.loads(line)
        if not isinstance(order, dict):
            raise TypeError('an order is an object such as {"turn": 90}')
        reply = obey(rig, cast(Order, order))
    except (ValueError, TypeError) as error:
        reply: Reply = {"error": str(error)}
    return json.dumps(reply).encode()


def obey(rig: Rig, order: Order) -> Reply:
    """Carry out an order.

    Raises
    ------
    ValueError, TypeError
        The order is none, or its value is of the wrong kind.
    """
    for name, action in _ORDERS.items():
        if name in order:
            return {"ok": True, **(action(rig, order[name], order) or {})}
    raise ValueError(f"unknown order {', '.join(order)!r}; there are {', '.join(_ORDERS)}")


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError(f"{value!r} is no number")
    return float(value)


def _tilt(rig: Rig, value: object) -> None:
    if not isinstance(value, list) or len(cast(list[object], value)) != 4:
        raise TypeError("tilt_base takes [alpha, beta, gamma, psi]")
    rig.tilt_base(BaseOrientation(*map(_number, cast(list[object], value))))


def _fail(rig: Rig, value: object) -> None:
    if not isinstance(value, dict):
        raise TypeError("faults takes an object")
    given = dict(cast(Mapping[str, object], value))
    stuck = given.pop("stuck", [])
    if not isinstance(stuck, list):
        raise TypeError("stuck takes a list of channel numbers")
    channels = tuple(int(_number(place)) for place in cast(list[object], stuck))
    if any(not 0 <= place < len(rig.channels) for place in channels):
        raise ValueError(f"stuck: there are {len(rig.channels)} channels")
    rates = {name: _number(rate) for name, rate in given.items()}
    rig.fail(replace(Faults(stuck=channels), **rates))  # pyright: ignore[reportArgumentType]


def _truth(rig: Rig) -> Reply:
    return {
        "truth": {
            output.role: {p.name: output.value(p.name) for p in output.model.parameters}
            for output in rig.truth()
        }
    }


_ORDERS: Mapping[str, Callable[[Rig, object, Order], Reply | None]] = {
    "turn": lambda rig, value, _: rig.turn(_number(value)),
    "remount": lambda rig, value, _: rig.remount(str(value)),
    "spin": lambda rig, value, order: rig.spin(_number(value), str(order.get("axis", "z"))),
    "heat": lambda rig, value, _: rig.heat(_number(value)),
    "be_at": lambda rig, value, _: rig.be_at(_number(value)),
    "tilt_base": lambda rig, value, _: _tilt(rig, value),
    "faults": lambda rig, value, _: _fail(rig, value),
    "unplug": lambda rig, _value, _: rig.unplug(),
    "plug_in": lambda rig, _value, _: rig.plug_in(),
    "state": lambda rig, _value, _: {"state": asdict(rig.state)},
    "truth": lambda rig, _value, _: _truth(rig),
}
