"""The results page of an accuracy check: what the common page has, and the graph with verdicts."""

from collections.abc import Collection
from dataclasses import dataclass

from core.errors import Note
from gui.accuracy.checking import Checked
from gui.accuracy.picture import graph_of, traces_of
from gui.accuracy.state import Chip, GraphState, TraceToggle
from gui.accuracy.tables import chips_of, parts_of, rule_of, title_of
from gui.accuracy.texts import page_names
from gui.measuring.page import ResultsPage


@dataclass(frozen=True, slots=True, eq=False)
class AccuracyPage(ResultsPage):
    """The page.

    Parameters
    ----------
    chips : verdicts
    rule : the decision rule and what the uncertainty counts, as it goes into a report
    traces : what can be shown in the graph
    names : keys and names of the pages of the graph
    shown : key of the one that is shown
    graph : that page
    fresh : doubts that were not told before: a check is judged anew after every angle
    """

    chips: tuple[Chip, ...]
    rule: str
    traces: tuple[TraceToggle, ...]
    names: tuple[tuple[str, str], ...]
    shown: str
    graph: GraphState
    fresh: tuple[Note, ...] = ()

    @property
    def notes(self) -> tuple[Note, ...]:
        """Every doubt that the log shall tell."""
        return self.fresh


def page_of(checked: Checked, shown: str, hidden: Collection[str], level: float) -> AccuracyPage:
    """The page of a judged check.

    Parameters
    ----------
    checked : the check
    shown : page of the graph, of `PAGES`
    hidden : traces that are not shown
    level : the angle that the unit tells now, deg; NaN where none is known
    """
    found = checked.found
    return AccuracyPage(
        title=title_of(found),
        source=checked.source,
        parts=parts_of(found),
        chips=chips_of(found),
        rule=rule_of(checked),
        traces=traces_of(found, hidden),
        names=page_names(found.kind),
        shown=shown,
        graph=graph_of(found, checked.run, shown, hidden, level),
    )
