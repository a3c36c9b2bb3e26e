"""Noise coefficients of a sensor as arguments, the same for every command that predicts."""

import argparse

from core.allan.model import NoiseModel


def add_noise(parser: argparse.ArgumentParser) -> None:
    """Add the coefficients N, B and K of (6.4), two-sided densities."""
    group = parser.add_argument_group("noise of the sensor, by its Allan analysis")
    group.add_argument(
        "--noise-n", type=float, default=0.0, metavar="N", help="white noise, deg/sqrt(s)"
    )
    group.add_argument(
        "--noise-b", type=float, default=0.0, metavar="B", help="bias instability, deg/s"
    )
    group.add_argument(
        "--noise-k", type=float, default=0.0, metavar="K", help="rate random walk, deg/s/sqrt(s)"
    )


def noise_of(args: argparse.Namespace) -> NoiseModel:
    """The coefficients that were stated; those of an accelerometer are in m/s^2 for deg/s."""
    return NoiseModel(
        random_walk=args.noise_n,
        bias_instability=args.noise_b,
        rate_random_walk=args.noise_k,
    )
