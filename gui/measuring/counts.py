"""How far a plan is, by the positions that count."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from core.plans.plan import Step
from core.records.session.events import Position


@dataclass(frozen=True, slots=True)
class Progress:
    """One visit to a temperature, or the only one.

    Parameters
    ----------
    counts : positions of each step, by its number
    before : positions that only teach what to expect
    done : the position of each step that the present pass has already
    finished : whether all passes are done
    """

    counts: Mapping[int, int]
    before: tuple[Position, ...]
    done: tuple[Position, ...]
    finished: bool


def progress_of(
    steps: Sequence[Step], here: Sequence[Position], elsewhere: Iterable[Position], passes: int
) -> Progress:
    """Say which positions the present pass has.

    Parameters
    ----------
    steps : of the plan
    here : positions of this visit, in the order of measuring
    elsewhere : positions of other visits
    passes : how often each step is to be measured
    """
    by_step: dict[int, list[Position]] = {step.number: [] for step in steps}
    others = list(elsewhere)
    for position in here:
        by_step.setdefault(position.step.number, []).append(position)
    counts = {number: len(found) for number, found in by_step.items()}
    present = min((counts[step.number] for step in steps), default=0)
    finished = present >= passes
    present = min(present, passes - 1)
    done = tuple(found[-1] for found in by_step.values() if len(found) > present)
    taken = {position.id for position in done}
    before = tuple(p for p in (*others, *here) if p.id not in taken)
    return Progress(counts, before, done, finished)


def visits_of(positions: Sequence[Position], cycle_c: Sequence[float]) -> dict[int, int]:
    """Place in the thermal cycle of each position, by its id, from the order of measuring.

    The same temperature comes twice in a cycle; the later one is meant once the chamber has been
    at another in between.
    """
    visits: dict[int, int] = {}
    place = 0
    for position in positions:
        set_c = position.set_temperature_c
        if not math.isnan(set_c) and cycle_c and set_c != cycle_c[place]:
            later = [i for i in range(place, len(cycle_c)) if cycle_c[i] == set_c]
            earlier = [i for i in range(place) if cycle_c[i] == set_c]
            place = (later or earlier or [place])[0]
        visits[position.id] = place
    return visits
