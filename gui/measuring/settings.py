"""What the operator sets in every measuring tab."""

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from core.plans.orientation import BaseOrientation
from core.records.session.start import Scalars, SessionStart
from core.samples.run import Conditions
from gui.settings import Section, number_of, text_of

CYCLE_C = (27.0, -10.0, -40.0, -10.0, 27.0, 50.0, 70.0, 50.0, 27.0)
"""ClbAcc's list of temperatures: down and up again, so that hysteresis shows."""


@dataclass(frozen=True, slots=True)
class MeasuringSettings:
    """What all tests have in common; a tab derives its own with more.

    Parameters
    ----------
    plan_id : which plan
    passes : how often every step is measured
    accumulation_s, settle_s : seconds to accumulate; hands-free: to wait once at rest
    g_mps2, u_g_mps2 : local gravity and its standard uncertainty
    base : how the head's base plate stands
    thermo : whether the temperatures of the cycle are gone through
    cycle_c : temperatures in the order of the cycle
    visit : place in the cycle
    hands_free : whether the program accumulates by itself
    """

    plan_id: str = ""
    passes: int = 1
    accumulation_s: float = 10.0
    settle_s: float = 3.0
    g_mps2: float = 9.8106
    u_g_mps2: float = 0.0005
    base: BaseOrientation = field(default_factory=BaseOrientation)
    thermo: bool = False
    cycle_c: tuple[float, ...] = CYCLE_C
    visit: int = 0
    hands_free: bool = False

    def conditions(self) -> Conditions:
        """What the laboratory states; nobody knows how a unit drifts between accumulations."""
        return Conditions(
            g_mps2=self.g_mps2,
            u_g_mps2=self.u_g_mps2,
            accumulation_s=self.accumulation_s,
            repeatability=math.nan,
        )

    def extra(self) -> Scalars:
        """What a session keeps of the settings beside the conditions."""
        return {
            "passes": float(self.passes),
            "settle_s": self.settle_s,
            "thermo": self.thermo,
        }

    def tilter_scalars(self) -> Scalars:
        """What a session keeps of a tilting fixture."""
        return {}

    def to_section(self) -> Section:
        """The settings as plain values; the place in the cycle is not one that lasts."""
        return asdict(replace(self, visit=0, hands_free=False))


def common_of(section: Section, standard: MeasuringSettings) -> dict[str, Any]:
    """Arguments of the common settings; what is not there or impossible takes its default."""
    base = section.get("base")
    return {
        "plan_id": text_of(section, "plan_id", standard.plan_id),
        "passes": round(number_of(section, "passes", 1, 1, 9)),
        "accumulation_s": number_of(section, "accumulation_s", standard.accumulation_s, 0.1, 3600),
        "settle_s": number_of(section, "settle_s", standard.settle_s, 0, 600),
        "g_mps2": number_of(section, "g_mps2", standard.g_mps2, 9.7, 9.9),
        "u_g_mps2": number_of(section, "u_g_mps2", standard.u_g_mps2, 0, 0.1),
        "base": _base_of(base if isinstance(base, dict) else {}),
        "thermo": section.get("thermo") is True,
        "cycle_c": temperatures_of(section.get("cycle_c"), standard.cycle_c),
    }


def common_of_start(start: SessionStart, screen: MeasuringSettings) -> dict[str, Any]:
    """Arguments of the common settings that a session was begun with.

    What it does not state stays as it is on the screen.
    """
    conditions, extra = start.conditions, start.settings
    return {
        "plan_id": start.plan.id,
        "passes": round(number_of(extra, "passes", 1, 1, 9)),
        "accumulation_s": stated_or(conditions.accumulation_s, screen.accumulation_s),
        "settle_s": number_of(extra, "settle_s", screen.settle_s, 0, 600),
        "g_mps2": stated_or(conditions.g_mps2, screen.g_mps2),
        "u_g_mps2": stated_or(conditions.u_g_mps2, screen.u_g_mps2),
        "base": start.base,
        "thermo": extra.get("thermo") is True,
        "cycle_c": start.plan.temperatures_c or screen.cycle_c,
        "hands_free": screen.hands_free,
    }


def stated_or(value: float, otherwise: float) -> float:
    """A number that a file states, or another where it states none."""
    return value if math.isfinite(value) else otherwise


def temperatures_of(value: object, standard: tuple[float, ...]) -> tuple[float, ...]:
    """A list of temperatures; the standard where it is none."""
    if not isinstance(value, list | tuple) or not value:
        return standard
    if any(isinstance(t, bool) or not isinstance(t, int | float) for t in value):
        return standard
    return tuple(float(t) for t in value)


def _base_of(angles: Mapping[str, object]) -> BaseOrientation:
    return BaseOrientation(
        **{
            name.name: number_of(angles, name.name, 0.0, -360, 360)
            for name in fields(BaseOrientation)
        }
    )
