"""A tab with a list of records that are worked out as one set: clicks in, its state out."""

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from gui.analysis.library import Entry, Library
from gui.analysis.records import Refusals, beside
from gui.messages import Messages
from gui.widgets.records_page import ListRow, RecordsState
from gui.widgets.states import ActionBarState, ActionItem, FindingsState

E = TypeVar("E", bound=Entry)
S = TypeVar("S")


class RecordsPresenter(Generic[E, S], QObject):
    """What such tabs share; a tab adds what it draws and says.

    Parameters
    ----------
    library : the records and what was found
    source : of the messages
    messages : where refused records are told
    actions : what the buttons of the tab's own do, by their keys
    """

    changed = Signal(object)
    """A new state."""

    def __init__(
        self,
        library: Library[E, S, Any],
        source: str,
        messages: Messages,
        actions: Mapping[str, Callable[[], None]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._library = library
        self._current = 0
        self._refusals = Refusals(source, messages)
        self._findings: FindingsState | None = None
        self._actions = {"simulate": self.simulate, "remove": self.remove, **actions}
        library.changed.connect(self._on_library)

    @property
    @abstractmethod
    def state(self) -> object:
        """The tab as it is now."""

    # --- what the operator does -------------------------------------------------------------------

    def add(self, names: Sequence[str]) -> None:
        """Read files, or all of a folder."""
        key = self._library.add([Path(name) for name in names])
        if key:
            self.choose(key)

    def simulate(self) -> None:
        """Put what is made up into the list."""
        self.choose(self._library.simulate())

    def choose(self, key: int) -> None:
        """Make a record the chosen one."""
        if key != self._current:
            self._current = key
            self._tell()

    def remove(self) -> None:
        """Take the chosen record out of the list; its file stays."""
        keys = [entry.key for entry in self._library.entries]
        if self._current in keys:
            gone, self._current = self._current, beside(keys, self._current)
            self._library.remove(gone)

    def decide(self, settings: S) -> None:
        """Work with other settings."""
        self._library.decide(settings)

    def act(self, key: str) -> None:
        """A button of the row of actions."""
        self._actions[key]()

    # --- what is shown ----------------------------------------------------------------------------

    @abstractmethod
    def _look(self) -> None:
        """Make what depends on the result and on what is shown of it."""

    @abstractmethod
    def _refused(self) -> tuple[str, str]:
        """What is told of a record that cannot be used, with a gap for its ``{name}``; a remedy."""

    @abstractmethod
    def _title(self, entry: E) -> str:
        """The first line of a record."""

    @abstractmethod
    def _detail(self, entry: E) -> str:
        """The second line of a record that can be used."""

    @abstractmethod
    def _hint(self) -> str:
        """What stands instead of the picture; empty if there is one."""

    @abstractmethod
    def _items(self) -> tuple[ActionItem, ...]:
        """The row of buttons."""

    def _page(self) -> RecordsState:
        return RecordsState(
            tuple(self._row(entry) for entry in self._library.entries),
            self._current,
            self._hint(),
            self._findings,
            ActionBarState(self._items()),
        )

    def _row(self, entry: E) -> ListRow:
        detail = "" if entry.error else self._detail(entry)
        return ListRow(entry.key, self._title(entry), detail, entry.error)

    def _on_library(self) -> None:
        self._look()
        self._refusals.tell(self._library.entries, *self._refused())
        self._tell()

    def _tell(self) -> None:
        self.changed.emit(self.state)
