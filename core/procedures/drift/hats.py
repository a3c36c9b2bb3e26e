"""Ordinates of a broken line by least squares, and knots moved off the grid.

Chords take over the noise of the very points they start and end at; least squares on hat
functions uses all points. With the ordinates eliminated the cost depends on the knots alone, and
they are moved as long as it falls.
"""

import numpy as np

from core.arrays import FloatArray

_STEPS = (2.0, 1.0, 0.5, 0.25)
_SWEEPS = 4


def hat_basis(t: FloatArray, knots: FloatArray) -> FloatArray:
    """Return (k, p): the hat functions on `knots` (p,) at times `t` (k,).

    Between two knots the two hats sum to one; beyond the outermost knots theirs stay at one.
    """
    p = len(knots)
    inside = np.clip(t, knots[0], knots[-1])
    left = np.clip(np.searchsorted(knots, inside, side="right") - 1, 0, p - 2)
    share = (inside - knots[left]) / (knots[left + 1] - knots[left])
    basis = np.zeros((len(t), p))
    rows = np.arange(len(t))
    basis[rows, left] = 1.0 - share
    basis[rows, left + 1] += share
    return basis


def ordinates(t: FloatArray, curves: FloatArray, knots: FloatArray) -> FloatArray:
    """Least-squares ordinates (m, p) of curves (m, k)."""
    return curves @ projector(t, knots).T


def projector(t: FloatArray, knots: FloatArray) -> FloatArray:
    """Matrix (p, k) that turns a curve into its least-squares ordinates.

    Hats overlap with their neighbours only, so their normal equations lose no digits.
    """
    basis = hat_basis(t, knots)
    return np.asarray(np.linalg.solve(basis.T @ basis, basis.T), dtype=np.float64)


def cost(t: FloatArray, curves: FloatArray, knots: FloatArray) -> float:
    """Sum of the squared residuals of all curves at the best ordinates; inf where they are free."""
    basis = hat_basis(t, knots)
    gram = basis.T @ basis
    if gram.diagonal().min() < 1e-6:
        return float("inf")
    along = basis.T @ curves.T
    try:
        fitted = np.sum(along * np.linalg.solve(gram, along))
    except np.linalg.LinAlgError:
        return float("inf")
    return float(np.sum(curves**2) - fitted)


def refine(t: FloatArray, curves: FloatArray, knots: FloatArray) -> FloatArray:
    """Move the inner knots (p,) as long as the cost falls; neighbours stay a block apart."""
    block = float(t[1] - t[0])
    knots = knots.copy()
    least = cost(t, curves, knots)
    for step in (block * factor for factor in _STEPS):
        for _ in range(_SWEEPS):
            moved = False
            for place in range(1, len(knots) - 1):
                for shift in (-step, step):
                    trial = knots.copy()
                    trial[place] += shift
                    if np.diff(trial[place - 1 : place + 2]).min() < block:
                        continue
                    found = cost(t, curves, trial)
                    if found < least:
                        least, knots, moved = found, trial, True
            if not moved:
                break
    return knots
