"""The work behind Model vs data, for a job; needs no Qt."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.ladder import Ladder, explain
from core.discrepancy.result import UNKNOWN, Candidate, Explanation, Step
from core.discrepancy.settings import Settings
from core.errors import FitError, FormatError, RankDeficient
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import Kind
from core.procedures.thermal.joined import joined
from core.records.series_run import sampled_run, with_first
from core.samples.run import Run
from drivers.series import read_series
from gui.discrepancy.record_steps import place_of, with_steps
from gui.measuring.loading import Choice, load

Tell = Callable[[str], None]
"""Told which part of the work begins: a key of `words.PHASES`."""

RECORD = "record"
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
    known : of a record, which is explained as a whole: the explanation before Find shows it
    outputs : of a record, which is compared output by output: all that there are
    """

    run: Run
    paths: tuple[Path, ...]
    ladder: Ladder | None
    told: Explanation
    found: Ladder | None = None
    proposed: Explanation | None = None
    known: Explanation | None = None
    outputs: tuple[str, ...] = ()

    @property
    def able(self) -> bool:
        """Whether there is anything to look for."""
        judged = self.told if self.known is None else self.known
        return judged.verdict != "not_enough_data"

    @property
    def seconds(self) -> FloatArray:
        """When the blocks of a record were; empty for other runs, whose rows are counted."""
        told = self.told
        if self.run.test == RECORD:
            for one in told.where:
                if one.regressor == "t_s" and len(one.x) == len(told.measured):
                    return one.x
        return np.zeros(0)

    @property
    def proposals(self) -> tuple[Step, ...]:
        """Steps that were found and not yet added."""
        return () if self.proposed is None else self.proposed.steps[len(self.told.steps) :]

    @property
    def candidates(self) -> tuple[Candidate, ...]:
        """All effects that could be added next: those of the proposals, then others."""
        named: dict[str, Candidate] = {}
        for step in self.proposals:
            for each in rivals_of(step):
                named.setdefault(each.effect, each)
        for each in self.told.candidates if self.proposed is not None else ():
            named.setdefault(each.effect, each)
        return tuple(named.values())


def is_fact(step: Step) -> bool:
    """Whether a step is a fault of the data that is counted, not fitted."""
    return step.effect in CATALOGUE and CATALOGUE[step.effect].kind is Kind.FACT


def is_noise(step: Step) -> bool:
    """Whether a step is a term of the noise."""
    return step.effect in CATALOGUE and CATALOGUE[step.effect].kind is Kind.NOISE


def rivals_of(step: Step) -> tuple[Candidate, ...]:
    """All names that compete for a step; the step itself where no other does."""
    if step.candidates:
        return step.candidates
    return (
        Candidate(
            effect=step.effect,
            name=step.name,
            plain=step.plain,
            equation=step.equation,
            evidence=step.evidence,
            probability=step.probability,
            parameters=step.parameters,
            gap_after=step.gap_after,
            alias=False,
            curve=step.curve,
        ),
    )


def opened(
    paths: Sequence[Path],
    settings: Settings,
    tell: Tell,
    device: str | None = None,
    mounts: Sequence[str] | None = None,
    sensor: str | None = None,
    output: str = "",
) -> Story | Choice:
    """Read files of one unit and compare them with the plain model.

    Parameters
    ----------
    tell : told which part of the work begins
    device, mounts, sensor : what a file does not say or leaves to choose
    output : name of the output of a record; its first where it is empty

    Raises
    ------
    FormatError
        A file is none of those that hold a run.
    FitError
        The files are of different tests or units, or the test is not one that is compared.
    """
    tell("reading")
    runs: list[Run] = []
    outputs: tuple[str, ...] = ()
    for path in paths:
        read = _read(path, device, mounts, sensor, output)
        if isinstance(read, Choice):
            return read
        run, outputs = read
        runs.append(run)
    if any(run.test == RECORD for run in runs) and len(runs) > 1:
        raise FitError("a record is compared by itself: open one file at a time")
    whole = runs[0] if len(runs) == 1 else in_one(runs)
    tell("floor")
    if whole.test == RECORD:
        known = explain(whole, settings)
        plain = with_steps(known, 0)
        return Story(whole, tuple(paths), None, plain, known=known, outputs=outputs)
    try:
        ladder = Ladder.of(whole, settings)
    except RankDeficient:
        return Story(whole, tuple(paths), None, explain(whole, settings))
    tell("where")
    return Story(whole, tuple(paths), ladder, ladder.explanation)


def searched(story: Story, tell: Tell) -> Story:
    """Look for what is missing on top of what was added."""
    if story.known is not None:
        return replace(story, proposed=story.known)
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
        These rows cannot show this effect, or it was not found in this record.
    """
    if story.known is not None:
        count = place_of(story.known, len(story.told.steps), effect)
        return replace(story, told=with_steps(story.known, count), proposed=story.known)
    if story.ladder is None:
        return story
    if effect == UNKNOWN:
        return all_added(story)
    tell("add")
    ladder = story.ladder.with_effect(effect)
    return searched(Story(story.run, story.paths, ladder, ladder.explanation), tell)


def all_added(story: Story) -> Story:
    """Add all that was found."""
    if story.proposed is None:
        return story
    return replace(story, ladder=story.found, told=story.proposed)


def left_over(story: Story, y: FloatArray, *, after: bool) -> FloatArray:
    """Residual (n,) of any outputs: of the plain model, or with the added effects.

    The plain model of a record, which has no ladder, is a constant.
    """
    if story.ladder is None:
        return np.asarray(y - np.mean(y), dtype=np.float64)
    space = story.ladder.engine.search.bank.space
    white = space.rest(y[:, None])[:, 0]
    if after:
        basis = story.ladder.state.added
        white = white - basis @ (basis.T @ white)
    return space.chol @ white


def _read(
    path: Path,
    device: str | None,
    mounts: Sequence[str] | None,
    sensor: str | None,
    output: str,
) -> tuple[Run, tuple[str, ...]] | Choice:
    """A run, and of a record the outputs that it could be compared by."""
    try:
        run = load(path, device, mounts, sensor)
    except FormatError as no_positions:
        if path.is_dir():
            raise
        try:
            series = read_series(path)
            outputs = tuple(
                channel.name
                for channel in series.channels
                if channel.role.startswith(("rate.", "acc."))
            )
            return sampled_run(series, output, sensor or ""), outputs
        except (FormatError, FitError) as no_record:
            raise (no_positions if path.suffix == ".txt" else no_record) from no_record
    if isinstance(run, Choice):
        return run
    if run.test != RECORD:
        return run, ()
    return (with_first(run, output) if output else run), run.channels


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
