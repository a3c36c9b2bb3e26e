"""The head of the findings: verdict, gap, how sure each name is, what to do next."""

from html import escape

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from gui.discrepancy.grade_view import Light
from gui.discrepancy.state import StepRow, StoryState
from gui.discrepancy.words import printed
from gui.languages.shown import shown, shown_number
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class OverviewView(QWidget):
    """Everything that is read first, and from further away."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: StoryState | None = None
        unit = self.fontMetrics().height()
        self.title, self.source, self.verdict, self.summary = (WordLabel() for _ in range(4))
        self.gap, self.floors, self.advice = QLabel(), QLabel(), WordLabel()
        for label, size in (
            (self.title, 1.0),
            (self.verdict, 1.3),
            (self.gap, 1.8),
            (self.advice, 1.0),
        ):
            font = label.font()
            font.setBold(True)
            font.setPointSizeF(font.pointSizeF() * size)
            label.setFont(font)
        for label in (self.title, self.source, self.verdict, self.summary, self.advice):
            label.setWordWrap(True)
            label.setTextFormat(Qt.TextFormat.PlainText)
        for label in (self.verdict, self.summary, self.advice, self.gap):
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        for label in (self.source, self.floors):
            label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
        size = QHBoxLayout()
        size.addWidget(self.gap)
        size.addWidget(self.floors, 1, Qt.AlignmentFlag.AlignBottom)
        self._steps = QGridLayout()
        self._steps.setHorizontalSpacing(unit // 3)
        self._steps.setVerticalSpacing(unit // 6)
        self._steps.setColumnStretch(1, 1)
        self._arrow = Light(Tone.ACTION)
        self._next = QHBoxLayout()
        self._next.setSpacing(unit // 3)
        self._next.addWidget(self._arrow, 0, Qt.AlignmentFlag.AlignTop)
        self._next.addWidget(self.advice, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(unit // 4)
        column.addWidget(self.title)
        column.addWidget(self.source)
        column.addWidget(self.verdict)
        column.addLayout(size)
        column.addWidget(self.summary)
        column.addLayout(self._steps)
        column.addLayout(self._next)
        self._retranslate()

    def render(self, state: StoryState) -> None:
        """Show a state."""
        old, self._state = self._state, state
        self.title.setText(state.title)
        self.source.setText(state.source)
        self.verdict.setText(state.verdict)
        self.summary.setText(state.summary)
        self.summary.setVisible(bool(state.summary))
        self.gap.setText(shown_number(state.gaps))
        for label in (self.gap, self.floors):
            label.setVisible(bool(state.gaps))
        self.gap.setAccessibleName(f"{shown_number(state.gaps)} {self.floors.text()}")
        self.advice.setText(printed(shown(state.advice)))
        for widget in (self.advice, self._arrow):
            widget.setVisible(bool(state.advice))
        self._colour()
        if old is None or old.found != state.found:
            self._render_steps(state.found)

    def _render_steps(self, rows: tuple[StepRow, ...]) -> None:
        while (item := self._steps.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.hide()
                widget.deleteLater()
        for place, row in enumerate(rows):
            words = WordLabel()
            words.setWordWrap(True)
            words.setTextFormat(Qt.TextFormat.RichText)
            name, certainty = shown(row.name), shown(row.certainty)
            words.setText(f"<b>{escape(name)}</b>, {escape(certainty)}")
            light = Light(row.tone)
            light.setAccessibleName(f"{name}, {certainty}")
            self._steps.addWidget(light, place, 0, Qt.AlignmentFlag.AlignTop)
            self._steps.addWidget(words, place, 1)

    def _colour(self) -> None:
        if self._state is not None:
            colour = current_theme().tones[self._state.tone]
            for label in (self.verdict, self.gap):
                label.setStyleSheet(f"color: {colour}")

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                # Built anew: the words of the steps are written when they are made.
                state, self._state = self._state, None
                self.render(state)
        elif event.type() == QEvent.Type.PaletteChange and hasattr(self, "_state"):
            self._colour()

    def _retranslate(self) -> None:
        self.floors.setText(self.tr("times the noise floor; 1 is the best"))
