"""What a ``sim://`` address says, and the rig that stands behind it."""

import math
from dataclasses import dataclass, replace
from urllib.parse import parse_qsl, urlsplit

from drivers.virtual.bench import Place
from drivers.virtual.faults import Faults
from drivers.virtual.rig import Rig, RigOptions

_BLOCK_S = 0.25
_RATES = ("bit_error", "drop", "half", "garbage")
_RIGS: dict[str, "Stand"] = {}


@dataclass(frozen=True, slots=True)
class Stand:
    """A rig and how fast its time goes.

    Parameters
    ----------
    rig : the rig
    speed : seconds of the rig in one of ours; infinite for as fast as it is read
    block_s : seconds of the rig that are made at once at infinite speed
    """

    rig: Rig
    speed: float
    block_s: float


def rig_of(url: str) -> Rig:
    """Return the rig behind a ``sim://`` address; the same text always names the same rig.

    ``sim://DEVICE?key=value&...`` with the keys ``speed`` (1, or ``max``), ``seed``, ``rate``,
    ``noise``, ``cold``, ``g``, ``latitude``, ``effect=ID:value,value`` or
    ``effect=ROLE/ID:value,...`` (repeatable), ``bit_error``, ``drop``, ``half``, ``garbage``
    (probabilities), ``block`` (seconds made at once where the speed is ``max``), and ``name``,
    which only tells rigs apart.

    Raises
    ------
    ValueError
        The address names an unknown device, key or effect, or a value is no number.
    """
    return stand_of(url).rig


def stand_of(url: str) -> Stand:
    """Return the rig behind an address with its speed; see `rig_of`."""
    stand = _RIGS.get(url)
    if stand is None:
        stand = _RIGS.setdefault(url, _stand(url))
    return stand


def _stand(url: str) -> Stand:
    parts = urlsplit(url)
    options = RigOptions(device=parts.netloc.lower())
    faults, speed, block_s = Faults(), 1.0, _BLOCK_S
    effects: dict[str, tuple[float, ...]] = {}
    for key, value in parse_qsl(parts.query, keep_blank_values=True):
        if key == "speed":
            speed = math.inf if value == "max" else _number(key, value)
        elif key == "block":
            block_s = _number(key, value)
        elif key == "effect":
            name, _, numbers = value.partition(":")
            effects[name] = tuple(_number(key, number) for number in numbers.split(","))
        elif key in _RATES:
            faults = replace(faults, **{key: _number(key, value)})
        elif key != "name":
            options = _option(options, key, _number(key, value))
    for name, number in (("speed", speed), ("block", block_s)):
        if number <= 0:
            raise ValueError(f"{name} = {number:g}; must be above zero")
    rig = Rig(replace(options, effects=effects))
    rig.fail(faults)
    return Stand(rig, speed, block_s)


def _option(options: RigOptions, key: str, value: float) -> RigOptions:
    place = options.place
    changes: dict[str, dict[str, object]] = {
        "seed": {"seed": int(value)},
        "rate": {"rate_hz": value},
        "noise": {"noise": value},
        "cold": {"cold": bool(value)},
        "g": {"place": Place(value, place.latitude_deg)},
        "latitude": {"place": Place(place.g, value)},
    }
    if key not in changes:
        raise ValueError(f"unknown key {key!r}; there are {', '.join(changes)}")
    return replace(options, **changes[key])  # pyright: ignore[reportArgumentType]


def _number(key: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        raise ValueError(f"{key} = {text!r} is no number") from None
    if not math.isfinite(number):
        raise ValueError(f"{key} = {text!r} is no finite number")
    return number
