"""Does the model fit: against the stated uncertainties, and against replicates."""

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import Note, Severity
from core.fit.quantiles import chi2_sf, f_sf
from core.fit.result import LackOfFit

REJECTED = 0.01
"""A model is called rejected below this p-value."""


def model_p_value(chi2: float, dof: int, doubt: float) -> float:
    """Probability of a larger chi-square with a right model.

    Parameters
    ----------
    chi2, dof : sum of squared residuals over the stated variances, rows minus parameters
    doubt : sum over the rows of (1 - leverage)^2 / degrees of freedom of the row's variance; zero
        where the variances are known well, and then this is the chi-square test

    Notes
    -----
    Variances estimated with few degrees of freedom give residuals heavier tails; Welch's (1951)
    test of means, with leverage in the place of the share of the weight, allows for that.
    """
    if doubt <= 0:
        return chi2_sf(chi2, dof)
    excess = 2.0 * (dof - 1) / (dof + 2) * doubt
    return f_sf(chi2 / (dof + excess), dof, dof * (dof + 2) / (3.0 * doubt))


def lack_of_fit(
    group: IntArray, parameters: int, y: FloatArray, residuals: FloatArray, setting: FloatArray
) -> LackOfFit | None:
    """F test against replicates.

    Parameters
    ----------
    group : (n,) rows with the same number have the same input
    parameters : how many were fitted
    y, residuals : (n,) measured, measured minus model
    setting : (n,) stated variance of the setting errors; a head repeats its error when it comes
        back to an angle, so replicates do not show it and the model may miss their mean by it

    Returns
    -------
    LackOfFit or None
        None where nothing was repeated, or nothing is left to be tested.
    """
    count = np.bincount(group)
    pure_dof = len(y) - len(count)
    lack_dof = len(y) - parameters - pure_dof
    if pure_dof < 1 or lack_dof < 1:
        return None
    mean = np.bincount(group, weights=y) / count
    pure = float(np.sum((y - mean[group]) ** 2)) / pure_dof
    if pure == 0.0:
        return None
    lack = max(float(np.sum(residuals**2)) - pure * pure_dof, 0.0) / lack_dof
    expected = pure + float(np.mean(setting * count[group]))
    dof = pure_dof * (expected / pure) ** 2
    statistic = lack / expected
    return LackOfFit(float(np.sqrt(pure)), pure_dof, statistic, f_sf(statistic, lack_dof, dof))


def rejected_note(p_value: float, ratio: float, repeatability_is_unknown: bool) -> Note:
    """The stated uncertainties do not cover the residuals."""
    meaning = (
        "the uncertainties allow for it; the unit drifts between accumulations, positions were"
        " set worse than stated, or the model lacks something"
        if repeatability_is_unknown
        else "all uncertainties were enlarged by that factor, and the model lacks something"
    )
    return Note(
        Severity.WARNING,
        "model_rejected",
        f"the residuals are {np.sqrt(ratio):.1f} times larger than the stated uncertainties of the"
        f" rows allow (p = {p_value:.2g}); {meaning}",
    )


def lack_note(lack: LackOfFit) -> Note:
    """Replicates agree better than the model fits them."""
    return Note(
        Severity.WARNING,
        "lack_of_fit",
        f"repeated positions agree to {lack.pure_sd:.3g} but the model misses the means by more"
        f" (F = {lack.statistic:.3g}, p = {lack.p_value:.2g}): the model lacks something",
    )
