"""A session as data, also while another program measures into it; and as a run."""

import hashlib
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.errors import FormatError, Note, Severity
from core.records.replicates import replicates
from core.records.session.events import Event, Position, counting, event_from_json
from core.records.session.journal import Damaged, read_journal
from core.records.session.start import SessionStart, start_from_text
from core.records.text import decode, read_bytes
from core.samples.block import Channel
from core.samples.run import Run

START_NAME, JOURNAL_NAME, LOCK_NAME = "session.json", "positions.jsonl", "session.lock"

_PREFIX = {"accelerometer": "acc", "gyro": "rate"}
_OUTPUT = {"accelerometer": "acc", "gyro": "gyro"}
_NO_MEASUREMENT = ("counter", "time", "status")


@dataclass(frozen=True, slots=True, eq=False)
class SessionRecord:
    """What a session's folder holds.

    Parameters
    ----------
    folder : where it stands
    start : what was known before
    events : everything that happened, in order
    notes : what is damaged in the folder
    """

    folder: Path
    start: SessionStart
    events: tuple[Event, ...]
    notes: tuple[Note, ...] = ()

    @property
    def positions(self) -> tuple[Position, ...]:
        """The positions that count, in the order of measuring."""
        return counting(self.events)

    @property
    def attempts(self) -> tuple[Position, ...]:
        """Everything that was ever accumulated, in the order of measuring."""
        return tuple(event.position for event in self.events if event.position is not None)

    @property
    def is_finished(self) -> bool:
        """Whether the operator has finished it and it was not opened again since."""
        marks = [event.kind for event in self.events if event.kind in ("finished", "reopened")]
        return bool(marks) and marks[-1] == "finished"

    def run(self, sensor: str | None = None) -> Run:
        """The positions that count as a run.

        Outputs that are zero throughout (unused places of an assembly) are left out.

        Parameters
        ----------
        sensor : ``"accelerometer"`` or ``"gyro"``; None for the one that the test calibrates

        Raises
        ------
        FormatError
            Nothing has been accepted, or the device has no such sensor.
        """
        return _run(self, sensor or self.start.sensor)


def read_session(folder: Path) -> SessionRecord:
    """Read a session's folder without taking its lock.

    Raises
    ------
    FormatError
        It is no session, or its start document is damaged.
    """
    return read_session_damage(folder)[0]


def read_session_damage(folder: Path) -> tuple[SessionRecord, tuple[Damaged, ...]]:
    """Read a session's folder; also return the damaged lines of its journal.

    Raises
    ------
    FormatError
        As `read_session`.
    """
    path = folder / START_NAME
    start = start_from_text(decode(read_bytes(path), path), str(path))
    journal = folder / JOURNAL_NAME
    lines, damaged = read_journal(journal)
    events = tuple(event_from_json(line, start.channels) for line in lines)
    # A torn line that was told once, and continued after, is no new doubt.
    told = {event.reason for event in events if event.kind == "recovered"}
    notes = tuple(damage.note(journal) for damage in damaged if damage.text not in told)
    ids = [event.id for event in events]
    if ids != list(range(1, len(ids) + 1)):
        notes = (
            *notes,
            Note(
                Severity.ERROR,
                "events_missing",
                f"{journal}: events are missing or doubled (numbers {_gaps(ids)}); somebody changed"
                " the file, or the disk lost a part of it",
            ),
        )
    return SessionRecord(folder, start, events, notes), damaged


def _gaps(ids: list[int]) -> str:
    wrong = [number for place, number in enumerate(ids, start=1) if number != place]
    return ", ".join(map(str, wrong[:10])) + (", ..." if len(wrong) > 10 else "")


def _run(record: SessionRecord, sensor: str) -> Run:
    positions, start = record.positions, record.start
    if not positions:
        raise FormatError(record.folder, "no position has been accepted yet")
    means = np.array([position.accumulation.mean for position in positions])
    outputs = _outputs(start, sensor, means)
    if not outputs and not _tells_angles(start):
        raise FormatError(record.folder, f"the device has no {sensor} that gives other than zero")
    columns = [place for place, _, _ in outputs]
    on_table = start.plan.test == "rate_table"
    set_temperatures = np.array([position.set_temperature_c for position in positions])
    measured = np.array([position.temperature_c for position in positions])
    began = datetime.fromisoformat(start.started)
    dof = np.array([p.accumulation.se_dof[columns].min(initial=np.inf) for p in positions])
    conditions = start.conditions
    if not np.isfinite(conditions.accumulation_s):
        conditions = replace(conditions, accumulation_s=start.plan.accumulation_s)
    if not np.isfinite(conditions.sample_rate_hz):
        conditions = replace(conditions, sample_rate_hz=start.rate)
    return Run(
        test=_test(start.plan.test, sensor),
        sensor=sensor,
        device=start.device,
        channels=tuple(name for _, name, _ in outputs),
        axes=tuple(axis for _, _, axis in outputs),
        unit=start.channels[columns[0]].unit if columns else "",
        y=frozen(means[:, columns]),
        y_se=frozen(np.array([position.accumulation.se[columns] for position in positions])),
        run=replicates([(p.step.number, p.set_temperature_c) for p in positions]),
        order=frozen_int(np.arange(len(positions))),
        mount=tuple(position.step.mount for position in positions),
        head_deg=frozen([position.step.head_deg for position in positions]),
        set_rate_dps=frozen([p.step.rate_dps if on_table else np.nan for p in positions]),
        temperature_c=frozen(np.where(np.isfinite(measured), measured, set_temperatures)),
        t_s=frozen(
            [(datetime.fromisoformat(p.measured_utc) - began).total_seconds() for p in positions]
        ),
        conditions=conditions,
        extra={
            **_extra(start.channels, columns, means),
            **(
                _scatter(start.channels, outputs, positions)
                if start.plan.test == "accuracy"
                else {}
            ),
            "step": frozen([position.step.number for position in positions]),
            "attempt": frozen([position.attempt for position in positions]),
            "samples": frozen([position.accumulation.n for position in positions]),
            "lost_samples": frozen([position.accumulation.lost for position in positions]),
            "se_dof": frozen(dof),
            **(
                {"set_temperature_c": frozen(set_temperatures)}
                if np.isfinite(set_temperatures).any()
                else {}
            ),
        },
        meta=_meta(record),
        notes=(*record.notes, *_clock_notes(positions), *_position_notes(positions)),
    )


