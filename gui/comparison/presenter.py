"""The comparison: files in, `ComparisonState` out."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import LabError
from core.procedures.comparison import ROWS
from core.records.gyro_facts import Facts, read_facts
from core.samples.run import Conditions
from gui.comparison.state import ComparisonState, SourceRow
from gui.comparison.tables import findings_of, say
from gui.jobs import Jobs
from gui.messages import Messages

SOURCE = "comparison"
G_MPS2 = 9.8106


@dataclass(frozen=True, slots=True)
class _Read:
    facts: tuple[Facts, ...]
    refused: tuple[tuple[Path, LabError], ...]


class ComparisonPresenter(QObject):
    """Keeps what the files tell, and how the operator calls the gyros.

    Parameters
    ----------
    jobs : read the files
    messages : where it is told
    """

    changed = Signal(object)
    """A new `ComparisonState`."""

    def __init__(self, jobs: Jobs, messages: Messages, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._messages = messages
        self._facts: dict[int, Facts] = {}
        self._names: dict[int, str] = {}
        self._next = 1
        self._reading = 0
        self.g_mps2 = G_MPS2

    @property
    def state(self) -> ComparisonState:
        """The page as it is now."""
        named = [(self._names[key], facts) for key, facts in self._facts.items()]
        return ComparisonState(
            tuple(self._row(key) for key in self._facts),
            findings_of(named) if named else None,
            say(
                "Add calibrations of gyros, runs on the rate table or on the head, and the"
                " coefficients that the Allan tab exports. Files of one unit share a column: give"
                " them the same name."
            ),
            self._reading > 0,
        )

    def add(self, paths: Sequence[Path]) -> None:
        """Read files and put their gyros into the table."""
        conditions = Conditions(g_mps2=self.g_mps2)
        self._reading += 1
        self._jobs.start(
            "comparison", lambda: _read(paths, conditions), self._on_read, self._on_failed
        )
        self._tell()

    def rename(self, key: int, name: str) -> None:
        """Call a gyro by another name; that of another row puts both into one column."""
        if key in self._names and name.strip() and name.strip() != self._names[key]:
            self._names[key] = name.strip()
            self._tell()

    def remove(self, keys: Sequence[int]) -> None:
        """Take gyros out of the table; their files stay."""
        for key in keys:
            self._facts.pop(key, None)
            self._names.pop(key, None)
        self._tell()

    def _row(self, key: int) -> SourceRow:
        facts = self._facts[key]
        words = {row: name for row, name, _ in ROWS}
        told = [words[row].lower() for row in (*facts.quantities, *facts.in_output)]
        return SourceRow(key, self._names[key], facts.source, ", ".join(dict.fromkeys(told)))

    def _on_read(self, result: object) -> None:
        if not isinstance(result, _Read):
            raise TypeError(f"reading brought {type(result).__name__}")
        self._reading -= 1
        self._messages.clear(SOURCE)
        for facts in result.facts:
            self._facts[self._next] = facts
            self._names[self._next] = facts.name
            self._next += 1
        for path, error in result.refused:
            what = say("{name} is not compared").format(name=path.name)
            self._messages.tell_error(SOURCE, what, error)
        self._tell()

    def _on_failed(self, error: LabError) -> None:
        self._reading -= 1
        self._messages.tell_error(SOURCE, say("Not compared"), error)
        self._tell()

    def _tell(self) -> None:
        self.changed.emit(self.state)


def _read(paths: Sequence[Path], conditions: Conditions) -> _Read:
    facts: list[Facts] = []
    refused: list[tuple[Path, LabError]] = []
    for path in paths:
        try:
            facts.extend(read_facts(path, conditions))
        except LabError as error:
            refused.append((path, error))
    return _Read(tuple(facts), tuple(refused))
