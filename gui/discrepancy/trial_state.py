"""Everything that the page of blind trials shows."""

from dataclasses import dataclass

from gui.widgets.states import Tone


@dataclass(frozen=True, slots=True)
class NameRow:
    """One name to choose.

    Parameters
    ----------
    key, name, plain : identifier, standard name, plain words
    ticked : the operator names it
    """

    key: str
    name: str
    plain: str
    ticked: bool


@dataclass(frozen=True, slots=True)
class TrialState:
    """The page.

    Parameters
    ----------
    title, seal : the case; SHA-256 of what is hidden in it
    kinds, kind : keys and titles of the kinds of case; key of the next one's
    names : what can be named
    answer : the operator's answer in words
    opened : the seal is open
    lines : truth, both answers, and what the seal covers; empty while it is closed
    tone : of the operator's answer once the seal is open
    score : both scores in words
    can_open, can_begin : whether the buttons work
    """

    title: str
    seal: str
    kinds: tuple[tuple[str, str], ...]
    kind: str
    names: tuple[NameRow, ...]
    answer: str
    opened: bool
    lines: tuple[str, ...]
    tone: Tone
    score: str
    can_open: bool
    can_begin: bool