def _tells_angles(start: SessionStart) -> bool:
    """Whether an accuracy check can judge the angles that the unit computes itself."""
    roles = {channel.role for channel in start.channels}
    return start.plan.test == "accuracy" and {"angle.pitch", "angle.roll"} <= roles


def _test(plan_test: str, sensor: str) -> str:
    """A gyro on the dividing head stands in static positions, an accelerometer is measured."""
    if plan_test in ("dividing_head", "static_positions"):
        return "dividing_head" if sensor == "accelerometer" else "static_positions"
    return plan_test


def _outputs(start: SessionStart, sensor: str, means: FloatArray) -> list[tuple[int, str, str]]:
    """Place, name and axis of each used output of a sensor kind.

    Names are those of the legacy layouts. The sensors of an assembly (``adc.N``) are of the kind
    that the test calibrates, and their own axis is called Z (practicum, models 1.3 and 3.3).
    """
    found: list[tuple[int, str, str]] = []
    for place, channel in enumerate(start.channels):
        kind, _, which = channel.role.partition(".")
        ours = kind == _PREFIX.get(sensor) or (kind == "adc" and sensor == start.sensor)
        if ours and np.any(means[:, place]):
            axis = which if which in ("x", "y", "z") else "z"
            found.append((place, f"{_OUTPUT[sensor]}_{which}", axis))
    return found


def _extra(
    channels: tuple[Channel, ...], outputs: list[int], means: FloatArray
) -> dict[str, FloatArray]:
    """The further channels under the names of the legacy layouts."""
    extra: dict[str, FloatArray] = {}
    for place, channel in enumerate(channels):
        if place in outputs or channel.role in _NO_MEASUREMENT or not np.any(means[:, place]):
            continue
        name = extra_name(channel)
        while name in extra:
            name += "_"
        extra[name] = frozen(means[:, place])
    return extra


def _scatter(
    channels: tuple[Channel, ...],
    outputs: list[tuple[int, str, str]],
    positions: tuple[Position, ...],
) -> dict[str, FloatArray]:
    """Standard deviation of single samples of the outputs and of the unit's own angles.

    Of the angles also the standard error of the mean; that of the outputs stands in `Run.y_se`.
    """
    std = np.array([position.accumulation.std for position in positions])
    se = np.array([position.accumulation.se for position in positions])
    found = {f"std_{name}": frozen(std[:, place]) for place, name, _ in outputs}
    for place, channel in enumerate(channels):
        if channel.role.startswith("angle."):
            name = extra_name(channel)
            found[f"std_{name}"] = frozen(std[:, place])
            found[f"se_{name}"] = frozen(se[:, place])
    return found


def extra_name(channel: Channel) -> str:
    """Column name of a channel that is not looked at: ``temp.acc.x`` -> ``temp_acc_x``."""
    kind, _, which = channel.role.partition(".")
    which = which.replace("rate.", "gyro.").replace("adc.", "").replace(".", "_")
    match kind:
        case "acc" | "mag" | "adc":
            return f"{kind}_{which}"
        case "rate":
            return f"gyro_{which}"
        case "angle":
            return f"unit_{which}_deg"
        case "temp":
            return f"temp_{which or 'case'}"
        case _:
            return f"channel_{channel.name}"


def _meta(record: SessionRecord) -> dict[str, str | float | bool]:
    start = record.start
    journal = read_bytes(record.folder / JOURNAL_NAME)
    base = start.base
    began = datetime.fromisoformat(start.started)
    return {
        "source": record.folder.name,
        "source_sha256": hashlib.sha256(journal).hexdigest(),
        "plan": start.plan.id,
        "profile": start.profile,
        "profile_sha256": start.profile_sha256,
        "operator": start.operator,
        "software": start.software,
        "measured_utc": began.astimezone(UTC).isoformat(timespec="seconds"),
        "base_alpha_arcmin": base.alpha_arcmin,
        "base_beta_arcmin": base.beta_arcmin,
        "base_gamma_deg": base.gamma_deg,
        "base_psi_deg": base.psi_deg,
        **{f"tilter_{name}": value for name, value in start.tilter.items()},
    }


def _clock_notes(positions: tuple[Position, ...]) -> list[Note]:
    """A clock that was set back while the session was measured."""
    times = [datetime.fromisoformat(position.measured_utc) for position in positions]
    for before, after, one, other in zip(positions, positions[1:], times, times[1:], strict=False):
        if other < one:
            text = (
                f"the computer's clock was set back between positions {before.step.number} and"
                f" {after.step.number} ({one:%Y-%m-%d %H:%M:%S}, then {other:%Y-%m-%d %H:%M:%S}"
                " UTC): their order is right, their times are not; do not judge drift by them"
            )
            return [Note(Severity.WARNING, "clock_set_back", text)]
    return []


def _position_notes(positions: tuple[Position, ...]) -> list[Note]:
    return [
        Note(note.severity, note.subject, f"position {position.step.number}: {note.text}")
        for position in positions
        for note in position.accumulation.notes
    ]
