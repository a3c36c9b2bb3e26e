"""``order.toml``: what stands on a certificate beside the results and the laboratory.

::

    [order]
    customer = "Plant No. 5, Kharkiv"
    serial = "PW09-17"              # and the other fields of `Order`

    [surroundings]
    temperature_c = 22.5            # and the other fields of `Surroundings`

    [conformity]
    rule = "guarded"                # or "simple"

    [[conformity.limit]]
    parameter = "bias"
    channel = "acc_x"               # left out for all that have the parameter
    nominal = 0.0
    limit = 600.0
"""

import tomllib
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import cast

from core.certificates.certificate import Order, Surroundings
from core.certificates.limits import ParameterLimit
from core.errors import FormatError
from core.procedures.conformity import RULES
from core.records.json_fields import Fields, Json
from core.records.text import decode, read_bytes


@dataclass(frozen=True, slots=True)
class OrderFile:
    """What the file states.

    Parameters
    ----------
    order, surroundings : as on the certificate
    limits : empty for no statement of conformity
    rule : key of `core.procedures.conformity.RULES`
    """

    order: Order = field(default_factory=Order)
    surroundings: Surroundings = field(default_factory=Surroundings)
    limits: tuple[ParameterLimit, ...] = ()
    rule: str = "guarded"


def read_order(path: Path) -> OrderFile:
    """Read the file.

    Raises
    ------
    FormatError
        It is no TOML, or holds a key that is not known.
    """
    try:
        document = tomllib.loads(decode(read_bytes(path), path))
    except tomllib.TOMLDecodeError as error:
        raise FormatError(path, f"is no TOML: {error}") from error
    top = Fields(str(path), "", cast(dict[str, Json], document))
    _only(top, ("order", "surroundings", "conformity"))
    conformity = _table(top, "conformity")
    _only(conformity, ("rule", "limit"))
    rule = conformity.text("rule") if "rule" in conformity.data else "guarded"
    if rule not in RULES:
        raise conformity.wrong("rule", " or ".join(RULES), rule)
    limits = conformity.objects("limit") if "limit" in conformity.data else []
    return OrderFile(
        Order(**_texts(_table(top, "order"))),
        Surroundings(**_numbers(_table(top, "surroundings"))),
        tuple(_limit(one) for one in limits),
        rule,
    )


def _table(top: Fields, key: str) -> Fields:
    return top.object(key) if key in top.data else Fields(top.path, key, {})


def _texts(found: Fields) -> dict[str, str]:
    _only(found, tuple(item.name for item in fields(Order)))
    # TOML has dates of its own; both ways of writing one mean the same.
    plain = {
        key: str(value) if hasattr(value, "isoformat") else value
        for key, value in found.data.items()
    }
    stated = Fields(found.path, found.where, plain)
    return {key: stated.text(key) for key in plain}


def _numbers(found: Fields) -> dict[str, float]:
    _only(found, tuple(item.name for item in fields(Surroundings)))
    return {key: found.number(key) for key in found.data}


def _limit(found: Fields) -> ParameterLimit:
    _only(found, ("parameter", "channel", "nominal", "limit"))
    limit = found.number("limit")
    if not limit > 0:
        raise found.wrong("limit", "a number above zero", limit)
    return ParameterLimit(
        found.text("parameter"),
        found.text("channel") if "channel" in found.data else "",
        found.number("nominal") if "nominal" in found.data else 0.0,
        limit,
    )


def _only(found: Fields, known: tuple[str, ...]) -> None:
    for key in found.data:
        if key not in known:
            raise FormatError(
                found.path,
                f"{found.where or 'the file'}: {key} is not known; known are {', '.join(known)}",
            )
