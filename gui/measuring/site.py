"""What holds for the whole laboratory and is stated by every session."""

import math
from dataclasses import dataclass

from gui.settings import Section, number_of, text_of

SECTION = "laboratory"
"""Of the preferences."""


@dataclass(frozen=True, slots=True)
class Site:
    """Who measures, and where.

    Parameters
    ----------
    operator : name of who measures
    g_mps2, u_g_mps2 : local gravity and its standard uncertainty
    latitude_deg : geodetic latitude; None where it is not stated
    """

    operator: str = ""
    g_mps2: float = 9.8106
    u_g_mps2: float = 0.0005
    latitude_deg: float | None = None

    def to_section(self) -> Section:
        """The site as plain values."""
        return {
            "operator": self.operator,
            "g_mps2": self.g_mps2,
            "u_g_mps2": self.u_g_mps2,
            "latitude_deg": self.latitude_deg,
        }


def site_of(section: Section) -> Site:
    """The site that a section of the preferences states; what it does not takes its default."""
    standard = Site()
    latitude = number_of(section, "latitude_deg", math.nan, -90, 90)
    return Site(
        text_of(section, "operator"),
        number_of(section, "g_mps2", standard.g_mps2, 9.7, 9.9),
        number_of(section, "u_g_mps2", standard.u_g_mps2, 0, 0.1),
        None if math.isnan(latitude) else latitude,
    )
