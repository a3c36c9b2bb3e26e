"""The page of blind trials: the seal, the names to tick, the answer, the score."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gui.discrepancy.trial_presenter import TrialPresenter
from gui.discrepancy.trial_state import TrialState
from gui.languages.shown import shown
from gui.widgets.fields import ChoiceField
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class TrialView(QWidget):
    """The widget of the page.

    Parameters
    ----------
    presenter : what clicks call
    """

    def __init__(self, presenter: TrialPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._state: TrialState | None = None
        self._rendering = False
        unit = self.fontMetrics().height()
        self.title, self.seal, self.asked = WordLabel(), WordLabel(), WordLabel()
        self.answer, self.score, self.lines = WordLabel(), WordLabel(), WordLabel()
        self.names = QListWidget()
        self.names.setSpacing(unit // 8)
        self.names.itemChanged.connect(self._on_ticked)
        self.reveal, self.again, self.kinds = QPushButton(), QPushButton(), ChoiceField()
        self._kinds = QLabel()
        self._kinds.setBuddy(self.kinds)
        self.kinds.setMinimumContentsLength(10)
        self.kinds.setSizeAdjustPolicy(
            ChoiceField.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.kinds.activated.connect(self._on_kind)
        self.reveal.clicked.connect(presenter.open_seal)
        self.again.clicked.connect(presenter.begin)
        hands = QHBoxLayout()
        hands.addWidget(self.reveal)
        hands.addWidget(self.again)
        hands.addStretch(1)
        kinds = QHBoxLayout()
        kinds.addWidget(self._kinds)
        kinds.addWidget(self.kinds, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 3)
        for label in (self.title, self.seal, self.asked):
            column.addWidget(label)
        column.addWidget(self.names, 100)
        column.addWidget(self.answer)
        column.addLayout(hands)
        column.addLayout(kinds)
        column.addWidget(self.lines)
        column.addWidget(self.score)
        # Takes the room of the names once the seal is open.
        column.addStretch(1)
        for label in (self.title, self.seal, self.asked, self.answer, self.score, self.lines):
            label.setWordWrap(True)
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        for label in (self.title, self.score):
            font = label.font()
            font.setBold(True)
            label.setFont(font)
        for label in (self.seal, self.asked):
            label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
        self._retranslate()

    def render(self, state: TrialState | None) -> None:
        """Show a state; None leaves what is there, for the page is hidden."""
        if state is None or state == self._state:
            return
        self._state = state
        self.title.setText(state.title)
        # A hash has no spaces to break at.
        parts = [state.seal[place : place + 16] for place in range(0, len(state.seal), 16)]
        self.seal.setText(self.tr("Sealed by SHA-256: {seal}").format(seal=" ".join(parts)))
        self._render_names(state)
        self.answer.setText(self.tr("Your answer: {names}").format(names=shown(state.answer)))
        self.lines.setText("\n".join(shown(line) for line in state.lines))
        self.lines.setVisible(state.opened)
        self.score.setText(state.score)
        self.reveal.setEnabled(state.can_open)
        self.again.setEnabled(state.can_begin)
        titles = [shown(title[:1].upper() + title[1:]) for _, title in state.kinds]
        if titles != [self.kinds.itemText(place) for place in range(self.kinds.count())]:
            self.kinds.clear()
            self.kinds.addItems(titles)
        self.kinds.setCurrentIndex([key for key, _ in state.kinds].index(state.kind))
        for widget in (self.names, self.asked):
            widget.setVisible(not state.opened)
        self._colour()

    def _render_names(self, state: TrialState) -> None:
        self._rendering = True
        keys = [self.names.item(i).data(_KEY) for i in range(self.names.count())]
        if keys != [row.key for row in state.names]:
            self.names.clear()
            for row in state.names:
                item = QListWidgetItem(shown(row.name))
                item.setData(_KEY, row.key)
                item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
                item.setToolTip(shown(row.plain))
                self.names.addItem(item)
        for place, row in enumerate(state.names):
            ticked = Qt.CheckState.Checked if row.ticked else Qt.CheckState.Unchecked
            self.names.item(place).setCheckState(ticked)
        self._rendering = False

    def _on_ticked(self, item: QListWidgetItem) -> None:
        if not self._rendering:
            on = item.checkState() == Qt.CheckState.Checked
            self._presenter.tick(str(item.data(_KEY)), on)

    def _on_kind(self, place: int) -> None:
        if self._state is not None:
            self._presenter.choose(self._state.kinds[place][0])

    def _colour(self) -> None:
        if self._state is not None:
            self.lines.setStyleSheet(f"color: {current_theme().tones[self._state.tone]}")

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self.names.clear()
            state, self._state = self._presenter.state, None
            self.render(state)
        elif event.type() == QEvent.Type.PaletteChange and hasattr(self, "_state"):
            self._colour()

    def _retranslate(self) -> None:
        self.asked.setText(
            self.tr(
                "Look at the residuals against each regressor, tick what you think is hidden"
                " (nothing, one effect or two), and reveal."
            )
        )
        self.names.setAccessibleName(self.tr("Names to choose from"))
        self.reveal.setText(self.tr("Reveal"))
        self.again.setText(self.tr("Next Case"))
        self._kinds.setText(self.tr("The next case is"))
        self.kinds.setAccessibleName(self._kinds.text())


_KEY = Qt.ItemDataRole.UserRole
