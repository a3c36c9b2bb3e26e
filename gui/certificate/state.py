"""What the tab Certificates shows, as plain data."""

from dataclasses import dataclass

from core.certificates.certificate import Order, Surroundings
from core.certificates.laboratory import Laboratory
from core.certificates.register import Issued
from core.errors import Note
from gui.widgets.states import ActionBarState


@dataclass(frozen=True, slots=True)
class LimitRow:
    """A parameter and what it must keep; all sensors that have it are judged alike.

    Parameters
    ----------
    parameter : its name
    symbol, unit : as the results write them
    found : smallest and largest value, as text
    nominal, limit : as they were typed; no limit, no verdict
    problem : why they cannot be used; empty if they can
    """

    parameter: str
    symbol: str
    unit: str
    found: str
    nominal: str = ""
    limit: str = ""
    problem: str = ""


@dataclass(frozen=True, slots=True)
class PartRow:
    """A part of the results, and whether it is printed."""

    title: str
    printed: bool = True


@dataclass(frozen=True, slots=True)
class CertificateState:
    """The tab.

    Parameters
    ----------
    subject : of what the results are; empty while there are none
    number : that the draft will get, or that the shown certificate has
    issued : whether an issued certificate is shown, which nothing can change any more
    order, surroundings, laboratory : what is stated
    limits : empty where a check brings its verdict with it
    rule : key of `core.procedures.conformity.RULES`
    verdict : the statement of conformity in words; empty for none
    parts : of the results
    needs : what ISO/IEC 17025 asks for and is missing, in words
    doubts : what cannot be right
    register : issued certificates, the newest first
    chosen : number of the one that is chosen in the list; empty for none
    busy : whether files are being read or written
    actions : the row of buttons
    hint : instead of the preview while there is nothing
    """

    subject: str
    number: str
    issued: bool
    order: Order
    surroundings: Surroundings
    laboratory: Laboratory
    limits: tuple[LimitRow, ...]
    rule: str
    verdict: str
    parts: tuple[PartRow, ...]
    needs: tuple[str, ...]
    doubts: tuple[Note, ...]
    register: tuple[Issued, ...]
    chosen: str
    busy: bool
    actions: ActionBarState
    hint: str
