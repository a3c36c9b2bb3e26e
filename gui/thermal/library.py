"""Sessions and records of the list, and what is found in them as one set."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject

from core.samples.run import Run
from gui.analysis import library
from gui.jobs import Jobs
from gui.thermal.state import Settings
from gui.thermal.working import Outcome, computed, read_source, simulated, sources_of


@dataclass(frozen=True, slots=True, eq=False)
class Entry(library.Entry):
    """One row of the list: a file, a folder, or the simulated cycle.

    Parameters
    ----------
    check : whether it only checks the compensation
    run : what it holds; None until it was read
    """

    check: bool = False
    run: Run | None = None


class Library(library.Library[Entry, Settings, Outcome]):
    """Keeps the sources and has them processed.

    Parameters
    ----------
    jobs : where the work is done
    """

    def __init__(self, jobs: Jobs, parent: QObject | None = None) -> None:
        method = library.Method("thermal", Entry, sources_of, _reading, _read, _unread, _outcome)
        super().__init__(jobs, method, Settings(), parent)

    def check(self, key: int, check: bool) -> None:
        """Let a row only check the compensation, or let it take part."""
        entry = self.get(key)
        if entry is not None and entry.check != check:
            self.exchange(replace(entry, check=check))


def _reading(settings: Settings) -> str:
    return settings.outputs


def _unread(entry: Entry) -> Entry:
    return replace(entry, run=None, error="")


def _read(entry: Entry, settings: Settings) -> Entry:
    if entry.run is not None:
        return entry
    run = simulated() if entry.path is None else read_source(entry.path, settings)
    return replace(entry, run=run)


def _outcome(entries: Sequence[Entry], settings: Settings) -> Outcome | None:
    runs = [entry.run for entry in entries if entry.run is not None and not entry.check]
    checks = [entry.run for entry in entries if entry.run is not None and entry.check]
    return computed(runs, checks, settings) if runs else None
