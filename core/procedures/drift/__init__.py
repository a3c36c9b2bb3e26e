"""Drift after switching on: a small table that a microcontroller subtracts (source 003).

turn_on
    `TurnOn`: one record from switching on; what a set of them must have in common.
curves
    `Curves`: block means, aligned at the start, averaged over the turn-ons of each temperature.
knots
    Common knots of all temperatures, optimal by dynamic programming.
hats
    Ordinates by least squares on hat functions; knots moved off the grid.
angles
    The source's own knots by the sharpest angles, and its slopes against temperature.
held_out
    Every method judged on turn-ons that it has not seen; the choice of the number of knots.
compensate
    `compensate`: from turn-ons to a `DriftResult`.
table
    `DriftTable`: the correction against time and chip temperature.
simulated
    A set of turn-ons of a made-up gyro, for trying out and for tests.
export
    The table in 16-bit integers, as a C header with its reference function, as JSON.
"""
