"""The plans to choose from, and the steps of the chosen one to tick."""

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from gui.advisor.state import AdvisorState, ProposalRow, StepRow
from gui.languages.shown import shown
from gui.widgets.fields import ChoiceField, NumberField

_KEY = Qt.ItemDataRole.UserRole


class PlanView(QWidget):
    """Proposals above, steps below, a row to add a step."""

    chosen = Signal(str, str)
    """Method and plan."""
    kept = Signal(int, bool)
    """Number of a step, and whether it is measured."""
    added = Signal(str, float)
    """Mount, and angle or rate."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rendering = False
        self._proposals: tuple[ProposalRow, ...] = ()
        self._steps: tuple[StepRow, ...] = ()
        self.proposals, self.steps = QListWidget(), QListWidget()
        self.mount, self.value = ChoiceField(), NumberField(-3600.0, 3600.0, 2, "°")
        self.add = QPushButton()
        self._heads = [QLabel() for _ in range(2)]
        unit = self.fontMetrics().height()
        for head in self._heads:
            font = head.font()
            font.setBold(True)
            head.setFont(font)
            head.setContentsMargins(unit // 3, unit // 3, 0, unit // 4)
        self.proposals.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.proposals.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        split = QSplitter(Qt.Orientation.Vertical)
        for head, part in zip(self._heads, (self.proposals, self._below(unit)), strict=True):
            pane = QWidget()
            column = QVBoxLayout(pane)
            column.setContentsMargins(0, 0, 0, 0)
            column.setSpacing(0)
            column.addWidget(head)
            column.addWidget(part)
            split.addWidget(pane)
        split.setChildrenCollapsible(False)
        split.setSizes([17 * unit, 20 * unit])
        whole = QVBoxLayout(self)
        whole.setContentsMargins(unit // 2, 0, 0, 0)
        whole.addWidget(split)
        self.proposals.currentRowChanged.connect(self._on_row)
        self.steps.itemChanged.connect(self._on_item)
        self.add.clicked.connect(self._on_add)
        self._retranslate()

    def _below(self, unit: int) -> QWidget:
        pane = QWidget()
        column = QVBoxLayout(pane)
        column.setContentsMargins(0, 0, 0, unit // 3)
        column.setSpacing(unit // 3)
        column.addWidget(self.steps, 1)
        row = QHBoxLayout()
        row.addWidget(self.mount)
        row.addWidget(self.value)
        row.addWidget(self.add)
        row.addStretch(1)
        column.addLayout(row)
        return pane

    def render(self, state: AdvisorState) -> None:
        """Show a state."""
        self._state = state
        self._rendering = True
        if state.proposals != self._proposals:
            self._proposals = state.proposals
            self.proposals.clear()
            height = round(2.7 * self.fontMetrics().height())
            for row in state.proposals:
                item = QListWidgetItem(f"{shown(row.title)}\n{shown(row.detail)}")
                item.setSizeHint(QSize(0, height))
                self.proposals.addItem(item)
        keys = [row.key for row in state.proposals]
        self.proposals.setCurrentRow(keys.index(state.current) if state.current in keys else -1)
        if state.steps != self._steps:
            self._render_steps(state.steps)
        self.value.setSuffix(" °/s" if state.on_table else " °")
        names = [self.mount.itemText(place) for place in range(self.mount.count())]
        if names != list(state.mounts):
            self.mount.clear()
            self.mount.addItems(list(state.mounts))
        self._rendering = False

    def _render_steps(self, steps: tuple[StepRow, ...]) -> None:
        """Tick in place where only ticks have changed, so that the list does not jump."""
        same = [(s.number, s.text) for s in steps] == [(s.number, s.text) for s in self._steps]
        self._steps = steps
        if not same:
            self.steps.clear()
            group = ""
            height = round(1.5 * self.fontMetrics().height())
            for step in steps:
                if step.group != group:
                    group = step.group
                    self._add_heading(group)
                item = QListWidgetItem(shown(step.text))
                item.setSizeHint(QSize(0, height))
                item.setData(_KEY, step.number)
                item.setFlags(
                    Qt.ItemFlag.ItemIsEnabled
                    | Qt.ItemFlag.ItemIsSelectable
                    | Qt.ItemFlag.ItemIsUserCheckable
                )
                self.steps.addItem(item)
        kept = {step.number: step.kept for step in steps}
        for place in range(self.steps.count()):
            item = self.steps.item(place)
            number = item.data(_KEY)
            if number is not None:
                state = Qt.CheckState.Checked if kept[number] else Qt.CheckState.Unchecked
                item.setCheckState(state)

    def _add_heading(self, text: str) -> None:
        item = QListWidgetItem(shown(text))
        font = item.font()
        font.setBold(True)
        item.setFont(font)
        item.setFlags(Qt.ItemFlag.ItemIsEnabled)
        self.steps.addItem(item)

    def _on_row(self, row: int) -> None:
        if not self._rendering and row >= 0:
            self.chosen.emit(*self._proposals[row].key)

    def _on_item(self, item: QListWidgetItem) -> None:
        number = item.data(_KEY)
        if not self._rendering and number is not None:
            self.kept.emit(number, item.checkState() is Qt.CheckState.Checked)

    def _on_add(self) -> None:
        self.added.emit(self.mount.currentText(), self.value.value())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                self._proposals, self._steps = (), ()
                self.render(self._state)

    def _retranslate(self) -> None:
        words = (
            self.tr("What this rig can do, the best first"),
            self.tr("Steps: tick off what you would leave out"),
        )
        for head, text in zip(self._heads, words, strict=True):
            head.setText(text)
        self.proposals.setAccessibleName(self.tr("Plans"))
        self.steps.setAccessibleName(self.tr("Steps"))
        self.mount.setAccessibleName(self.tr("Mount of the step to add"))
        self.value.setAccessibleName(self.tr("Angle or rate of the step to add"))
        self.add.setText(self.tr("Add step"))
