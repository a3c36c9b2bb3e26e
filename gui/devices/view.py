"""The panel Device Properties, below the device strip."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from core.records.names import NO_NAME
from gui.devices.presenter import MOST, DevicesPresenter
from gui.devices.setup import BAUDS, DeviceSetup
from gui.devices.state import PropertiesState
from gui.languages.anchors import beside
from gui.languages.shown import shown
from gui.widgets.word_label import WordLabel


class DevicesView(QWidget):
    """Number of Devices, a row for each, Scan and OK."""

    def __init__(self, presenter: DevicesPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._rows: list[_Row] = []
        self._title = QLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self._count_label = QLabel()
        self._count = QSpinBox()
        self._count.setRange(1, MOST)
        self._count.valueChanged.connect(presenter.set_count)
        self._headings = [QLabel() for _ in range(4)]
        self._grid = QGridLayout()
        self._report = WordLabel()
        self._report.setWordWrap(True)
        self._question = WordLabel()
        self._question.setWordWrap(True)
        self._ask, self._decline = QPushButton(), QPushButton()
        self._ask.clicked.connect(presenter.ask)
        self._decline.clicked.connect(presenter.decline)
        self._progress = QProgressBar()
        self._progress.setRange(0, 1000)
        self._scan, self._refresh = QPushButton(), QPushButton()
        self._cancel, self._ok = QPushButton(), QPushButton()
        self._ok.setProperty("primary", True)
        self._scan.clicked.connect(presenter.scan)
        self._refresh.clicked.connect(presenter.refresh)
        self._cancel.clicked.connect(presenter.cancel)
        self._ok.clicked.connect(presenter.ok)
        self._build()
        self._retranslate()
        presenter.changed.connect(self.render)
        presenter.accepted.connect(self.hide)
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        head = QHBoxLayout()
        head.addWidget(self._title)
        head.addSpacing(2 * unit)
        head.addWidget(self._count_label)
        head.addWidget(self._count)
        head.addStretch(1)
        self._grid.setHorizontalSpacing(unit)
        self._grid.setVerticalSpacing(unit // 3)
        for column, label in enumerate(self._headings):
            label.setProperty("muted", True)
            self._grid.addWidget(label, 0, column)
        self._grid.setColumnMinimumWidth(0, 9 * unit)
        self._grid.setColumnStretch(4, 1)
        asking = QHBoxLayout()
        asking.addWidget(self._question, 1)
        asking.addWidget(self._ask)
        asking.addWidget(self._decline)
        buttons = QHBoxLayout()
        buttons.addWidget(self._scan)
        buttons.addWidget(self._cancel)
        buttons.addWidget(self._refresh)
        buttons.addWidget(self._progress, 1)
        buttons.addStretch(1)
        buttons.addWidget(self._ok)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit, unit // 2, unit, unit)
        column.setSpacing(unit // 2)
        for part in (head, self._grid):
            column.addLayout(part)
        column.addWidget(self._report)
        column.addLayout(asking)
        column.addLayout(buttons)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def open(self) -> None:
        """Show the panel with a fresh list of ports."""
        self.show()
        self._presenter.refresh()
        self._rows[0].port.setFocus(Qt.FocusReason.OtherFocusReason)

    def render(self, state: PropertiesState) -> None:
        """Show a state."""
        with QSignalBlocker(self._count):
            self._count.setValue(len(state.rows))
        while len(self._rows) < len(state.rows):
            self._rows.append(_Row(self._presenter, len(self._rows), self._grid))
        for number, row in enumerate(self._rows):
            row.set_visible(number < len(state.rows))
        for row, setup in zip(self._rows, state.rows, strict=False):
            row.render(setup, state)
        busy = bool(state.busy)
        self._report.setText(state.busy or state.report)
        self._report.setVisible(bool(state.busy or state.report))
        self._question.setText(state.question)
        for widget in (self._question, self._ask, self._decline):
            widget.setVisible(bool(state.question))
        self._progress.setVisible(busy)
        self._progress.setValue(round(1000 * state.progress))
        self._scan.setVisible(not busy)
        self._refresh.setVisible(not busy)
        self._cancel.setVisible(busy)
        self._count.setEnabled(not busy)
        self._ok.setEnabled(not state.why_not_ok)
        self._ok.setToolTip(shown(state.why_not_ok))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.hide()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._presenter.ok()
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            for row in self._rows:
                row.say_names()
            self.render(self._presenter.state)

    def _retranslate(self) -> None:
        self._title.setText(self.tr("Device Properties"))
        self._count_label.setText(self.tr("Number of Devices"))
        self._count.setAccessibleName(self._count_label.text())
        headings = (
            self.tr("Device name"),
            self.tr("Port Name"),
            self.tr("BaudRate"),
            self.tr("Device file"),
        )
        for label, text in zip(self._headings, headings, strict=True):
            label.setText(text)
        self._scan.setText(self.tr("Scan"))
        tip = self.tr("Listens at every baud rate; nothing is sent")
        self._scan.setToolTip(beside(self._scan.text(), tip))
        self._refresh.setText(self.tr("Refresh ports"))
        self._cancel.setText(self.tr("Stop scanning"))
        self._ok.setText(self.tr("OK"))
        self._ask.setText(self.tr("Ask for names"))
        self._decline.setText(self.tr("Do not ask"))


class _Row:
    """Widgets of one device in the grid."""

    def __init__(self, presenter: DevicesPresenter, number: int, grid: QGridLayout) -> None:
        self._presenter = presenter
        self._number = number
        self.name = WordLabel()
        self.port, self.baud, self.profile = QComboBox(), QComboBox(), QComboBox()
        self.port.setEditable(True)
        self.baud.setEditable(True)
        self.port.setMinimumContentsLength(38)
        self.baud.setMinimumContentsLength(8)
        self.profile.setMinimumContentsLength(28)
        for box in (self.port, self.baud):
            box.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.baud.addItems([str(baud) for baud in BAUDS])
        self.port.activated.connect(self._on_port_chosen)
        self.baud.activated.connect(self._on_baud)
        self.profile.activated.connect(self._on_profile)
        for box, slot in ((self.port, self._on_port_typed), (self.baud, self._on_baud)):
            line = box.lineEdit()
            if line is not None:
                line.editingFinished.connect(slot)
        for column, widget in enumerate((self.name, self.port, self.baud, self.profile)):
            grid.addWidget(widget, number + 1, column)
        self.say_names()

    def say_names(self) -> None:
        """Name the fields for screen readers, in the language of the window."""
        for widget, name in (
            (self.port, "Port Name"),
            (self.baud, "BaudRate"),
            (self.profile, "Device file"),
        ):
            widget.setAccessibleName(f"{shown(name)} {self._number + 1}")

    def set_visible(self, visible: bool) -> None:
        for widget in (self.name, self.port, self.baud, self.profile):
            widget.setVisible(visible)

    def render(self, setup: DeviceSetup, state: PropertiesState) -> None:
        self.name.setText(setup.name)
        self.name.setEnabled(setup.name != NO_NAME)
        line = self.port.lineEdit()
        typed = line.text() if line is not None and line.isModified() else None
        _fill(self.port, [(port.url, f"{port.url}   {shown(port.text)}") for port in state.ports])
        self.port.setCurrentIndex(self.port.findData(setup.url))
        if line is not None:
            line.setText(setup.url if typed is None else typed)
            line.setModified(typed is not None)
            if not line.hasFocus():
                line.setCursorPosition(0)
        self.baud.setCurrentText(str(setup.baud))
        _fill(self.profile, [("", shown("found by Scan")), *state.profiles])
        self.profile.setCurrentIndex(max(0, self.profile.findData(setup.profile_id)))
        for box in (self.port, self.baud, self.profile):
            box.setEnabled(not state.busy)

    def _on_port_chosen(self, index: int) -> None:
        url = self.port.itemData(index)
        line = self.port.lineEdit()
        if line is not None:
            line.setText(url)
        self._presenter.set_port(self._number, url)

    def _on_port_typed(self) -> None:
        line = self.port.lineEdit()
        if line is not None:
            line.setModified(False)
        self._presenter.set_port(self._number, self.port.currentText().partition("   ")[0])

    def _on_baud(self) -> None:
        text = self.baud.currentText().strip()
        if text.isdecimal() and int(text) > 0:
            self._presenter.set_baud(self._number, int(text))

    def _on_profile(self, index: int) -> None:
        self._presenter.set_profile(self._number, self.profile.itemData(index))


def _fill(box: QComboBox, entries: list[tuple[str, str]]) -> None:
    if [(box.itemData(i), box.itemText(i)) for i in range(box.count())] != entries:
        with QSignalBlocker(box):
            box.clear()
            for data, text in entries:
                box.addItem(text, data)
