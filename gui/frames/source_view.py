"""Port, speed, listen, file; and what was heard."""

from pathlib import Path

from PySide6.QtCore import QEvent, QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QWidget,
)

from gui.devices.setup import BAUDS
from gui.frames.source import Source
from gui.frames.state import SourceState
from gui.widgets.toggle import Toggle
from gui.widgets.word_label import WordLabel


class SourceView(QWidget):
    """The row above the bytes."""

    find_requested = Signal()

    def __init__(self, source: Source, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = source
        self._dialog: QFileDialog | None = None
        self._port_label, self._baud_label = QLabel(), QLabel()
        self.port, self.baud = QComboBox(), QComboBox()
        for box, letters in ((self.port, 16), (self.baud, 7)):
            box.setEditable(True)
            box.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
            box.setMinimumContentsLength(letters)
        self.baud.addItems([str(baud) for baud in BAUDS])
        self.listen, self.speed = QPushButton(), QPushButton()
        self.open, self.search = QPushButton(), QPushButton()
        self.hold = Toggle()
        self.heard = WordLabel()
        row = QHBoxLayout(self)
        unit = self.fontMetrics().height()
        row.setContentsMargins(unit, unit // 2, unit, unit // 2)
        boxes = (self._port_label, self.port, self._baud_label, self.baud)
        for widget in (*boxes, self.listen, self.speed, self.open, self.search, self.hold):
            row.addWidget(widget)
        row.addWidget(self.heard, 1)
        self.port.activated.connect(self._on_port_chosen)
        self.baud.activated.connect(self._on_baud)
        for box, slot in ((self.port, self._on_port_typed), (self.baud, self._on_baud)):
            line = box.lineEdit()
            if line is not None:
                line.editingFinished.connect(slot)
        self.listen.clicked.connect(self._on_listen)
        self.speed.clicked.connect(self._on_speed)
        self.open.clicked.connect(self._on_open)
        self.search.clicked.connect(self.find_requested)
        self.hold.toggled.connect(source.hold)
        self._retranslate()
        source.changed.connect(self.render)
        self.render(source.state)

    def render(self, state: SourceState) -> None:
        """Show a state."""
        line = self.port.lineEdit()
        entries = [(port.url, f"{port.url}   {port.text}") for port in state.ports]
        if [self.port.itemData(n) for n in range(self.port.count())] != [url for url, _ in entries]:
            with QSignalBlocker(self.port):
                self.port.clear()
                for url, text in entries:
                    self.port.addItem(text, url)
        if line is not None and not (line.hasFocus() and line.isModified()):
            line.setText(state.url)
            line.setCursorPosition(0)
        if not self.baud.hasFocus():
            self.baud.setCurrentText(str(state.baud))
        self.port.setEnabled(not state.listening)
        for button in (self.listen, self.speed, self.open, self.search):
            button.setEnabled(not state.busy)
        self.listen.setText(self.tr("Stop listening") if state.listening else self.tr("Listen"))
        self.listen.setProperty("primary", not state.listening)
        with QSignalBlocker(self.hold):
            self.hold.setChecked(state.held)
        words = [state.busy, f"{state.file}: {state.heard}" if state.file else state.heard]
        self.heard.setText("   ".join(word for word in words if word))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self.render(self._source.state)

    def _retranslate(self) -> None:
        self._port_label.setText(self.tr("Port"))
        self._baud_label.setText(self.tr("BaudRate"))
        self.port.setAccessibleName(self._port_label.text())
        self.baud.setAccessibleName(self._baud_label.text())
        self.speed.setText(self.tr("Find speed"))
        self.speed.setToolTip(
            self.tr("Listens at each baud rate until the bytes make sense; nothing is sent")
        )
        self.open.setText(self.tr("Raw log…"))
        self.open.setToolTip(self.tr("Take the bytes of a raw log, a recording, or any file"))
        self.search.setText(self.tr("Find layout"))
        self.search.setToolTip(
            self.tr("Looks for frames, checksum and numbers in the latest bytes (F5)")
        )
        self.search.setShortcut("F5")
        self.hold.setText(self.tr("Hold"))
        self.listen.setToolTip(self.tr("Opens the port and only listens; nothing is sent"))

    def _on_listen(self) -> None:
        self._on_port_typed()
        if self._source.state.listening:
            self._source.stop()
        else:
            self._source.listen()

    def _on_speed(self) -> None:
        self._on_port_typed()
        self._source.find_speed()

    def _on_port_chosen(self, index: int) -> None:
        url = self.port.itemData(index)
        line = self.port.lineEdit()
        if line is not None:
            line.setText(url)
        self._source.set_port(url)

    def _on_port_typed(self) -> None:
        line = self.port.lineEdit()
        if line is not None:
            line.setModified(False)
        self._source.set_port(self.port.currentText().partition("   ")[0])

    def _on_baud(self) -> None:
        text = self.baud.currentText().strip()
        if text.isdecimal() and int(text) > 0:
            self._source.set_baud(int(text))

    def _on_open(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Raw bytes"))
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters(
                [self.tr("Raw logs and recordings (*.calrec)"), self.tr("All files (*)")]
            )
            dialog.fileSelected.connect(lambda path: self._source.load(Path(path)))
            self._dialog = dialog
        self._dialog.show()
