"""The parts of the noise as matrices, with what is known of their sizes beforehand."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, IntArray
from core.discrepancy.problem import Problem
from core.discrepancy.settings import Settings
from core.units import PPM, RAD_PER_ARCSEC

_ACCUMULATED, _GUESSED = 0.25, 1.0
_CERTIFICATE = 0.45
_DRIFTING = 0.55
_FAST, _SLOW = 1.0 / 40.0, 1.0 / 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Component:
    """One part of the noise.

    Parameters
    ----------
    name : ``white``, ``setting``, ``head`` or ``table``, ``drift``, ``slow_drift``
    matrix : (n, n) its covariance at the stated size
    spread : standard deviation of the logarithm of its size (of sigma, not of variance)
    repeats : it is the same at the same position, so that replicates do not show it
    common : standard deviation of the logarithm of a factor that all parts with one share: where
        no standard errors are stated, the scatter is guessed, and the drift from it
    """

    name: str
    matrix: FloatArray
    spread: float
    repeats: bool = False
    common: float = 0.0


def components_of(problem: Problem, settings: Settings) -> tuple[Component, ...]:
    """Return the parts of the noise of a run at their stated sizes."""
    white, common = _white(problem)
    n, c = problem.rows, problem.channels
    typical = float(np.sqrt(np.mean(white)))
    found = [Component("white", np.diag(white), _ACCUMULATED, common=common)]
    if problem.run.test != "static_positions":
        slope = problem.slope()
        shared, setting = _setting(problem, settings)
        # One setting moves all channels of its row.
        row = np.tile(np.arange(n), c)
        moved = slope * np.tile(setting, c)
        found.append(Component("setting", _together(moved, row), _CERTIFICATE))
        repeated = slope * np.tile(shared, c)
        name = "table" if problem.run.test == "rate_table" else "head"
        found.append(
            Component(name, _together(repeated, positions(problem)), _CERTIFICATE, repeats=True)
        )
    t = times(problem)
    apart = np.abs(t[:, None] - t[None, :])
    for name, tau, share in (("drift", _FAST, 0.5), ("slow_drift", _SLOW, 1.0)):
        drift = share * typical**2 * np.exp(-apart / (tau * max(float(np.ptp(t)), 1e-9)))
        matrix = np.asarray(np.kron(np.eye(c), drift), dtype=np.float64)
        found.append(Component(name, matrix, _DRIFTING, common=common))
    return tuple(found)


def positions(problem: Problem) -> IntArray:
    """(n c,) number of the dialled angle or set rate of each row."""
    run = problem.run
    place = run.set_rate_dps if run.test == "rate_table" else np.mod(run.head_deg, 360.0)
    return np.tile(np.unique(place.round(6), return_inverse=True)[1], problem.channels)


def cells(problem: Problem) -> IntArray:
    """(n c,) number of the channel, mounting and dialled position of each row."""
    mount = problem.stimulus.column("mount")
    keys = np.column_stack([problem.channel, np.tile(mount, problem.channels), positions(problem)])
    return np.unique(keys, axis=0, return_inverse=True)[1].ravel().astype(np.int64)


def times(problem: Problem) -> FloatArray:
    """(n,) time of each row, s; the row's number where it is not known."""
    t = problem.run.t_s
    return t if np.all(np.isfinite(t)) else np.arange(problem.rows, dtype=np.float64)


def _together(size: FloatArray, group: IntArray) -> FloatArray:
    """Covariance of errors that are one and the same within a group."""
    return np.outer(size, size) * (group[:, None] == group[None, :])


def _setting(problem: Problem, settings: Settings) -> tuple[FloatArray, FloatArray]:
    """(n,) repeating and scattering error of each setting, rad or deg/s."""
    conditions = problem.run.conditions
    if problem.run.test == "rate_table":
        rate = np.abs(problem.run.set_rate_dps)
        stated = conditions.rate_u_ppm
        known = np.isfinite(stated)
        shared = stated if known else settings.rate_shared_ppm
        setting = stated if known else settings.rate_setting_ppm
        absolute = np.nan_to_num(conditions.rate_u_dps)
        return PPM * shared * rate, np.hypot(PPM * setting * rate, absolute)
    stated = conditions.head_u_arcsec
    known = np.isfinite(stated)
    shared = stated if known else settings.head_shared_arcsec
    setting = 0.6 * stated if known else settings.head_setting_arcsec
    one = np.full(problem.rows, RAD_PER_ARCSEC)
    return shared * one, setting * one


def _white(problem: Problem) -> tuple[FloatArray, float]:
    """(n c,) variance of the accumulations, and how badly its size is guessed."""
    se, channel = problem.se, problem.channel
    if np.all(np.isfinite(se)) and np.all(se > 0):
        # Single standard errors scatter, and that of a disturbed row must not hide it.
        pooled = np.empty_like(se)
        for one in range(problem.channels):
            own = channel == one
            pooled[own] = np.median(se[own])
        return pooled**2, 0.0
    # Rows that were put right are judged as they are now.
    y = problem.right
    variance = np.empty_like(y)
    design = problem.design()
    residual = y - design @ np.linalg.lstsq(design, y, rcond=None)[0]
    cell = cells(problem)
    counts = np.bincount(cell).astype(np.float64)[cell]
    deviation = y - np.bincount(cell, y)[cell] / counts
    repeated = counts > 1
    for one in range(problem.channels):
        own = channel == one
        both = own & repeated
        if int(both.sum()) - len(np.unique(cell[both])) >= 3:
            size = np.abs(deviation[both]) * np.sqrt(counts[both] / (counts[both] - 1.0))
        else:
            size = np.abs(residual[own])
        floor = 1e-9 * float(np.ptp(y[own])) + 1e-300
        variance[own] = max(1.4826 * float(np.median(size)), floor) ** 2
    return 0.5 * variance, _GUESSED
