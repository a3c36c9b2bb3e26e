"""The work behind Model vs data, for a job; needs no Qt."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import UNKNOWN, Candidate, Explanation, Step
from core.discrepancy.settings import Settings
from core.errors import RankDeficient
from core.procedures.thermal.joined import joined
from core.samples.run import Run
from gui.measuring.loading import Choice, load

Tell = Callable[[str], None]
"""Told which part of the work begins: a key of `words.PHASES`."""

_BREAK_STEPS = 10.0
"""Pause between two files, in steps of the first, where neither tells the time of day."""


@dataclass(frozen=True, slots=True, eq=False)
class Story:
    """A run, the effects added so far, and what the search proposes on top of them.

    Parameters
    ----------
    run : all rows
    paths : where they came from
    ladder : None where the rows leave nothing to judge a model by
    told : the explanation of what was added
    proposed : the explanation with all that was found; None while nothing was looked for
    found : its ladder
    """

    run: Run
    paths: tuple[Path, ...]
    ladder: Ladder | None
    told: Explanation
    found: Ladder | None = None
    proposed: Explanation | None = None

    @property
    def proposals(self) -> tuple[Step, ...]:
        """Steps that were found and not yet added."""
        return () if self.proposed is None else self.proposed.steps[len(self.told.steps) :]

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """All effects that could be added next: those of the proposals, then others."""
        named: dict[str, Candidate] = {}
        for step in self.proposals:
            for each in step.candidates:
                named.setdefault(each.effect, each)
        for each in self.told.candidates if self.proposed is not None else ():
            named.setdefault(each.effect, each)
        return tuple(named.values())


def opened(
    paths: Sequence[Path],
    settings: Settings,
    tell: Tell,
    device: str | None = None,
    mounts: Sequence[str] | None = None,
    sensor: str | None = None,
) -> Story | Choice:
    """Read files of one unit and compare them with the plain model.

    Raises
    ------
    FormatError
        A file is none of those that hold a run.
    FitError
        The files are of different tests or units, or the test is not one that is compared.
    """
    tell("reading")
    runs: list[Run] = []
    for path in paths:
        run = load(path, device, mounts, sensor)
        if isinstance(run, Choice):
            return run
        runs.append(run)
    whole = in_one(runs)
    tell("floor")
    try:
        ladder = Ladder.of(whole, settings)
    except RankDeficient:
        return Story(whole, tuple(paths), None, explain(whole, settings))
    tell("where")
    return Story(whole, tuple(paths), ladder, ladder.explanation)


def searched(story: Story, tell: Tell) -> Story:
    """Look for what is missing on top of what was added."""
    if story.ladder is None:
        return story
    tell("search")
    found = story.ladder.found()
    tell("steps")
    return replace(story, found=found, proposed=found.explanation)


def added(story: Story, effect: str, tell: Tell) -> Story:
    """Add one effect, and look for more.

    Raises
    ------
    FitError
        These rows cannot show this effect.
    """
    if story.ladder is None:
        return story
    if effect == UNKNOWN:
        return all_added(story)
    tell("add")
    ladder = story.ladder.with_effect(effect)
    return searched(Story(story.run, story.paths, ladder, ladder.explanation), tell)


def all_added(story: Story) -> Story:
    """Add all that was found."""
    if story.found is None or story.proposed is None:
        return story
    return replace(story, ladder=story.found, told=story.proposed)


def played(story: Story, seed: int) -> FloatArray | None:
    """Outputs (n,) of the same rows, simulated with the model and its noise."""
    if story.ladder is None:
        return None
    covariance = story.ladder.engine.floor.covariance
    regular = covariance + 1e-12 * float(np.mean(np.diag(covariance))) * np.eye(len(covariance))
    noise = np.linalg.cholesky(regular) @ np.random.default_rng(seed).standard_normal(
        len(covariance)
    )
    return frozen(story.told.predicted + noise)


def left_over(story: Story, y: FloatArray, *, after: bool) -> FloatArray:
    """Residual (n,) of any outputs: of the plain model, or with the added effects."""
    if story.ladder is None:
        return np.full(len(y), np.nan)
    space = story.ladder.engine.search.bank.space
    white = space.rest(y[:, None])[:, 0]
    if after:
        basis = story.ladder.state.added
        white = white - basis @ (basis.T @ white)
    return space.chol @ white


def in_one(runs: Sequence[Run]) -> Run:
    """Several files of one unit as one run; passes, order and time go on from file to file."""
    began = [str(run.meta.get("measured_utc", "")) for run in runs]
    ordered = list(runs)
    if all(began):
        ordered = [run for _, run in sorted(zip(began, runs, strict=True), key=lambda one: one[0])]
    shifted: list[Run] = []
    for run in ordered:
        if shifted:
            last = shifted[-1]
            step = float(np.median(np.diff(last.t_s))) if len(last) > 1 else 60.0
            run = replace(
                run,
                run=frozen_int(run.run - run.run.min() + last.run.max() + 1),
                order=frozen_int(run.order - run.order.min() + last.order.max() + 1),
                t_s=frozen(run.t_s - run.t_s[0] + last.t_s[-1] + _BREAK_STEPS * step),
            )
        shifted.append(run)
    return joined(shifted)
