"""``limits.toml``: what the laboratory demands of a parameter.

::

    [[limit]]
    parameter = "bias"          # as the list of parameters names it
    low = -600.0                # either or both
    high = 600.0
    unit = "code"
    sensor = "accelerometer"    # and, where it is not for all: sensor, profile, serial, channel

The first limit in the file that fits a parameter holds: put the particular before the general.
"""

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from core.archive.entry import Entry, Quantity
from core.errors import FormatError
from core.procedures.conformity import Verdict
from core.records.text import decode, read_bytes

NAME = "limits.toml"
RULE = (
    "pass: the value and its expanded uncertainty (95 %) lie within the limits; fail: both lie"
    " beyond one; otherwise undecided (JCGM 106, guard band w = U)"
)
_NARROWING = ("sensor", "profile", "serial", "channel")


@dataclass(frozen=True, slots=True)
class Limit:
    """Limits of one parameter.

    Parameters
    ----------
    parameter, unit : which, and in what
    low, high : infinite where there is none
    sensor, profile, serial, channel : for these only; empty for all
    """

    parameter: str
    unit: str
    low: float = -math.inf
    high: float = math.inf
    sensor: str = ""
    profile: str = ""
    serial: str = ""
    channel: str = ""

    def fits(self, entry: Entry, quantity: Quantity) -> bool:
        """Whether it is meant for this parameter of this device."""
        given = (entry.sensor, entry.profile, entry.serial, quantity.channel)
        wanted = (self.sensor, self.profile, self.serial, self.channel)
        return (
            self.parameter == quantity.name
            and self.unit == quantity.unit
            and all(not want or want == have for want, have in zip(wanted, given, strict=True))
        )

    def judge(self, quantity: Quantity) -> Verdict:
        """State conformity by `RULE`; undecided where no uncertainty is known."""
        value, guard = quantity.value, quantity.expanded()
        if math.isnan(guard):
            return Verdict.UNDECIDED
        if self.low <= value - guard and value + guard <= self.high:
            return Verdict.PASS
        if value + guard < self.low or value - guard > self.high:
            return Verdict.FAIL
        return Verdict.UNDECIDED


def limit_of(limits: Sequence[Limit], entry: Entry, quantity: Quantity) -> Limit | None:
    """Return the limit that holds for a parameter; None if there is none."""
    return next((limit for limit in limits if limit.fits(entry, quantity)), None)


def read_limits(root: Path) -> tuple[Limit, ...]:
    """Read the limits of a folder; none if it states none.

    Raises
    ------
    FormatError
        The file is damaged.
    """
    path = root / NAME
    if not path.exists():
        return ()
    try:
        document: dict[str, Any] = tomllib.loads(decode(read_bytes(path), path))
    except (ValueError, RecursionError) as error:  # also numbers of too many digits
        raise FormatError(path, f"is no TOML: {error}") from error
    items = document.get("limit")
    if not isinstance(items, list) or set(document) != {"limit"}:
        raise FormatError(path, "holds something else than [[limit]] tables")
    return tuple(_limit(item, path, n) for n, item in enumerate(cast(list[Any], items), 1))


def _limit(item: Any, path: Path, number: int) -> Limit:
    where = f"limit {number}"
    if not isinstance(item, dict):
        raise FormatError(path, f"{where} is no table: write [[limit]]")
    found = cast(Mapping[str, Any], item)
    texts = {key: found.get(key, "") for key in ("parameter", "unit", *_NARROWING)}
    bounds = {key: found[key] for key in ("low", "high") if key in found}
    unknown = set(found) - set(texts) - {"low", "high"}
    if unknown:
        raise FormatError(path, f"{where}: {', '.join(sorted(unknown))} is not known")
    if not all(isinstance(text, str) for text in texts.values()):
        raise FormatError(path, f"{where}: {', '.join(texts)} are texts")
    if not texts["parameter"]:
        raise FormatError(path, f"{where} names no parameter")
    if not bounds or not all(
        isinstance(bound, int | float) and not isinstance(bound, bool) for bound in bounds.values()
    ):
        raise FormatError(path, f"{where} needs a number as low, as high, or as both")
    numbers = {key: float(bound) for key, bound in bounds.items()}
    low, high = numbers.get("low", -math.inf), numbers.get("high", math.inf)
    if not low < high:
        raise FormatError(path, f"{where}: low must lie below high")
    return Limit(low=low, high=high, **texts)
