"""The laboratory's statements as arguments, the same for every command that fits."""

import argparse
from dataclasses import replace

import numpy as np

from core.samples.run import Conditions

KYIV_G_MPS2 = 9.8106
"""Local gravity of the practicum's laboratory: what is taken, and said, when nothing is stated."""


def add_conditions(parser: argparse.ArgumentParser) -> None:
    """Add g, latitude, the uncertainties of head and table, and the repeatability."""
    group = parser.add_argument_group("what the laboratory states")
    group.add_argument("--g", type=float, metavar="M/S2", help="local gravity (9.8106, Kyiv)")
    group.add_argument("--u-g", type=float, metavar="M/S2", help="its standard uncertainty")
    group.add_argument(
        "--head-u", type=float, metavar="ARCSEC", help="standard uncertainty of a head setting"
    )
    group.add_argument("--latitude", type=float, metavar="DEG", help="for the rate of the Earth")
    group.add_argument(
        "--rate-u-ppm", type=float, metavar="PPM", help="standard uncertainty of a set rate"
    )
    group.add_argument(
        "--rate-u-dps", type=float, metavar="DPS", help="the same, its absolute part"
    )
    group.add_argument(
        "--repeatability",
        type=float,
        metavar="X",
        help="standard deviation between accumulations beyond their own noise, m/s^2 or deg/s"
        " (found from the residuals)",
    )


def stated_of(args: argparse.Namespace) -> dict[str, float]:
    """What was stated on the command line, and nothing else."""
    stated = {
        "g_mps2": args.g,
        "u_g_mps2": args.u_g,
        "head_u_arcsec": args.head_u,
        "latitude_deg": args.latitude,
        "rate_u_ppm": args.rate_u_ppm,
        "rate_u_dps": args.rate_u_dps,
        "repeatability": args.repeatability,
    }
    return {name: value for name, value in stated.items() if value is not None}


def conditions_of(args: argparse.Namespace, known: Conditions) -> tuple[Conditions, bool]:
    """What was stated, over what the file itself brings.

    Returns
    -------
    conditions, assumed : whether g is nobody's statement but the practicum's value
    """
    conditions = replace(known, **{"repeatability": np.nan, **stated_of(args)})
    if np.isfinite(conditions.g_mps2):
        return conditions, False
    return replace(conditions, g_mps2=KYIV_G_MPS2), True
