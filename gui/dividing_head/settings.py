"""What the operator sets for a test on the dividing head."""

import math
from dataclasses import asdict, dataclass, field, fields, replace

from core.plans.orientation import BaseOrientation
from core.samples.run import Conditions
from gui.settings import Section, number_of, text_of

TILTERS = ("None", "Auto", "Manual")
CYCLE_C = (27.0, -10.0, -40.0, -10.0, 27.0, 50.0, 70.0, 50.0, 27.0)
"""ClbAcc's list of temperatures: down and up again, so that hysteresis shows."""


@dataclass(frozen=True, slots=True)
class Tilter:
    """The motorised tilting fixture.

    Parameters
    ----------
    mode : one of `TILTERS`
    number, position : Auto: which fixture, which of its positions
    psi_deg, theta_deg, gamma_deg : Manual: its angles
    """

    mode: str = "None"
    number: int = 1
    position: int = 1
    psi_deg: float = 0.0
    theta_deg: float = 0.0
    gamma_deg: float = 0.0

    @property
    def angles_deg(self) -> tuple[float, float, float]:
        """Angles between plate and case that the program knows."""
        if self.mode != "Manual":
            return 0.0, 0.0, 0.0
        return self.psi_deg, self.theta_deg, self.gamma_deg


@dataclass(frozen=True, slots=True)
class HeadSettings:
    """Settings of the test.

    Parameters
    ----------
    plan_id : which plan
    passes : how often every position is measured
    accumulation_s, settle_s : seconds to accumulate; hands-free: to wait once at rest
    g_mps2, u_g_mps2 : local gravity and its standard uncertainty
    head_u_arcsec : standard uncertainty of one setting of the dividing head
    base : how the head's base plate stands
    thermo : whether the temperatures of the cycle are gone through
    cycle_c : temperatures in the order of the cycle
    visit : place in the cycle
    tilter : the tilting fixture
    hands_free : whether the program accumulates by itself
    """

    plan_id: str = "pointer_8"
    passes: int = 1
    accumulation_s: float = 10.0
    settle_s: float = 3.0
    g_mps2: float = 9.8106
    u_g_mps2: float = 0.0005
    head_u_arcsec: float = 10.0
    base: BaseOrientation = field(default_factory=BaseOrientation)
    thermo: bool = False
    cycle_c: tuple[float, ...] = CYCLE_C
    visit: int = 0
    tilter: Tilter = field(default_factory=Tilter)
    hands_free: bool = False

    def conditions(self) -> Conditions:
        """What the laboratory states; nobody knows how a unit drifts between accumulations."""
        return Conditions(
            g_mps2=self.g_mps2,
            u_g_mps2=self.u_g_mps2,
            accumulation_s=self.accumulation_s,
            head_u_arcsec=self.head_u_arcsec,
            repeatability=math.nan,
        )

    def to_section(self) -> Section:
        """The settings as plain values; the place in the cycle is not one that lasts."""
        return asdict(replace(self, visit=0, hands_free=False))


def settings_of(section: Section) -> HeadSettings:
    """The settings in a section; what is not there or impossible takes its default."""
    standard = HeadSettings()
    base = section.get("base")
    angles = base if isinstance(base, dict) else {}
    return HeadSettings(
        plan_id=text_of(section, "plan_id", standard.plan_id),
        passes=round(number_of(section, "passes", 1, 1, 9)),
        accumulation_s=number_of(section, "accumulation_s", standard.accumulation_s, 0.1, 3600),
        settle_s=number_of(section, "settle_s", standard.settle_s, 0, 600),
        g_mps2=number_of(section, "g_mps2", standard.g_mps2, 9.7, 9.9),
        u_g_mps2=number_of(section, "u_g_mps2", standard.u_g_mps2, 0, 0.1),
        head_u_arcsec=number_of(section, "head_u_arcsec", standard.head_u_arcsec, 0, 3600),
        base=BaseOrientation(
            **{
                name.name: number_of(angles, name.name, 0.0, -360, 360)
                for name in fields(BaseOrientation)
            }
        ),
        thermo=section.get("thermo") is True,
        cycle_c=_temperatures(section.get("cycle_c")),
    )


def _temperatures(value: object) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        return CYCLE_C
    if any(isinstance(t, bool) or not isinstance(t, int | float) for t in value):
        return CYCLE_C
    return tuple(float(t) for t in value)
