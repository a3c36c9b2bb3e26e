"""The certificate as it stands in the form: what is typed, what it makes of the results."""

from dataclasses import replace
from datetime import date, datetime

from core.certificates.certificate import Certificate, Order, Surroundings
from core.certificates.laboratory import Laboratory
from core.certificates.limits import Conformity, judge_stated
from core.certificates.measured import Measured
from gui.certificate.html import results_html
from gui.certificate.limits import Limits, limits_of
from gui.certificate.state import PartRow
from gui.certificate.texts import title_of
from gui.measuring.printed import parts_of
from gui.settings import Section

KEPT = ("customer", "contact", "item", "model", "condition")
"""Fields of an order that the next one begins with."""


class Draft:
    """Results with everything that is stated about them.

    Parameters
    ----------
    measured : the results
    order, surroundings : what is stated
    rule : key of `core.procedures.conformity.RULES`
    typed : limits that were typed before, of `Limits.typed`

    Raises
    ------
    FormatError
        The results hold a part of no known kind.
    """

    def __init__(
        self,
        measured: Measured,
        order: Order,
        surroundings: Surroundings,
        rule: str,
        typed: Section,
    ) -> None:
        self.measured = measured
        self.order = order
        self.surroundings = surroundings
        self.rule = rule
        self.limits = limits_of(measured.stated, typed)
        self.parts: tuple[PartRow, ...] = ()
        self.write()

    def write(self) -> None:
        """Put the results into the words of the language that is spoken now."""
        self._results = [results_html((part,)) for part in self.measured.printed]
        printed = [row.printed for row in self.parts] or [True] * len(self._results)
        self.parts = tuple(
            PartRow(title_of(part), on)
            for part, on in zip(parts_of(self.measured.printed), printed, strict=True)
        )

    @property
    def sensor(self) -> str:
        """What was measured, which limits are remembered for."""
        return self.measured.subject

    @property
    def results(self) -> tuple[str, ...]:
        """What is printed, as pieces of HTML."""
        return tuple(
            piece
            for row, pieces in zip(self.parts, self._results, strict=True)
            if row.printed
            for piece in pieces
        )

    def set_printed(self, place: int, printed: bool) -> None:
        """Print a part, or leave it out."""
        self.parts = tuple(
            replace(row, printed=printed) if number == place else row
            for number, row in enumerate(self.parts)
        )

    def set_limit(self, parameter: str, nominal: str, limit: str) -> None:
        """Judge a parameter by what was typed."""
        self.limits: Limits = self.limits.with_typed(parameter, nominal, limit)

    def conformity(self) -> Conformity | None:
        """The statement of conformity; None without limits."""
        if not self.measured.stated:
            return self.measured.conformity
        return judge_stated(self.measured.stated, self.limits.usable, self.rule)

    def certificate(self, laboratory: Laboratory, number: str) -> Certificate:
        """The certificate, with the parts that are printed."""
        printed = tuple(
            part for row, part in zip(self.parts, self.measured.printed, strict=True) if row.printed
        )
        return Certificate(
            number,
            laboratory,
            self.order,
            replace(self.measured, printed=printed),
            self.surroundings,
            self.conformity(),
        )


def first_order(measured: Measured, before: Section) -> Order:
    """The order that a draft begins with.

    Parameters
    ----------
    measured : tells serial number and day
    before : the last order's `KEPT` fields
    """
    origin = measured.provenance
    told = {key: str(before[key]) for key in KEPT if isinstance(before.get(key), str)}
    return Order(
        **told,
        serial=origin.device,
        calibrated=day_of_moment(origin.measured_utc),
        issued=date.today().isoformat(),
    )


def day_of_moment(moment: str) -> str:
    """The day of an ISO moment on the wall calendar of this computer; empty where unknown."""
    try:
        return datetime.fromisoformat(moment).astimezone().date().isoformat()
    except ValueError:
        return ""
