"""Issued certificates, and the withdrawal of one."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from core.certificates.register import Issued
from gui.certificate.state import CertificateState
from gui.certificate.texts import status_words, verdict_of
from gui.languages.shown import shown

_NUMBER = Qt.ItemDataRole.UserRole


class RegisterList(QWidget):
    """The certificates of the laboratory."""

    opened = Signal(str)
    """Number of the certificate to be shown."""
    withdrawn = Signal(str)
    """Reason why the shown one holds no longer."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: tuple[Issued, ...] | None = None
        self._hint = QLabel()
        self._hint.setWordWrap(True)
        self._hint.setProperty("muted", True)
        self.list = QTreeWidget()
        self.list.setRootIsDecorated(False)
        self.list.setColumnCount(7)
        self.list.currentItemChanged.connect(self._on_current)
        self._reason_label, self.reason, self.withdraw = QLabel(), QLineEdit(), QPushButton()
        self._reason_label.setBuddy(self.reason)
        self.withdraw.clicked.connect(self._on_withdraw)
        row = QHBoxLayout()
        row.addWidget(self._reason_label)
        row.addWidget(self.reason, 1)
        row.addWidget(self.withdraw)
        column = QVBoxLayout(self)
        column.addWidget(self._hint)
        column.addWidget(self.list, 1)
        column.addLayout(row)
        self._retranslate()

    def render(self, state: CertificateState) -> None:
        """Show a state."""
        if state.register != self._entries:
            self._entries = state.register
            self._show(state.register)
        if state.chosen != self._chosen():
            self._choose(state.chosen)
        entry = next((one for one in state.register if one.number == state.chosen), None)
        holds = state.issued and entry is not None and not entry.withdrawn
        self.reason.setEnabled(holds)
        self.withdraw.setEnabled(holds and not state.busy)

    def _show(self, entries: tuple[Issued, ...]) -> None:
        blocker = QSignalBlocker(self.list)
        chosen = self._chosen()
        self.list.clear()
        for one in entries:
            texts = [
                one.number,
                shown(status_words(one)),
                one.serial,
                one.issued,
                shown(verdict_of(one)),
                one.item,
                one.customer,
            ]
            item = QTreeWidgetItem(texts)
            item.setData(0, _NUMBER, one.number)
            tip = one.damage or one.withdrawn or f"{one.number}, {one.path}"
            for column in range(len(texts)):
                item.setToolTip(column, tip)
            self.list.addTopLevelItem(item)
        for column in range(5):
            self.list.resizeColumnToContents(column)
        blocker.unblock()
        self._choose(chosen)

    def _choose(self, number: str) -> None:
        blocker = QSignalBlocker(self.list)
        items = [self.list.topLevelItem(row) for row in range(self.list.topLevelItemCount())]
        chosen = [item for item in items if item is not None and item.data(0, _NUMBER) == number]
        if chosen:
            self.list.setCurrentItem(chosen[0])
        else:
            self.list.clearSelection()
            self.list.setCurrentItem(None)  # type: ignore[arg-type]
        blocker.unblock()

    def _chosen(self) -> str:
        item = self.list.currentItem()
        return "" if item is None else str(item.data(0, _NUMBER))

    def _on_current(self, item: QTreeWidgetItem | None) -> None:
        if item is not None:
            self.opened.emit(item.data(0, _NUMBER))

    def _on_withdraw(self) -> None:
        self.withdrawn.emit(self.reason.text())
        if self.reason.text().strip():
            self.reason.clear()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._show(self._entries or ())

    def _retranslate(self) -> None:
        self._hint.setText(
            self.tr(
                "Choose one to see it. Nothing changes an issued certificate: Replace begins"
                " a new one that names it, Withdraw states that it holds no longer."
            )
        )
        self.list.setHeaderLabels(
            [
                self.tr("No."),
                self.tr("State"),
                self.tr("Serial no."),
                self.tr("Issued"),
                self.tr("Verdict"),
                self.tr("Item"),
                self.tr("Customer"),
            ]
        )
        self.list.setAccessibleName(self.tr("Issued certificates"))
        self._reason_label.setText(self.tr("Reason"))
        self.withdraw.setText(self.tr("Withdraw"))
