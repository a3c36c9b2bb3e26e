"""The laboratory and its standards: what stays from one certificate to the next."""

from dataclasses import fields, replace

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from core.certificates.laboratory import Laboratory, Standard
from gui.certificate.state import CertificateState
from gui.certificate.text_form_view import TextForm, embolden

_TEXTS = tuple(item.name for item in fields(Laboratory) if item.name != "standards")
_COLUMNS = tuple(item.name for item in fields(Standard))


class LaboratoryForm(QWidget):
    """Who issues, and what is measured with."""

    edited = Signal(object)
    """A `Laboratory`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._laboratory = Laboratory()
        self._dialog: QFileDialog | None = None
        self.texts = TextForm(_TEXTS, ("statement",))
        self.texts.edited.connect(self._on_edited)
        self.logo = QPushButton()
        self.logo.clicked.connect(self._choose_logo)
        self._kept, self._title = QLabel(), QLabel()
        self._kept.setWordWrap(True)
        self._kept.setProperty("muted", True)
        embolden(self._title)
        self.table = QTableWidget(0, len(_COLUMNS))
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setWordWrap(True)
        self.table.verticalHeader().hide()
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setStretchLastSection(True)
        self.table.itemChanged.connect(self._on_edited)
        self.add, self.remove = QPushButton(), QPushButton()
        self.add.clicked.connect(self._on_add)
        self.remove.clicked.connect(self._on_remove)
        self._build()
        self._retranslate()

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        self.table.setMinimumHeight(9 * unit)
        for column, width in enumerate((11, 6, 8, 7, 9)):
            self.table.setColumnWidth(column, width * unit)
        row = QHBoxLayout()
        row.addWidget(self._title, 1)
        row.addWidget(self.add)
        row.addWidget(self.remove)
        column = QVBoxLayout(self)
        column.addWidget(self._kept)
        column.addWidget(self.texts)
        column.addWidget(self.logo, 0, Qt.AlignmentFlag.AlignRight)
        column.addLayout(row)
        column.addWidget(self.table, 1)

    def render(self, state: CertificateState) -> None:
        """Show a state."""
        laboratory = state.laboratory
        if laboratory == self._laboratory:
            return
        self._laboratory = laboratory
        self.texts.show_values({name: getattr(laboratory, name) for name in _TEXTS})
        if self._standards() != laboratory.standards:
            self._show(laboratory.standards)

    def _show(self, standards: tuple[Standard, ...]) -> None:
        blocker = QSignalBlocker(self.table)
        self.table.setRowCount(len(standards))
        for row, standard in enumerate(standards):
            for column, name in enumerate(_COLUMNS):
                self.table.setItem(row, column, QTableWidgetItem(getattr(standard, name)))
        blocker.unblock()

    def _standards(self) -> tuple[Standard, ...]:
        rows: list[Standard] = []
        for row in range(self.table.rowCount()):
            items = [self.table.item(row, column) for column in range(len(_COLUMNS))]
            texts = ["" if item is None else item.text().strip() for item in items]
            rows.append(Standard(**dict(zip(_COLUMNS, texts, strict=True))))
        return tuple(rows)

    def _on_edited(self) -> None:
        # A row that is being begun is no standard yet.
        named = tuple(one for one in self._standards() if one != Standard(""))
        self._laboratory = replace(self._laboratory, **self.texts.values(), standards=named)
        self.edited.emit(self._laboratory)

    def _on_add(self) -> None:
        row = self.table.rowCount()
        self.table.insertRow(row)
        self.table.setCurrentCell(row, 0)
        self.table.setFocus()

    def _on_remove(self) -> None:
        row = self.table.currentRow()
        if row >= 0:
            self.table.removeRow(row)
            self._on_edited()

    def _choose_logo(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.logo.text())
            dialog.setModal(False)
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters([self.tr("Pictures (*.png *.jpg *.jpeg *.svg)")])
            dialog.fileSelected.connect(self._on_logo)
            self._dialog = dialog
        self._dialog.show()

    def _on_logo(self, name: str) -> None:
        self.texts.show_values({**self.texts.values(), "logo": name})
        self._on_edited()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._kept.setText(
            self.tr("Kept in laboratory.json in the folder of sessions, for all certificates.")
        )
        self.texts.set_words(
            {
                "name": self.tr("Laboratory"),
                "address": self.tr("Address"),
                "place": self.tr("Place"),
                "accreditation": self.tr("Accreditation"),
                "logo": self.tr("Logo"),
                "authorised_by": self.tr("Authorised by"),
                "position": self.tr("Position"),
                "number": self.tr("Number"),
                "statement": self.tr("Further text"),
            },
            {
                "place": self.tr("of calibration, if it is another one"),
                "accreditation": self.tr("number and body, if any"),
                "logo": self.tr("picture, PNG, JPEG or SVG"),
                "statement": self.tr("at the end of every certificate"),
            },
        )
        self.texts.fields["number"].setToolTip(
            self.tr("{year} and {n} are replaced; {n:04d} is the number with four digits")
        )
        self.logo.setText(self.tr("Choose logo"))
        self._title.setText(self.tr("Standards"))
        self.add.setText(self.tr("Add"))
        self.remove.setText(self.tr("Remove"))
        self.table.setAccessibleName(self.tr("Standards and their traceability"))
        self.table.setHorizontalHeaderLabels(
            [
                self.tr("Standard"),
                self.tr("Serial no."),
                self.tr("Certificate"),
                self.tr("Valid until"),
                self.tr("Traceable to"),
            ]
        )
