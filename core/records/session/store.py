"""A session that is being measured.

Order of writing: the journal first, synced; then the legacy text, which follows from it. When a
function returns, what it did is on the disk; when it raises `StorageError`, the message says what
is. Nothing is ever deleted: repeating, discarding and taking back are events of their own.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from core.errors import FormatError, LabError, StorageError
from core.plans.plan import Step
from core.records.atomic import not_stored, sync_folder, write_text_atomic
from core.records.legacy.layout import LEGACY_FORMATS
from core.records.names import safe_name
from core.records.run_file import run_text
from core.records.session.events import Event, Position, RawRange, event_to_json
from core.records.session.journal import Journal
from core.records.session.legacy_mirror import LegacyMirror
from core.records.session.lock import SessionLock
from core.records.session.record import (
    JOURNAL_NAME,
    LOCK_NAME,
    START_NAME,
    SessionRecord,
    read_session_damage,
)
from core.records.session.start import SessionStart, start_to_text
from core.samples.accumulate import Accumulation
from core.samples.run import Run


def utc_now() -> datetime:
    """The time that events are stamped with."""
    return datetime.now(UTC)


class Session:
    """Writer of a session's folder; make one by `create` or `open`, end it by `close`."""

    def __init__(
        self,
        record: SessionRecord,
        journal: Journal,
        lock: SessionLock,
        now: Callable[[], datetime],
    ) -> None:
        self._record = record
        self._journal = journal
        self._lock = lock
        self._now = now
        self._mirror = LegacyMirror(record.folder, record.start)

    @classmethod
    def create(
        cls, folder: Path, start: SessionStart, *, now: Callable[[], datetime] = utc_now
    ) -> "Session":
        """Begin a session in a new or empty folder.

        Raises
        ------
        StorageError
            The folder already holds a session, or cannot be written.
        """
        try:
            folder.mkdir(parents=True, exist_ok=True)
            # Until its name is on the disk, a power cut takes the folder with all that is in it.
            sync_folder(folder.parent)
        except OSError as error:
            raise not_stored(folder, error, "nothing has been measured yet") from error
        if (folder / START_NAME).exists() or (folder / JOURNAL_NAME).exists():
            raise StorageError(
                f"{folder}: already holds a session; open it, or choose another folder"
            )
        lock = SessionLock(folder / LOCK_NAME)
        try:
            journal = Journal(folder / JOURNAL_NAME, create=True)
        except LabError:
            lock.release()
            raise
        try:
            # The start document comes last: a folder is a session once it is there.
            write_text_atomic(folder / START_NAME, start_to_text(start))
        except LabError:
            journal.close()
            # Left behind, the empty journal would keep the folder from ever being taken.
            (folder / JOURNAL_NAME).unlink(missing_ok=True)
            lock.release()
            raise
        return cls(SessionRecord(folder, start, ()), journal, lock, now)

    @classmethod
    def open(cls, folder: Path, *, now: Callable[[], datetime] = utc_now) -> "Session":
        """Continue a session, also after a crash; `record.notes` tells what was damaged.

        Raises
        ------
        FormatError
            The folder holds no session, or its start document is damaged.
        StorageError
            Another program measures into it, or it cannot be written.
        """
        if not (folder / START_NAME).is_file():
            raise FormatError(folder, f"is no session: it holds no {START_NAME}")
        lock = SessionLock(folder / LOCK_NAME)
        try:
            record, damaged = read_session_damage(folder)
            session = cls(record, Journal(folder / JOURNAL_NAME), lock, now)
        except LabError:
            lock.release()
            raise
        told = {event.reason for event in record.events if event.kind == "recovered"}
        try:
            for damage in damaged:
                if damage.last and damage.text not in told:
                    session._add("recovered", reason=damage.text)
            if record.is_finished:
                session._add("reopened")
            session._check_mirror()
        except LabError:
            session.close()
            raise
        return session

    @property
    def record(self) -> SessionRecord:
        """The session as it stands on the disk."""
        return self._record

    @property
    def folder(self) -> Path:
        """Where it stands."""
        return self._record.folder

    @property
    def positions(self) -> tuple[Position, ...]:
        """The positions that count, in the order of measuring."""
        return self._record.positions

    @property
    def legacy_path(self) -> Path | None:
        """The legacy text file beside the journal, None if the session writes none."""
        return self._mirror.path

    @property
    def legacy_error(self) -> StorageError | None:
        """Why the legacy text is behind the journal; None while it holds the rows that count."""
        return self._mirror.error

    @property
    def run_path(self) -> Path:
        """The run file that `finish` writes."""
        return self.folder / f"{safe_name(self._record.start.device)}.run.csv"

    def run(self, sensor: str | None = None) -> Run:
        """The positions that count as a run, see `SessionRecord.run`."""
        return self._record.run(sensor)

    def accept(
        self,
        step: Step,
        accumulation: Accumulation,
        *,
        temperature_c: float = float("nan"),
        set_temperature_c: float = float("nan"),
        raw: RawRange | None = None,
        supersedes: tuple[int, ...] = (),
    ) -> Position:
        """Store an accumulation that counts; it is durable when the function returns.

        Parameters
        ----------
        step : the step, with the angle or rate that was really set
        accumulation : the means; its channels must be those of the start document
        temperature_c, set_temperature_c : measured and set temperature
        raw : where the bytes stand; sync the raw log before
        supersedes : positions that this one is a repeat of; they no longer count

        Raises
        ------
        StorageError
            It could not be stored; the message tells what is.
        """
        position = self._position(step, accumulation, temperature_c, set_temperature_c, raw)
        self._check_known(supersedes)
        self._add("accepted", position=position, targets=supersedes)
        if supersedes:
            self._mirror.rewrite(self._record)
        else:
            self._mirror.append(self._record)
        return position

    def reject(
        self,
        step: Step,
        accumulation: Accumulation,
        reason: str,
        *,
        temperature_c: float = float("nan"),
        set_temperature_c: float = float("nan"),
        raw: RawRange | None = None,
    ) -> Position:
        """Store an accumulation that does not count; `restore` lets it count after all.

        Raises
        ------
        StorageError
            It could not be stored.
        """
        position = self._position(step, accumulation, temperature_c, set_temperature_c, raw)
        self._add("rejected", position=position, reason=reason)
        return position

    def discard(self, *ids: int, reason: str = "") -> None:
        """Let positions no longer count; they stay in the journal.

        Raises
        ------
        StorageError
            It could not be stored; they still count.
        """
        self._check_known(ids)
        self._add("discarded", targets=ids, reason=reason)
        self._mirror.rewrite(self._record)

    def restore(self, *ids: int, instead_of: tuple[int, ...] = (), reason: str = "") -> None:
        """Let positions count again, `instead_of` others that then no longer do.

        Raises
        ------
        StorageError
            It could not be stored; nothing has changed.
        """
        self._check_known((*ids, *instead_of))
        self._add("restored", targets=ids, instead_of=instead_of, reason=reason)
        self._mirror.rewrite(self._record)

    def finish(self) -> Path | None:
        """Mark the session as done and write its run file.

        Returns
        -------
        Path or None
            The run file; None if no position counts or every output is zero.

        Raises
        ------
        StorageError
            The run file or the mark could not be stored; every position is.
        """
        path = None
        try:
            run = self.run()
        except FormatError:  # no position counts, or every output is zero
            run = None
        if run is not None:
            path = self.run_path
            write_text_atomic(path, run_text(run))
        self._mirror.rewrite(self._record)
        self._add("finished")
        self.close()
        return path

    def close(self) -> None:
        """Let other programs in; the session can be opened again and continued."""
        self._journal.close()
        self._lock.release()

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def _next_id(self) -> int:
        return max((event.id for event in self._record.events), default=0) + 1

    def _position(
        self,
        step: Step,
        accumulation: Accumulation,
        temperature_c: float,
        set_temperature_c: float,
        raw: RawRange | None,
    ) -> Position:
        if accumulation.channels != self._record.start.channels:
            raise ValueError("the accumulation has other channels than the session")
        layout = LEGACY_FORMATS.get(self._record.start.legacy)
        told = math.isfinite(set_temperature_c) or math.isfinite(temperature_c)
        if layout is not None and layout.has("set temperature") and not told:
            raise ValueError(f"{layout.title} holds the set temperature of every position")
        before = [
            p
            for p in self._record.attempts
            if p.step.number == step.number and repr(p.set_temperature_c) == repr(set_temperature_c)
        ]
        return Position(
            id=self._next_id,
            attempt=len(before) + 1,
            step=step,
            measured_utc=self._now().isoformat(timespec="milliseconds"),
            accumulation=accumulation,
            temperature_c=temperature_c,
            set_temperature_c=set_temperature_c,
            raw=raw,
        )

    def _check_known(self, ids: tuple[int, ...]) -> None:
        unknown = set(ids) - {position.id for position in self._record.attempts}
        if unknown:
            raise ValueError(f"no positions of these numbers: {sorted(unknown)}")

    def _add(
        self,
        kind: str,
        *,
        position: Position | None = None,
        targets: tuple[int, ...] = (),
        instead_of: tuple[int, ...] = (),
        reason: str = "",
    ) -> None:
        event = Event(
            id=self._next_id,
            utc=self._now().isoformat(timespec="milliseconds"),
            kind=kind,
            position=position,
            targets=targets,
            instead_of=instead_of,
            reason=reason,
        )
        self._journal.append(event_to_json(event))
        self._record = replace(self._record, events=(*self._record.events, event))

    def _check_mirror(self) -> None:
        note = self._mirror.check(self._record, f"{self._now():%Y%m%d%H%M%S}")
        if note is not None:
            self._record = replace(self._record, notes=(*self._record.notes, note))
