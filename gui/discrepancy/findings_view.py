"""The right-hand side: candidates, what to measure next, what these rows can show; the report."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QPushButton,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from gui.discrepancy.candidate_view import CandidateView, ChanceBar, ProposalView
from gui.discrepancy.cause_view import CauseView
from gui.discrepancy.grade_view import GradeView
from gui.discrepancy.overview_view import OverviewView
from gui.discrepancy.state import DetailState, NextCard, StoryState
from gui.discrepancy.words import printed
from gui.languages.shown import shown
from gui.widgets.export_foot import ExportFoot
from gui.widgets.note_line import NoteLine
from gui.widgets.page_scroll import PageScroll
from gui.widgets.word_label import paragraph

_NEXT, _GRADE, _TRIAL = 1, 2, 3
"""Places of what to measure next, of what the rows can show, and of blind trials."""


class FindingsView(QWidget):
    """Judgement above, three pages below, the export at the foot."""

    chosen = Signal(str)
    plan_opened = Signal(int)
    plan_kept = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: StoryState | None = None
        unit = self.fontMetrics().height()
        self.overview = OverviewView()
        self._trial = ""
        self.pages = QTabWidget()
        self.pages.setDocumentMode(True)
        self.pages.setUsesScrollButtons(False)
        self.pages.setElideMode(Qt.TextElideMode.ElideRight)
        self._columns: list[QVBoxLayout] = []
        for _ in range(3):
            page = QWidget()
            column = QVBoxLayout(page)
            column.setContentsMargins(0, unit // 2, unit // 2, unit // 2)
            column.setSpacing(unit // 2)
            column.addStretch(1)
            self.pages.addTab(PageScroll(page), "")
            self._columns.append(column)
        self.foot = ExportFoot(two_rows=True)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 4)
        column.addWidget(self.overview)
        column.addWidget(self.pages, 1)
        column.addWidget(self.foot)
        self._name_pages()

    @property
    def candidates(self) -> list[CandidateView]:
        """All candidates on the page, from above."""
        cards = [w for w in _widgets(self._columns[0]) if isinstance(w, ProposalView)]
        return [candidate for card in cards for candidate in card.candidates]

    def render(self, state: StoryState) -> None:
        """Show a state."""
        old, self._state = self._state, state
        self.overview.render(state)
        fresh = old is None
        if (
            fresh
            or old.proposals != state.proposals
            or old.detail != state.detail
            or (old.notes != state.notes)
        ):
            self._render_candidates(state, rebuilt=fresh or old.proposals != state.proposals)
        tied = any(len(card.tied) > 1 for card in state.proposals)
        if fresh or old.following != state.following or old.proposals != state.proposals:
            self._render_following(state.following, tied)
        if fresh or old.lights != state.lights:
            self._render_grade(state)
        self._name_pages()

    def put_trial(self, page: QWidget) -> None:
        """Take the page of blind trials; it is there while a case is."""
        self.pages.addTab(page, "")
        self.pages.setTabVisible(_TRIAL, False)
        self._name_pages()

    def show_grade(self) -> None:
        """Bring the page to the front that tells what the rows can show."""
        self.pages.setCurrentIndex(_GRADE)

    def show_trial(self, case: str | None) -> None:
        """Show the page of a case when it begins; None for no case."""
        self.pages.setTabVisible(_TRIAL, case is not None)
        # What nobody measured needs no further measurement.
        self.pages.setTabVisible(_NEXT, case is None)
        if case is not None and case != self._trial:
            self.pages.setCurrentIndex(_TRIAL)
        self._trial = case or ""

    # --- pages ------------------------------------------------------------------------------------

    def _render_candidates(self, state: StoryState, *, rebuilt: bool) -> None:
        column = self._columns[0]
        kept = () if rebuilt else tuple(w for w in _widgets(column) if isinstance(w, ProposalView))
        _clear(column, kept)
        place = len(kept)
        if rebuilt:
            for card in state.proposals:
                view = ProposalView(card)
                view.chosen.connect(self.chosen)
                column.insertWidget(place, view)
                place += 1
        for candidate in self.candidates:
            candidate.mark(candidate.key == state.chosen)
        if state.detail is not None:
            column.insertWidget(place, _detail(state.detail))
            place += 1
        for note in state.notes:
            column.insertWidget(place, NoteLine(note))
            place += 1

    def _render_following(self, cards: tuple[NextCard, ...], tied: bool) -> None:
        column = self._columns[1]
        _clear(column)
        if not cards:
            text = self.tr("Nothing is undecided: no further measurement is proposed.")
            if tied:
                text = self.tr("No series that was tried is likely to tell these names apart.")
            column.insertWidget(0, paragraph(text))
        for place, card in enumerate(cards):
            column.insertWidget(place, self._next(place, card))

    def _next(self, place: int, card: NextCard) -> QWidget:
        unit = self.fontMetrics().height()
        frame = QFrame()
        frame.setFrameShape(QFrame.Shape.StyledPanel)
        rows = QVBoxLayout(frame)
        rows.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        rows.setSpacing(unit // 4)
        rows.addWidget(paragraph(printed(shown(card.title)), bold=True))
        rows.addWidget(paragraph(printed(shown(card.why))))
        for number, part in enumerate(card.parts, 1):
            rows.addWidget(paragraph(f"{number}. {printed(shown(part))}"))
        rows.addWidget(ChanceBar(card))
        foot = QHBoxLayout()
        foot.addWidget(paragraph(card.facts, muted=True), 1)
        rows.addLayout(foot)
        if not card.opens:
            return frame
        hands = QHBoxLayout()
        hands.addStretch(1)
        for words, told in (
            (self.tr("Keep this plan"), self._on_keep),
            (self.tr("Open this plan"), self._on_plan),
        ):
            button = QPushButton(words)
            button.setProperty("place", place)
            button.clicked.connect(told)
            hands.addWidget(button)
        rows.addLayout(hands)
        return frame

    def _render_grade(self, state: StoryState) -> None:
        column = self._columns[2]
        _clear(column)
        if state.lights:
            column.insertWidget(
                0, paragraph(self.tr("From which size on these rows name an effect"))
            )
            column.insertWidget(1, GradeView(state.lights))

    def _on_plan(self) -> None:
        self.plan_opened.emit(self.sender().property("place"))

    def _on_keep(self) -> None:
        self.plan_kept.emit(self.sender().property("place"))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._name_pages()
            if self._state is not None:
                # Built anew: the words of cards and buttons are written when they are made.
                state, self._state = self._state, None
                self.render(state)

    def _name_pages(self) -> None:
        count = 0 if self._state is None else len(self._state.following)
        titles = [self.tr("Candidates"), self.tr("Measure next"), self.tr("What can be seen")]
        if count:
            titles[1] = self.tr("Measure next ({count})").format(count=count)
        titles.append(self.tr("Practice"))
        for place, title in enumerate(titles[: self.pages.count()]):
            self.pages.setTabText(place, title)


def _detail(detail: DetailState) -> QWidget:
    """The chosen candidate in words, with its equation and its picture."""
    frame = QFrame()
    unit = frame.fontMetrics().height()
    picture = CauseView(4.5)
    picture.render(detail.key, detail.name)
    words = QVBoxLayout()
    words.setSpacing(unit // 4)
    words.addWidget(paragraph(detail.name, bold=True))
    plain = detail.plain[:1].upper() + detail.plain[1:]
    words.addWidget(paragraph(plain if plain.endswith(".") else f"{plain}."))
    if detail.equation:
        words.addWidget(paragraph(f"U + {detail.equation}", muted=True))
    row = QHBoxLayout()
    row.addWidget(picture, 0, Qt.AlignmentFlag.AlignTop)
    row.addLayout(words, 1)
    column = QVBoxLayout(frame)
    column.setContentsMargins(0, unit // 4, 0, unit // 4)
    column.setSpacing(unit // 4)
    column.addLayout(row)
    for told, words in detail.lines:
        line = f"{shown(told)}: {shown(words)}"
        column.addWidget(paragraph(line if line.endswith(".") else f"{line}."))
    return frame


def _widgets(column: QVBoxLayout) -> list[QWidget]:
    items = [column.itemAt(place) for place in range(column.count())]
    widgets = [item.widget() for item in items if item is not None]
    return [widget for widget in widgets if widget is not None]


def _clear(column: QVBoxLayout, kept: Sequence[QWidget] = ()) -> None:
    for widget in _widgets(column):
        if widget not in kept:
            column.removeWidget(widget)
            widget.hide()
            widget.deleteLater()
