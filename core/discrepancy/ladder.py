"""The ladder: the plain model, and one more effect on each rung."""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.discrepancy.advise import advise
from core.discrepancy.engine import Engine
from core.discrepancy.few import striking
from core.discrepancy.gaps import gap_of, held_out_gap, predicted
from core.discrepancy.locate import locate
from core.discrepancy.power import invisible_of, smallest_of
from core.discrepancy.problem import COMMON, EACH, Problem
from core.discrepancy.record import RECORD, explain_record, fact_step
from core.discrepancy.result import UNKNOWN, Explanation, Gap, NoiseFloor
from core.discrepancy.row_facts import row_facts
from core.discrepancy.search import Scored
from core.discrepancy.settings import Settings
from core.discrepancy.slots import Slot, State
from core.discrepancy.steps import candidates_of, fit_slots, steps_of, unknown_step
from core.discrepancy.verdict import (
    FEWEST,
    ROWS,
    doubted,
    is_excess,
    notes_of,
    summary_of,
    verdict_of,
)
from core.discrepancy.weighed import weighed
from core.errors import FitError, Note, RankDeficient, Severity
from core.model.sensor_model import SensorModel
from core.samples.run import Run

NO_SETTINGS = Settings()


@dataclass(frozen=True)
class Ladder:
    """A run and what has been added to its plain model; immutable.

    Parameters
    ----------
    engine : the run under its noise floor
    slots : what was added
    by_hand : how many of the first slots were added by hand
    unknown : structure that no effect explains, as the last step
    imitated : one curve outside the catalogue does nearly what the found names do together
    """

    engine: Engine
    slots: tuple[Slot, ...] = ()
    by_hand: int = 0
    unknown: Scored | None = None
    imitated: bool = False

    @classmethod
    def of(cls, run: Run, settings: Settings = NO_SETTINGS) -> "Ladder":
        """The plain model of a run.

        Raises
        ------
        RankDeficient
            The rows do not determine even the plain model, or leave nothing to judge it by.
        FitError
            The run is of another test, or an output is missing.
        """
        problem = Problem.of(run)
        design = problem.design()
        spare = design.shape[0] - design.shape[1]
        if spare >= FEWEST:
            return cls(Engine.of(problem, settings))
        engine = striking(problem, settings) if spare else None
        if engine is None:
            raise RankDeficient(
                ("any further effect",),
                f"{design.shape[0]} rows for {design.shape[1]} parameters leave nothing that could"
                " contradict the model; measure more positions, and each twice",
            )
        return cls(engine)

    def found(self) -> "Ladder":
        """With all steps that the search finds on top of those that are there."""
        state, unknown, imitated = weighed(self.engine, self.slots)
        noise = self.engine.floor.result(self.engine.problem.run.unit)
        if (
            not state.slots
            and unknown is None
            and is_excess(gap_of(self.engine, state), noise, ROWS)
        ):
            # That something is missing is certain; its likeliest name is a guess, and told as such.
            state = self.engine.search.guess(state)
        return replace(
            self,
            slots=state.slots,
            by_hand=len(self.slots),
            unknown=unknown,
            imitated=imitated,
        )

    def with_effect(self, identifier: str) -> "Ladder":
        """With the best instance of one more effect.

        Raises
        ------
        FitError
            These rows cannot show this effect.
        """
        search = self.engine.search
        scores = search.scores(self.state)
        if identifier not in scores or scores[identifier].slot is None:
            raise FitError(f"these rows cannot show {identifier!r}")
        slot = scores[identifier].slot
        assert slot is not None  # noqa: S101
        slots = (*self.slots, search.polished(slot, self.state))
        return replace(self, slots=slots, by_hand=len(slots), unknown=None, imitated=False)

    def without_last(self) -> "Ladder":
        """With one step less; the plain model stays as it is."""
        if self.unknown is not None:
            return replace(self, unknown=None)
        slots = self.slots[:-1]
        return replace(self, slots=slots, by_hand=min(self.by_hand, len(slots)))

    @cached_property
    def state(self) -> State:
        """What has been added, and what is left then."""
        return self.engine.search.state(self.slots)

    @property
    def models(self) -> tuple[tuple[SensorModel, FloatArray], ...]:
        """(c,) model of each channel with all additive steps, and its parameter values.

        What is simulated, fitted and exported from here on has the steps in it.
        """
        problem = self.engine.problem
        fitted = fit_slots(self.engine, self.state)
        values = np.linalg.lstsq(
            self.engine.search.bank.space.white(problem.design()),
            self.engine.search.bank.space.white(
                problem.y - sum((one.curve for one in fitted), 0.0 * problem.y)
            ),
            rcond=None,
        )[0]
        found: list[tuple[SensorModel, FloatArray]] = []
        start = 0
        for channel, model in enumerate(problem.models):
            count = len(model.parameters)
            own = list(values[start : start + count])
            start += count
            for slot, one in zip(self.slots, fitted, strict=True):
                if slot.instance.channel in (COMMON, EACH, channel) and slot.raw.shape[1]:
                    model = model.with_effect(slot.instance.effect)
                    mine = len(slot.instance.effect.parameters(model.sensor))
                    first = channel * mine if slot.instance.channel == EACH else 0
                    own += one.values[first : first + mine].tolist()
            found.append((model, frozen(own)))
        return tuple(found)

    @cached_property
    def explanation(self) -> Explanation:
        """The whole story of these steps."""
        engine, problem = self.engine, self.engine.problem
        plain = engine.search.state(())
        before = gap_of(engine, plain)
        steps = steps_of(engine, self.state, self.by_hand)
        if self.unknown is not None:
            steps = (*steps, unknown_step(engine, self.state, self.unknown))
        noise = engine.floor.result(problem.run.unit)
        left = locate(engine, self.state) if self.slots else ()
        steps = doubted(steps, noise, left, engine.settings.alpha, ROWS, imitated=self.imitated)
        doubtful = frozenset(
            place
            for place, step in enumerate(steps)
            if UNKNOWN in (step.effect, *step.indistinguishable_from)
        )
        after = steps[-1].after if steps else before
        nothing = frozen(np.zeros(len(problem.y)))
        faults = (fact_step(fact, before, nothing) for fact in row_facts(problem.run))
        steps = (*faults, *steps)
        verdict = verdict_of(steps, noise, after, ROWS)
        smallest = smallest_of(engine)
        curve = steps[-1].curve if self.unknown is not None else 0.0
        return Explanation(
            verdict=verdict,
            summary=summary_of(verdict, steps, before, after),
            noise=noise,
            before=before,
            after=after,
            held_out_before=held_out_gap(engine, plain),
            where=locate(engine, plain),
            where_after=left,
            steps=steps,
            candidates=candidates_of(engine, self.state),
            threshold=engine.search.threshold,
            next_measurements=advise(engine, self.state, doubtful)
            if engine.settings.advise
            else (),
            smallest=smallest,
            invisible=invisible_of(engine),
            untested=problem.untested,
            notes=notes_of(engine, noise, verdict, smallest),
            measured=frozen(problem.y),
            predicted_before=frozen(predicted(engine, plain)),
            predicted=frozen(predicted(engine, self.state) + curve),
            sigma=frozen(np.sqrt(np.diag(engine.floor.covariance))),
            channel=frozen_int(problem.channel),
            channels=problem.run.channels,
            unit=problem.run.unit,
        )


