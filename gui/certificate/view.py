"""Form left, pages right, what is missing below the form, actions at the bottom."""

from pathlib import Path

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QFileDialog,
    QFrame,
    QLabel,
    QScrollArea,
    QStackedWidget,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from core.errors import Note, Severity
from gui.certificate.laboratory_view import LaboratoryForm
from gui.certificate.limits_view import LimitsForm
from gui.certificate.order_view import OrderForm
from gui.certificate.presenter import CertificatePresenter
from gui.certificate.preview_view import PreviewView
from gui.certificate.register_view import RegisterList
from gui.certificate.state import CertificateState
from gui.languages.shown import shown
from gui.widgets.action_bar import ActionBar
from gui.widgets.note_line import NoteLine
from gui.widgets.page_scroll import PageScroll
from gui.widgets.panes import lay_panes
from gui.widgets.word_label import WordLabel


class CertificateView(QWidget):
    """Shows a `CertificateState` and the preview."""

    def __init__(self, presenter: CertificatePresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._notes: tuple[Note, ...] = ()
        self._dialog: QFileDialog | None = None
        self.title, self.hint = QLabel(), WordLabel()
        self.order, self.limits = OrderForm(), LimitsForm()
        self.laboratory, self.register = LaboratoryForm(), RegisterList()
        self.pages = QTabWidget()
        self.preview = PreviewView()
        self.action_bar = ActionBar()
        self._needs = QVBoxLayout()
        self._needs_area = QScrollArea()
        self._middle = QStackedWidget()
        self._build()
        self._connect()
        self._retranslate()
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        font = self.title.font()
        font.setBold(True)
        font.setPointSizeF(font.pointSizeF() * 1.3)
        self.title.setFont(font)
        for page in (self.order, self.limits, self.laboratory, self.register):
            self.pages.addTab(page if page is self.register else PageScroll(page), "")
        self.pages.setDocumentMode(True)
        needs = QWidget()
        self._needs.setContentsMargins(0, 0, 0, 0)
        self._needs.setSpacing(unit // 4)
        needs.setLayout(self._needs)
        self._needs_area.setWidget(needs)
        self._needs_area.setWidgetResizable(True)
        self._needs_area.setFrameShape(QFrame.Shape.NoFrame)
        self._needs_area.setMaximumHeight(8 * unit)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(unit // 2, unit // 2, 0, 0)
        column.setSpacing(unit // 2)
        column.addWidget(self.title)
        column.addWidget(self.pages, 1)
        column.addWidget(self._needs_area)
        self.hint.setWordWrap(True)
        self.hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.hint.setContentsMargins(3 * unit, unit, 3 * unit, unit)
        self._middle.addWidget(self.hint)
        self._middle.addWidget(self.preview)
        lay_panes(self, ((left, 2, 36), (self._middle, 3, 48)), self.action_bar)

    def _connect(self) -> None:
        presenter = self._presenter
        presenter.changed.connect(self.render)
        presenter.previewed.connect(self.preview.render_paper)
        self.order.order_edited.connect(presenter.set_order)
        self.order.surroundings_edited.connect(presenter.set_surroundings)
        self.limits.limit_edited.connect(presenter.set_limit)
        self.limits.rule_chosen.connect(presenter.set_rule)
        self.limits.printed_toggled.connect(presenter.set_printed)
        self.laboratory.edited.connect(presenter.set_laboratory)
        self.register.opened.connect(presenter.open)
        self.register.withdrawn.connect(presenter.withdraw)
        self.action_bar.triggered.connect(self._on_action)

    def render(self, state: CertificateState) -> None:
        """Show a state."""
        self.title.setText(self._title_of(state))
        for part in (self.order, self.limits, self.laboratory, self.register):
            part.render(state)
        self.action_bar.render(state.actions)
        self.hint.setText(state.hint)
        self._middle.setCurrentWidget(self.hint if state.hint else self.preview)
        self._render_needs(state)

    def _title_of(self, state: CertificateState) -> str:
        if not state.subject:
            return self.tr("No results yet")
        words = self.tr("No. {number}, issued") if state.issued else self.tr("Draft No. {number}")
        return f"{shown(state.subject)}: {words.format(number=state.number)}"

    def _render_needs(self, state: CertificateState) -> None:
        notes = list(state.doubts)
        if state.needs:
            needs = ", ".join(shown(need) for need in state.needs)
            words = self.tr("ISO/IEC 17025 asks for: {list}").format(list=needs)
            notes.append(Note(Severity.WARNING, "needs", words))
        if tuple(notes) == self._notes:
            return
        self._notes = tuple(notes)
        while item := self._needs.takeAt(0):
            if (old := item.widget()) is not None:
                old.hide()
                old.deleteLater()
        for note in notes:
            self._needs.addWidget(NoteLine(note))
        self._needs.addStretch(1)
        self._needs_area.setVisible(bool(notes))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if not event.spontaneous():
            self._presenter.shown()

    def _on_action(self, key: str) -> None:
        if key == "load":
            self._open_dialog()
        else:
            self._presenter.act(key)

    def _open_dialog(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Results for a certificate"))
            dialog.setModal(False)
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters(
                [
                    self.tr("Calibrations, sessions, runs (*.json *.jsonl *.csv *.txt)"),
                    self.tr("All files (*)"),
                ]
            )
            dialog.fileSelected.connect(self._on_file)
            self._dialog = dialog
        self._dialog.show()

    def _on_file(self, name: str) -> None:
        self._presenter.load(Path(name))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self._dialog, self._notes = None, ()
            # Qt tells the language before the words of states are at hand.
            QTimer.singleShot(0, self._presenter.retranslate)

    def _retranslate(self) -> None:
        names = (
            self.tr("Order"),
            self.tr("Limits"),
            self.tr("Laboratory"),
            self.tr("Issued"),
        )
        for place, name in enumerate(names):
            self.pages.setTabText(place, name)
        self.pages.setAccessibleName(self.tr("Parts of the form"))
