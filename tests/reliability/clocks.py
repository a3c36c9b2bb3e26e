"""The computer's clock is set while something is measured."""

import os
import random
from datetime import UTC, datetime, timedelta
from pathlib import Path

from core.archive.store import Archive
from core.records.session.record import read_session
from core.records.session.store import Session
from tests.reliability import seeds
from tests.reliability.fault import Found


class Clock:
    """A clock that somebody sets by up to a year, back or on, whenever it is looked at."""

    def __init__(self, rng: random.Random) -> None:
        self.set_back = False
        self._rng = rng
        self._moment = datetime(2024, 5, 14, 6, 30, 5, tzinfo=UTC)

    def now(self) -> datetime:
        """The time that it shows."""
        jump = self._rng.choice((10.0, 10.0, 10.0, 3600.0, -3600.0, 3.2e7, -3.2e7))
        self._moment += timedelta(seconds=jump)
        self.set_back = self.set_back or jump < 0.0
        return self._moment


def set_while_measuring(folder: Path, rng: random.Random, trials: int) -> Found:
    """The wall clock jumps between positions; their order is that of measuring all the same."""
    found = Found()
    for trial in range(trials):
        place = folder / f"{trial}"
        told: list[tuple[int, int]] = []
        clock = Clock(rng)
        with Session.create(place, seeds.start(), now=clock.now) as session:
            for step in session.record.start.plan.steps:
                position = session.accept(step, seeds.mean(), temperature_c=26.0)
                told.append((position.id, position.step.number))
        record = read_session(place)
        run = record.run()
        lost = int([(p.id, p.step.number) for p in record.positions] != told)
        lost += int(run.order.tolist() != list(range(len(told))))
        times = [datetime.fromisoformat(p.measured_utc) for p in record.positions]
        notes = [note.text for note in run.notes if note.subject == "clock_set_back"]
        lost += int((times != sorted(times)) != bool(notes))
        found += Found(1, lost, notes[0] if notes else "")
    return found


def set_while_archiving(folder: Path, rng: random.Random, trials: int) -> Found:
    """Files carry times of the past and of the future; what grows is taken in all the same."""
    found = Found()
    for trial in range(trials):
        place = folder / f"{trial}"
        for name in ("a", "b"):
            with Session.create(place / name, seeds.start()) as session:
                session.accept(session.record.start.plan.steps[0], seeds.mean(), temperature_c=26.0)
        lost = 0
        with Archive(place) as archive:
            for _ in range(4):
                for path in place.rglob("*"):
                    # Not older than the look before: a clock that is set back makes later times.
                    when = datetime.now(UTC).timestamp() + rng.choice((-5e8, 0.0, 5e8))
                    os.utime(path, (when, when))
                archive.refresh()
                with Session.open(place / "a") as session:
                    number = len(session.positions) % 8
                    step = session.record.start.plan.steps[number]
                    session.accept(step, seeds.mean(), temperature_c=26.0)
                    count = len(session.positions)
                archive.refresh()
                entries = {entry.path: entry.count for entry in archive.search().entries}
                lost += int(entries != {"a": count, "b": 1})
        found += Found(1, lost, "")
    return found
