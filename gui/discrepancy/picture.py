"""A story -> both plots: measured and simulated, and the residual against one regressor."""

import math

import numpy as np
from PySide6.QtCore import QCoreApplication

from core.arrays import FloatArray, IntArray
from core.discrepancy.result import Candidate, Where
from gui.discrepancy.ladder_rows import SIGNIFICANT, place_words
from gui.discrepancy.state import PictureState
from gui.discrepancy.words import p_words, regressor_words, unit_words
from gui.discrepancy.working import Story, left_over

_NOTHING = np.zeros(0)
_COUNTED = ("position", "mount", "run", "direction", "order", "channel")


def where_of(story: Story, *, after: bool) -> tuple[Where, ...]:
    """Regressors of the plain model's residuals, or of those with the added effects.

    The most significant stand first; among equals what was set, by how much it explains, before
    what only counts.
    """
    found = story.told.where_after if after else story.told.where
    return tuple(
        sorted(found, key=lambda one: (one.p_value, one.regressor in _COUNTED, -one.share))
    )


def picture_of(
    story: Story,
    where: Where,
    channel: int,
    *,
    after: bool,
    again: FloatArray | None,
    candidate: Candidate | None,
) -> PictureState:
    """Both plots of an output against a regressor."""
    told = story.told
    if len(where.x) != len(told.measured):
        return _spectrum(where, told.unit)
    own = where.channel == channel
    x, residual = where.x[own], where.residual[own]
    near = _nearest(x, where.knots)
    mean = _means(residual, near, len(where.knots))
    same = channel == where.shown
    significant = where.p_value < SIGNIFICANT and same
    # Without structure in this regressor a point outside is one of the five in a hundred.
    marked = np.abs(mean) > where.band if significant else np.zeros(len(mean))
    band, curve = (where.band, where.curve) if same else (_NOTHING, _NOTHING)
    worst = int(np.argmin(np.abs(where.knots - where.worst_value))) if significant else -1
    preview = _NOTHING
    if candidate is not None:
        explained = left_over(story, candidate.curve, after=after)[own]
        preview = _means(explained, near, len(where.knots))
    played, left = _NOTHING, _NOTHING
    if again is not None:
        played = again[told.channel == channel]
        left = left_over(story, again, after=after)[own]
    predicted = told.predicted if after else told.predicted_before
    unit = unit_words(where.unit)
    name = regressor_words(where.regressor)
    return PictureState(
        title=_title(where, name),
        x_label=f"{name}, {unit}" if unit else name,
        unit=unit_words(told.unit),
        x=x,
        measured=told.measured[told.channel == channel],
        simulated=predicted[told.channel == channel],
        residual=residual,
        played=played,
        again=left,
        knots=where.knots,
        mean=mean,
        curve=curve,
        band=band,
        marked=np.asarray(marked, dtype=np.float64),
        worst=worst,
        worst_words=place_words(where) if worst >= 0 else "",
        preview=preview,
        preview_name="" if candidate is None else candidate.name,
    )


def _spectrum(where: Where, unit: str) -> PictureState:
    """The highest amplitude of each band of frequencies against what noise alone reaches."""
    name = regressor_words(where.regressor)
    significant = where.p_value < SIGNIFICANT
    marked = where.curve > where.band if significant else np.zeros(len(where.knots))
    worst = int(np.argmin(np.abs(where.knots - where.worst_value))) if significant else -1
    return PictureState(
        title=_title(where, name),
        x_label=f"{name}, {unit_words(where.unit)}",
        unit=unit_words(unit),
        x=where.x,
        measured=_NOTHING,
        simulated=_NOTHING,
        residual=where.residual,
        played=_NOTHING,
        again=_NOTHING,
        knots=where.knots,
        mean=where.curve,
        curve=where.curve,
        band=where.band,
        marked=np.asarray(marked, dtype=np.float64),
        worst=worst,
        worst_words=place_words(where) if worst >= 0 else "",
        preview=_NOTHING,
        preview_name="",
    )


def _title(where: Where, name: str) -> str:
    if math.isnan(where.p_value):
        template = QCoreApplication.translate(
            "Discrepancy", "{name}: what the effects so far leave, largest {place}"
        )
        return template.format(name=name, place=place_words(where))
    if where.p_value < SIGNIFICANT:
        template = QCoreApplication.translate(
            "Discrepancy", "{name}: structure beyond the noise, {p}, largest {place}"
        )
    else:
        template = QCoreApplication.translate(
            "Discrepancy", "{name}: no structure beyond the noise, {p}, largest {place}"
        )
    return template.format(name=name, p=p_words(where.p_value), place=place_words(where))


def _nearest(x: FloatArray, knots: FloatArray) -> IntArray:
    return np.argmin(np.abs(x[:, None] - knots), axis=1)


def _means(values: FloatArray, near: IntArray, count: int) -> FloatArray:
    rows = np.bincount(near, minlength=count)
    total = np.bincount(near, values, minlength=count)
    return np.where(rows > 0, total / np.maximum(rows, 1), np.nan)
