"""Limits of the parameters with the decision rule, and which parts of the results are printed."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from gui.certificate.state import CertificateState, LimitRow, PartRow
from gui.certificate.text_form_view import embolden
from gui.certificate.texts import rule_titles
from gui.languages.shown import shown, shown_number
from gui.widgets.fields import ChoiceField

_NOMINAL, _LIMIT, _UNIT = 1, 2, 3


class LimitsForm(QWidget):
    """What is judged, and what is printed."""

    limit_edited = Signal(str, str, str)
    """Parameter, nominal value, limit; as typed."""
    rule_chosen = Signal(str)
    printed_toggled = Signal(int, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows: tuple[LimitRow, ...] = ()
        self._parts: tuple[PartRow, ...] = ()
        self._hint, self._rule_label, self._verdict = QLabel(), QLabel(), QLabel()
        self._printed = QLabel()
        self._state: CertificateState | None = None
        for label in (self._hint, self._verdict):
            label.setWordWrap(True)
        self._hint.setProperty("muted", True)
        for label in (self._verdict, self._printed):
            embolden(label)
        self.rule = ChoiceField()
        self._rule_label.setBuddy(self.rule)
        self.rule.activated.connect(self._on_rule)
        self.table = QTableWidget(0, 5)
        self.table.verticalHeader().hide()
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setStretchLastSection(True)
        self.table.itemChanged.connect(self._on_item)
        self.table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.parts = QListWidget()
        self.parts.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.parts.itemChanged.connect(self._on_part)
        unit = self.fontMetrics().height()
        self.table.setMinimumHeight(10 * unit)
        for place, width in enumerate((6, 5, 5, 4)):
            self.table.setColumnWidth(place, width * unit + unit // 2)
        self.parts.setMinimumHeight(8 * unit)
        row = QHBoxLayout()
        row.addWidget(self._rule_label)
        row.addWidget(self.rule, 1)
        column = QVBoxLayout(self)
        column.addWidget(self._hint)
        column.addWidget(self.table, 3)
        column.addLayout(row)
        column.addWidget(self._verdict)
        column.addWidget(self._printed)
        column.addWidget(self.parts, 2)
        self._retranslate()

    def render(self, state: CertificateState) -> None:
        """Show a state."""
        self._state = state
        self.setEnabled(bool(state.subject) and not state.issued)
        self.table.setEnabled(bool(state.limits))
        self.rule.setEnabled(bool(state.limits))
        self._show_limits(state.limits)
        self._show_parts(state.parts)
        self.rule.setCurrentIndex(self.rule.findData(state.rule))
        verdict = self.tr("Conformity: {verdict}").format(verdict=shown(state.verdict))
        self._verdict.setText(verdict if state.verdict else "")
        self._verdict.setVisible(bool(state.verdict))

    def _show_limits(self, rows: tuple[LimitRow, ...]) -> None:
        if rows == self._rows:
            return
        before = [(row.parameter, row.found) for row in self._rows]
        fresh = [(row.parameter, row.found) for row in rows] != before
        self._rows = rows
        blocker = QSignalBlocker(self.table)
        if fresh:
            self.table.setRowCount(len(rows))
        for place, row in enumerate(rows):
            texts = (row.symbol, row.nominal, row.limit, row.unit, shown_number(row.found))
            for column, text in enumerate(texts):
                item = self.table.item(place, column)
                if item is None:
                    item = QTableWidgetItem()
                    if column not in (_NOMINAL, _LIMIT):
                        item.setFlags(Qt.ItemFlag.ItemIsEnabled)
                    self.table.setItem(place, column, item)
                if item.text() != text:
                    item.setText(text)
                item.setToolTip(shown(row.problem or f"{row.parameter}: {text}"))
        if fresh:
            # Units of noise are wide: ``deg/sqrt(s)``; the heading is wider in some languages.
            self.table.resizeColumnToContents(_UNIT)
        blocker.unblock()

    def _show_parts(self, parts: tuple[PartRow, ...]) -> None:
        if parts == self._parts:
            return
        self._parts = parts
        blocker = QSignalBlocker(self.parts)
        while self.parts.count() > len(parts):
            self.parts.takeItem(self.parts.count() - 1)
        while self.parts.count() < len(parts):
            self.parts.addItem(QListWidgetItem())
        for place, part in enumerate(parts):
            item = self.parts.item(place)
            item.setText(shown(part.title))
            item.setToolTip(item.text())
            on = Qt.CheckState.Checked if part.printed else Qt.CheckState.Unchecked
            item.setCheckState(on)
        blocker.unblock()

    def _on_item(self, item: QTableWidgetItem) -> None:
        place = item.row()
        if item.column() in (_NOMINAL, _LIMIT) and place < len(self._rows):
            texts = [self.table.item(place, column) for column in (_NOMINAL, _LIMIT)]
            nominal, limit = ("" if one is None else one.text() for one in texts)
            self.limit_edited.emit(self._rows[place].parameter, nominal, limit)

    def _on_part(self, item: QListWidgetItem) -> None:
        on = item.checkState() == Qt.CheckState.Checked
        self.printed_toggled.emit(self.parts.row(item), on)

    def _on_rule(self, index: int) -> None:
        self.rule_chosen.emit(self.rule.itemData(index))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                self._rows, self._parts = (), ()
                self.render(self._state)

    def _retranslate(self) -> None:
        self._hint.setText(
            self.tr(
                "A parameter with a limit is judged: its deviation from the nominal value, 0 if"
                " none is given, in all sensors that have it. A check brings its verdict with it."
            )
        )
        self._rule_label.setText(self.tr("Decision rule"))
        self._printed.setText(self.tr("Printed"))
        self.table.setAccessibleName(self.tr("Limits of the parameters"))
        self.parts.setAccessibleName(self.tr("Parts of the results that are printed"))
        self.table.setHorizontalHeaderLabels(
            [
                self.tr("Parameter"),
                self.tr("Nominal"),
                self.tr("± Limit"),
                self.tr("Unit"),
                self.tr("Found"),
            ]
        )
        chosen = self.rule.currentData()
        self.rule.clear()
        for key, title in rule_titles().items():
            self.rule.addItem(shown(title), key)
        self.rule.setCurrentIndex(max(0, self.rule.findData(chosen)))
