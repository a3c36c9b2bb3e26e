"""The records of a list: which is chosen when one goes, which cannot be used."""

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from core.errors import Severity
from gui.messages import Messages
from gui.widgets.states import BannerState


class Record(Protocol):
    """One record of a list: its file, and why it cannot be used."""

    @property
    def path(self) -> Path | None:
        """None for a simulated one."""
        ...

    @property
    def error(self) -> str:
        """Empty if it can be used."""
        ...


def beside(keys: Sequence[int], gone: int) -> int:
    """Return the key that is chosen when one of them goes: the next, else the last; 0 for none."""
    place = list(keys).index(gone)
    rest = [key for key in keys if key != gone]
    return rest[min(place, len(rest) - 1)] if rest else 0


class Refusals:
    """Tells of the records that cannot be used, once when others are refused than before.

    Parameters
    ----------
    source : of the messages
    """

    def __init__(self, source: str, messages: Messages) -> None:
        self._source = source
        self._messages = messages
        self._told = ""

    def tell(self, records: Sequence[Record], what: str, remedy: str) -> None:
        """Show the first refused one; `what` has a gap for its ``{name}``."""
        refused = [one for one in records if one.error]
        told = "\n".join(one.error for one in refused)
        if told == self._told:
            return
        self._told = told
        if not refused:
            self._messages.clear(self._source)
            return
        path = refused[0].path
        name = "" if path is None else path.name
        why = f"{refused[0].error}."
        banner = BannerState(Severity.ERROR, what.format(name=name), why, remedy)
        self._messages.show(self._source, banner)
