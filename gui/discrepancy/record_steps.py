"""The ladder of a record: it is explained as a whole, and its steps are added one after another."""

from dataclasses import replace

import numpy as np

from core.arrays import FloatArray, frozen
from core.discrepancy.result import Explanation, Step, Where
from core.errors import FitError


def place_of(known: Explanation, added: int, effect: str) -> int:
    """How many steps there are when an effect is added: those that were found before it are too.

    Raises
    ------
    FitError
        It is none of the steps that were found.
    """
    for place, step in enumerate(known.steps[added:], added + 1):
        if step.effect == effect:
            return place
    raise FitError(
        f"a record is explained as a whole: {effect!r} was not found beside the other effects, and"
        " only what was found is added to it"
    )


def with_steps(known: Explanation, count: int) -> Explanation:
    """The explanation of a record with the first so many of its steps."""
    steps = known.steps[:count]
    if count == len(known.steps):
        return known
    explained = _explained(steps, known.predicted_before)
    return replace(
        known,
        steps=steps,
        after=steps[-1].after if steps else known.before,
        where_after=tuple(_less(one, explained) for one in known.where) if steps else (),
        predicted=frozen(known.predicted_before + explained),
    )


def _explained(steps: tuple[Step, ...], like: FloatArray) -> FloatArray:
    """What some steps add to each row; a fact of the data adds nothing."""
    total = np.zeros_like(like)
    for step in steps:
        if len(step.curve) == len(total):
            total = total + step.curve
    return total


def _less(one: Where, explained: FloatArray) -> Where:
    """A regressor with what is left when a part is explained; how sure it is was not worked out."""
    if len(one.x) != len(explained):
        return replace(one, p_value=float("nan"))
    own = one.channel == one.shown
    near = np.argmin(np.abs(one.x[own][:, None] - one.knots), axis=1)
    rows = np.bincount(near, minlength=len(one.knots))
    taken = np.bincount(near, explained[own], minlength=len(one.knots)) / np.maximum(rows, 1)
    left = one.residual - explained
    sigma = abs(one.worst_sigma) / max(float(np.abs(one.residual).max()), 1e-300)
    worst = int(np.argmax(np.abs(left)))
    return replace(
        one,
        p_value=float("nan"),
        residual=frozen(left),
        curve=frozen(one.curve - taken),
        worst_value=float(one.x[worst]),
        worst_sigma=float(left[worst] * sigma),
    )
