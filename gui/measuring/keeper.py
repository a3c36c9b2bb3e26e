"""The session on the disk: what was accepted stays, whatever happens to the program."""

import contextlib
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from core.errors import StorageError
from core.plans.plan import Plan, Step
from core.records.legacy.layout import legacy_for
from core.records.names import safe_name
from core.records.session.events import Position, RawRange
from core.records.session.start import SessionStart
from core.records.session.store import Session
from core.samples.accumulate import Accumulation
from core.samples.block import Channel
from drivers.profile import Profile
from gui.measuring.settings import MeasuringSettings


@dataclass(frozen=True, slots=True)
class _Done:
    """An act that can be taken back: a position accepted, or discarded."""

    kind: str
    position: Position
    superseded: tuple[int, ...] = ()


class Keeper:
    """Begins, continues and ends a session; each of its methods returns after the disk has it."""

    def __init__(self) -> None:
        self._session: Session | None = None
        self._acts: list[_Done] = []

    @property
    def session(self) -> Session | None:
        """The session that is being measured."""
        return self._session

    @property
    def positions(self) -> tuple[Position, ...]:
        """Positions that count, in the order of measuring."""
        return () if self._session is None else self._session.positions

    @property
    def last(self) -> Position | None:
        """The position that was accepted last and still counts."""
        return self.positions[-1] if self.positions else None

    @property
    def can_undo(self) -> bool:
        """Whether there is an act of this sitting to take back."""
        return bool(self._acts)

    def begin(self, folder: Path, start: SessionStart) -> None:
        """Begin a session in a new folder; raises `StorageError`."""
        session = Session.create(folder, start)
        self.close()
        self._session = session

    def resume(self, folder: Path) -> Session:
        """Continue a session; raises `StorageError` or `FormatError`."""
        session = Session.open(folder)
        self.close()
        self._session = session
        return session

    def close(self) -> None:
        """Leave the session as it is, to be continued."""
        if self._session is not None:
            self._session.close()
        self._session = None
        self._acts = []

    def finish(self) -> None:
        """Mark the session as done; raises `StorageError`."""
        if self._session is not None:
            self._session.finish()
        self._session = None
        self._acts = []

    def attach_raw(self, path: Path) -> None:
        """Give the raw bytes a second name in the session's folder; they are not copied.

        Where the disk knows no second names they stay in the folder that they are written to,
        under the same name.
        """
        if self._session is not None:
            beside = self._session.folder / path.name
            with contextlib.suppress(OSError):
                if not beside.exists():
                    beside.hardlink_to(path)

    def accept(
        self,
        step: Step,
        accumulation: Accumulation,
        set_temperature_c: float,
        raw: RawRange | None,
        superseded: tuple[int, ...],
    ) -> Position:
        """Store a position; it is durable when this returns, else `StorageError` is raised."""
        position = self._open().accept(
            step,
            accumulation,
            temperature_c=accumulation.of_role("temp"),
            set_temperature_c=set_temperature_c,
            raw=raw,
            supersedes=superseded,
        )
        self._acts.append(_Done("accepted", position, superseded))
        return position

    def discard(self, position: Position) -> None:
        """Let a position no longer count; raises `StorageError`."""
        self._open().discard(position.id)
        self._acts.append(_Done("discarded", position))

    def undo(self) -> Position:
        """Take the latest act back; return the position that it was about."""
        act = self._acts[-1]
        if act.kind == "discarded":
            self._open().restore(act.position.id, reason="undone")
        elif act.superseded:
            self._open().restore(*act.superseded, instead_of=(act.position.id,), reason="undone")
        else:
            self._open().discard(act.position.id, reason="undone")
        self._acts.pop()
        return act.position

    def _open(self) -> Session:
        if self._session is None:
            raise StorageError("no session is open")
        return self._session


def start_document(
    device: str,
    sensor: str,
    channels: tuple[Channel, ...],
    rate: float,
    plan: Plan,
    settings: MeasuringSettings,
    profile: Profile,
    layout: str,
    operator: str,
) -> SessionStart:
    """What is known before the first position."""
    measured = replace(
        plan,
        accumulation_s=settings.accumulation_s,
        settle_s=settings.settle_s,
        temperatures_c=settings.cycle_c if settings.thermo else (),
    )
    legacy = legacy_for(layout, plan.test, plan)
    return SessionStart(
        device=device,
        sensor=sensor,
        channels=channels,
        rate=rate,
        plan=measured,
        started=datetime.now().astimezone().isoformat(timespec="seconds"),
        profile=profile.id,
        profile_text=profile.text,
        conditions=settings.conditions(),
        base=settings.base,
        tilter=settings.tilter_scalars(),
        settings=settings.extra(),
        operator=operator,
        legacy="" if legacy is None else legacy.id,
    )


def proposed_name(device: str, plan: Plan, when: datetime) -> str:
    """Name of the folder of a session that begins now."""
    return f"{when:%Y%m%d_%H%M}_{safe_name(device)}_{safe_name(plan.id)}"


def free_folder(parent: Path, name: str) -> Path:
    """A folder of this name that does not exist yet; ``_2``, ``_3``... where it does."""
    stem = safe_name(name)
    folder = parent / stem
    count = 2
    while folder.exists():
        folder = parent / f"{stem}_{count}"
        count += 1
    return folder
