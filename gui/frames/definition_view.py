"""What the board is: header, length, checksum, the readings of a length byte, name, saving."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from core.errors import Note, Severity
from drivers.profile_sections import KINDS
from gui.frames.presenter import FramesPresenter
from gui.frames.state import FramesState, Reading
from gui.languages.shown import shown
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.note_line import NoteLine
from gui.widgets.word_label import WordLabel


class DefinitionView(QWidget):
    """The right-hand side above the numbers."""

    def __init__(self, presenter: FramesPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._note: NoteLine | None = None
        self._readings: tuple[Reading, ...] = ()
        self._sync_label, self._length_label, self._check_label = QLabel(), QLabel(), QLabel()
        self._name_label, self._kind_label = QLabel(), QLabel()
        self.sync = QLineEdit()
        self.length = NumberField(2, 4096, 0, "")
        self.check = ChoiceField()
        self.check.setSizeAdjustPolicy(
            ChoiceField.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.check.setMinimumContentsLength(20)
        self.name, self.kind = QLineEdit(), ChoiceField()
        self.kind.addItems(KINDS)
        self.save, self.use = QPushButton(), QPushButton()
        self.use.setProperty("primary", True)
        self.saved = WordLabel()
        self.saved.setWordWrap(True)
        self.saved.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.verdict = QVBoxLayout()
        self.reading_box = QVBoxLayout()
        self._group = QButtonGroup(self)
        self._build()
        self._retranslate()
        self.sync.editingFinished.connect(self._on_frame)
        self.length.valueChanged.connect(self._on_frame)
        self.check.activated.connect(presenter.choose_check)
        self._group.idClicked.connect(presenter.choose_reading)
        self.name.textEdited.connect(self._on_name)
        self.kind.activated.connect(self._on_name)
        self.save.clicked.connect(presenter.save)
        self.use.clicked.connect(presenter.use)
        presenter.changed.connect(self.render)
        self.render(presenter.state)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        form = QFormLayout()
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(unit // 3)
        frame = QHBoxLayout()
        frame.setSpacing(unit // 2)
        frame.addWidget(self.sync, 1)
        frame.addWidget(self._length_label)
        frame.addWidget(self.length)
        form.addRow(self._sync_label, frame)
        form.addRow(self._check_label, self.check)
        naming = QHBoxLayout()
        naming.setSpacing(unit // 2)
        naming.addWidget(self.name, 1)
        naming.addWidget(self._kind_label)
        naming.addWidget(self.kind)
        form.addRow(self._name_label, naming)
        buttons = QHBoxLayout()
        buttons.setSpacing(unit // 2)
        buttons.addWidget(self.saved, 1)
        buttons.addWidget(self.save)
        buttons.addWidget(self.use)
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 2)
        column.addLayout(self.verdict)
        column.addLayout(form)
        column.addLayout(self.reading_box)
        column.addLayout(buttons)

    def render(self, state: FramesState) -> None:
        """Show a state."""
        self._show_verdict(state)
        for widget in (self._sync_label, self.sync, self._length_label, self.length):
            widget.setVisible(state.binary)
        for widget in (self._check_label, self.check):
            widget.setVisible(state.binary)
        if not self.sync.isModified():
            self.sync.setText(state.sync)
        with QSignalBlocker(self.length):
            if state.length:
                self.length.setValue(state.length)
        checks = [shown(one) for one in state.checks]
        with QSignalBlocker(self.check):
            if [self.check.itemText(n) for n in range(self.check.count())] != checks:
                self.check.clear()
                self.check.addItems(checks)
            self.check.setCurrentIndex(state.check)
        self.check.setToolTip(self.check.currentText())
        self._show_readings(state)
        if not self.name.hasFocus():
            self.name.setText(state.name)
        self.kind.setCurrentText(state.kind)
        self.save.setEnabled(not state.doubt)
        self.use.setEnabled(not state.doubt)
        for button in (self.save, self.use):
            button.setToolTip(shown(state.doubt))
        self.saved.setText(f"Saved: {state.saved}" if state.saved else state.doubt)

    def _show_verdict(self, state: FramesState) -> None:
        text = shown(state.verdict)
        if self._note is not None and self._note.toolTip() == text:
            return
        if self._note is not None:
            self.verdict.removeWidget(self._note)
            self._note.deleteLater()
            self._note = None
        if text:
            severity = Severity.INFO if state.sure else Severity.WARNING
            self._note = NoteLine(Note(severity, "layout", text))
            self._note.setToolTip(text)
            self.verdict.addWidget(self._note)

    def _show_readings(self, state: FramesState) -> None:
        if state.readings != self._readings:
            self._readings = state.readings
            for button in self._group.buttons():
                self._group.removeButton(button)
                self.reading_box.removeWidget(button)
                button.deleteLater()
            for number, reading in enumerate(state.readings):
                button = QRadioButton(shown(reading.text))
                button.setToolTip(
                    self.tr("Both meanings are shown; the stream says which one fits.")
                )
                self._group.addButton(button, number)
                self.reading_box.addWidget(button)
        for button in self._group.buttons():
            reading = self._readings[self._group.id(button)]
            button.setChecked(reading.length == state.length)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self.render(self._presenter.state)

    def _retranslate(self) -> None:
        self._sync_label.setText(self.tr("Header"))
        self._length_label.setText(self.tr("Length"))
        self._check_label.setText(self.tr("Checksum"))
        self._name_label.setText(self.tr("Device name"))
        self._kind_label.setText(self.tr("Kind"))
        self.length.setSuffix(self.tr(" bytes"))
        self.save.setText(self.tr("Save device file"))
        self.use.setText(self.tr("Save and connect"))
        self.name.setPlaceholderText(self.tr("what the operators call the board"))
        pairs = (
            (self.sync, self._sync_label),
            (self.length, self._length_label),
            (self.check, self._check_label),
            (self.name, self._name_label),
            (self.kind, self._kind_label),
        )
        for widget, label in pairs:
            widget.setAccessibleName(label.text())
            label.setBuddy(widget)

    def _on_frame(self) -> None:
        self.sync.setModified(False)
        state = self._presenter.state
        text, length = self.sync.text().strip(), round(self.length.value())
        if state.binary and (text != state.sync or length != state.length):
            self._presenter.set_frame(text, length)

    def _on_name(self) -> None:
        self._presenter.describe(self.name.text(), self.kind.currentText())
