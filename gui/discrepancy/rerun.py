"""The found model on the simulated bench: the same rows, sample by sample, beside the data."""

import numpy as np

from core.arrays import FloatArray, frozen
from core.discrepancy.ladder import Ladder
from core.model.sensor_model import SensorModel
from drivers.virtual.rows import Found, walk_rows
from gui.discrepancy.working import Story


def played(story: Story, seed: int) -> FloatArray | None:
    """Outputs (n c,) of the same rows from the simulated bench; None for records.

    What acts between rows (hysteresis, a jump, rows that were exchanged) is no property of a
    moment, so that no bench can play it; it is added to the means.
    """
    ladder = story.ladder
    if ladder is None:
        return None
    problem = ladder.engine.problem
    models = [_instant(model, values) for model, values in ladder.models]
    means = walk_rows(problem.run, _found(ladder, models), seed).T.ravel()
    at_once = np.concatenate([model.predict(problem.stimulus, values) for model, values in models])
    return frozen(means + (story.told.predicted - at_once))


def _instant(model: SensorModel, values: FloatArray) -> tuple[SensorModel, FloatArray]:
    """The part of a model that a bench can play."""
    kept = [pair for pair in zip(model.effects, model.places, strict=True) if pair[0].instant]
    own = np.concatenate([values[place] for _, place in kept]) if kept else np.zeros(0)
    return SensorModel(model.sensor, tuple(effect for effect, _ in kept)), frozen(own)


def _found(ladder: Ladder, models: list[tuple[SensorModel, FloatArray]]) -> Found:
    """The noise floor as what a bench can make."""
    problem, floor = ladder.engine.problem, ladder.engine.floor
    n, c = problem.rows, problem.channels
    size: dict[str, FloatArray] = {}
    for part, ratio in zip(floor.parts, floor.sizes.ratio, strict=True):
        name = "repeating" if part.repeats else part.name
        size[name] = np.sqrt(np.diag(part.matrix)).reshape(c, n) * float(ratio)
    nothing = np.zeros((c, n))
    slow = np.hypot(size.get("drift", nothing), size.get("slow_drift", nothing))
    return Found(
        models=models,
        white=size.get("white", nothing).mean(axis=1),
        drift=slow.mean(axis=1),
        setting=_in_setting(ladder, size.get("setting", nothing)),
        repeating=_in_setting(ladder, size.get("repeating", nothing)),
        columns=problem.stimulus.columns,
    )


def _in_setting(ladder: Ladder, moved: FloatArray) -> FloatArray:
    """Standard deviation (n,) of a setting that moves the outputs (c, n) so much."""
    problem = ladder.engine.problem
    if problem.run.test == "static_positions":
        return np.zeros(problem.rows)
    slope = np.abs(problem.slope()).reshape(problem.channels, problem.rows)
    steepest = slope.argmax(axis=0)
    rows = np.arange(problem.rows)
    largest = slope[steepest, rows]
    seen = largest > 1e-9 * max(float(slope.max()), 1e-300)
    found = np.zeros(problem.rows)
    found[seen] = moved[steepest, rows][seen] / largest[seen]
    return found