def explain(run: Run, settings: Settings = NO_SETTINGS) -> Explanation:
    """What the model of a run lacks.

    Returns
    -------
    Explanation
        With the verdict ``not_enough_data`` where the rows leave nothing to judge a model by.

    Raises
    ------
    FitError
        The run is of another test, or an output is missing.
    """
    if run.test == RECORD:
        return explain_record(run, settings)
    try:
        return Ladder.of(run, settings).found().explanation
    except RankDeficient as error:
        return _not_enough(run, str(error))


def _not_enough(run: Run, why: str) -> Explanation:
    nothing = Gap(math.nan, math.nan, math.nan, 0, math.nan, math.nan)
    n, c = run.y.shape
    unknown = frozen(np.full(n * c, math.nan))
    return Explanation(
        verdict="not_enough_data",
        summary=f"These rows cannot tell: {why}.",
        noise=NoiseFloor(math.nan, run.unit, {}, {}, "residual", 0),
        before=nothing,
        after=nothing,
        held_out_before=math.nan,
        where=(),
        where_after=(),
        steps=(),
        candidates=(),
        threshold=math.nan,
        next_measurements=(),
        smallest=(),
        invisible=(),
        untested={},
        notes=(Note(Severity.WARNING, "not_enough_data", why),),
        measured=frozen(run.y.T.ravel()),
        predicted_before=unknown,
        predicted=unknown,
        sigma=unknown,
        channel=frozen_int([channel for channel in range(c) for _ in range(n)]),
        channels=run.channels,
        unit=run.unit,
    )
