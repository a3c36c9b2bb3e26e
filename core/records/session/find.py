"""Where sessions stand, and which of them wait to be continued."""

from dataclasses import dataclass
from pathlib import Path

from core.errors import FormatError
from core.records.session.record import START_NAME, SessionRecord, read_session


def default_root() -> Path:
    """The folder that holds all sessions, unless the user chooses another one."""
    return Path.home() / "CalRig"


@dataclass(frozen=True, slots=True, eq=False)
class Unfinished:
    """A session that waits to be continued.

    Parameters
    ----------
    folder : where it stands
    record : what it holds; None if it cannot be read
    problem : why it cannot be read; empty if it can
    """

    folder: Path
    record: SessionRecord | None
    problem: str

    @property
    def done(self) -> int:
        """Steps of the plan with a position that counts."""
        if self.record is None:
            return 0
        return len({position.step.number for position in self.record.positions})


def unfinished(root: Path) -> tuple[Unfinished, ...]:
    """Sessions under `root` that were not finished, the newest first; damaged ones as well."""
    found: list[Unfinished] = []
    for start in sorted(root.glob(f"*/{START_NAME}"), reverse=True):
        try:
            record = read_session(start.parent)
        except FormatError as error:
            found.append(Unfinished(start.parent, None, str(error)))
            continue
        if not record.is_finished:
            found.append(Unfinished(start.parent, record, ""))
    return tuple(found)


def newest_session(root: Path, test: str) -> Path | None:
    """Folder of the session of a test that was begun last; None where there is none.

    Parameters
    ----------
    root : folder of all sessions
    test : as in `core.plans.plan.TESTS`
    """
    starts = sorted(root.glob(f"*/{START_NAME}"), key=lambda path: path.stat().st_mtime)
    for start in reversed(starts):
        try:
            record = read_session(start.parent)
        except FormatError:
            # A damaged one is told where sessions are resumed; here the next older one serves.
            continue
        if record.start.plan.test == test and record.positions:
            return start.parent
    return None
