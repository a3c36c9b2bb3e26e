"""What the operator may choose, and what is taken where the laboratory states nothing."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Settings:
    """Choices of a comparison.

    Parameters
    ----------
    alpha : probability that clean data give a name
    max_effects : most steps that are looked for
    head_shared_arcsec, head_setting_arcsec : error of the dial that repeats at the same angle, and
        scatter of a setting, of a head without certificate (OMT's ODG-5); with a certificate the
        first is what it says, the second 0.6 of it
    rate_shared_ppm, rate_setting_ppm : the same of a rate table, ppm of the rate
    advise : work out what to measure next
    """

    alpha: float = 0.01
    max_effects: int = 4
    head_shared_arcsec: float = 5.0
    head_setting_arcsec: float = 3.0
    rate_shared_ppm: float = 100.0
    rate_setting_ppm: float = 150.0
    advise: bool = True
