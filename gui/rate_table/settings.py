"""What the operator sets for gyros on the rate table and on the head."""

import math
from dataclasses import dataclass, replace

from core.procedures.g_sensitivity import HeadSite
from core.procedures.rate_table import whole_turns_s
from core.records.session.start import Scalars, SessionStart
from core.samples.run import Conditions
from gui.measuring.settings import MeasuringSettings, common_of, common_of_start, stated_or
from gui.settings import Section, number_of


@dataclass(frozen=True, slots=True)
class RateSettings(MeasuringSettings):
    """Settings of the test; the azimuth of the head's shaft is psi of the base.

    Parameters
    ----------
    rate_u_dps, rate_u_ppm : standard uncertainty of one setting of the table: its absolute part,
        and the part in ppm of the rate
    head_u_arcsec : standard uncertainty of one setting of the dividing head
    full_scale_dps : full scale of the sensors; 0 for the largest rate of the run
    latitude_deg : geodetic latitude; None where it is not stated
    azimuth_known : whether psi of the base is stated
    whole_turns : whether each accumulation is made as long as whole turns of the table
    """

    plan_id: str = "rate_table_100"
    accumulation_s: float = 30.0
    rate_u_dps: float = 0.0
    rate_u_ppm: float = 0.0
    head_u_arcsec: float = 10.0
    full_scale_dps: float = 0.0
    latitude_deg: float | None = None
    azimuth_known: bool = False
    whole_turns: bool = True

    def conditions(self) -> Conditions:
        """What the laboratory states."""
        common = MeasuringSettings.conditions(self)
        return replace(
            common,
            latitude_deg=math.nan if self.latitude_deg is None else self.latitude_deg,
            head_u_arcsec=self.head_u_arcsec,
            rate_u_dps=self.rate_u_dps,
            rate_u_ppm=self.rate_u_ppm,
        )

    def extra(self) -> Scalars:
        """What a session keeps of the settings beside the conditions."""
        return {
            **MeasuringSettings.extra(self),
            "azimuth_known": self.azimuth_known,
            "whole_turns": self.whole_turns,
            "full_scale_dps": self.full_scale_dps,
        }

    def site(self) -> HeadSite:
        """How the head stands on the Earth."""
        return HeadSite(self.base, self.azimuth_known and self.latitude_deg is not None)

    def seconds_at(self, rate_dps: float) -> float:
        """How long to accumulate at a rate."""
        if not self.whole_turns:
            return self.accumulation_s
        return whole_turns_s(rate_dps, self.accumulation_s)


def settings_of(section: Section) -> RateSettings:
    """The settings in a section; what is not there or impossible takes its default."""
    standard = RateSettings()
    latitude = number_of(section, "latitude_deg", math.nan, -90, 90)
    return RateSettings(
        **common_of(section, standard),
        rate_u_dps=number_of(section, "rate_u_dps", 0.0, 0, 1000),
        rate_u_ppm=number_of(section, "rate_u_ppm", 0.0, 0, 1e6),
        head_u_arcsec=number_of(section, "head_u_arcsec", standard.head_u_arcsec, 0, 3600),
        full_scale_dps=number_of(section, "full_scale_dps", 0.0, 0, 1e5),
        latitude_deg=None if math.isnan(latitude) else latitude,
        azimuth_known=section.get("azimuth_known") is True,
        whole_turns=section.get("whole_turns") is not False,
    )


def settings_of_session(start: SessionStart, screen: RateSettings) -> RateSettings:
    """The settings that a session was begun with; what it does not state stays as it is."""
    conditions, extra = start.conditions, start.settings
    latitude = conditions.latitude_deg
    return RateSettings(
        **common_of_start(start, screen),
        rate_u_dps=stated_or(conditions.rate_u_dps, screen.rate_u_dps),
        rate_u_ppm=stated_or(conditions.rate_u_ppm, screen.rate_u_ppm),
        head_u_arcsec=stated_or(conditions.head_u_arcsec, screen.head_u_arcsec),
        full_scale_dps=number_of(extra, "full_scale_dps", screen.full_scale_dps, 0, 1e5),
        latitude_deg=latitude if math.isfinite(latitude) else screen.latitude_deg,
        azimuth_known=extra.get("azimuth_known") is True,
        whole_turns=extra.get("whole_turns") is not False,
    )
