"""Device and Port Settings as in CVGCom, and the list of channels."""

from dataclasses import replace

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from gui.live.settings import RATES_HZ, LiveSettings
from gui.live.state import ChannelRow, LiveState
from gui.widgets.fields import ChoiceField, NumberField


class SettingsView(QWidget):
    """The panel at the left."""

    edited = Signal(object)
    """`LiveSettings`."""
    file_named = Signal(str)
    channel_shown = Signal(str, bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = LiveSettings()
        self._rows: tuple[ChannelRow, ...] = ()
        self._rendering = False
        self.serial, self.kind = QLineEdit(), ChoiceField()
        self.profile = NumberField(0, 999)
        self.scale = NumberField(-1e6, 1e6, 6, "V/(°/s)")
        self.sampling = ChoiceField()
        self.text = QCheckBox()
        self.file = QLineEdit()
        self.channels = QListWidget()
        self._head, self._channels_head = QLabel(), QLabel()
        self.port = QLabel()
        self.port.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._labels = {
            name: QLabel() for name in ("port", "serial", "kind", "profile", "scale", "rate")
        }
        self._file_label = QLabel()
        for rate in RATES_HZ:
            self.sampling.addItem(f"{rate} Hz", rate)
        self.kind.addItem("", True)
        self.kind.addItem("", False)
        self._build()
        self._connect()
        self._retranslate()

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        font = self._head.font()
        font.setBold(True)
        self._head.setFont(font)
        self._channels_head.setFont(font)
        form = QFormLayout()
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        fields = (self.port, self.serial, self.kind, self.profile, self.scale, self.sampling)
        for label, field in zip(self._labels.values(), fields, strict=True):
            form.addRow(label, field)
            label.setBuddy(field)
        self.channels.setSelectionMode(QListWidget.SelectionMode.NoSelection)
        self.channels.setMinimumHeight(6 * unit)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(unit // 2)
        column.addWidget(self._head)
        column.addLayout(form)
        column.addWidget(self.text)
        column.addWidget(self._file_label)
        column.addWidget(self.file)
        column.addWidget(self._channels_head)
        column.addWidget(self.channels, 1)

    def _connect(self) -> None:
        self.serial.editingFinished.connect(self._on_edited)
        self.kind.activated.connect(self._on_edited)
        self.profile.valueChanged.connect(self._on_edited)
        self.scale.valueChanged.connect(self._on_edited)
        self.sampling.activated.connect(self._on_edited)
        self.text.toggled.connect(self._on_edited)
        self.file.editingFinished.connect(self._on_file)
        self.channels.itemChanged.connect(self._on_channel)

    def render(self, state: LiveState) -> None:
        """Show a state."""
        self._rendering = True
        self._state = state
        settings = self._settings = state.settings
        if not self.serial.hasFocus():
            self.serial.setText(settings.serial)
        self.port.setText(state.port or self.tr("none: see Properties above"))
        self.port.setToolTip(state.port)
        self.kind.setCurrentIndex(0 if settings.static else 1)
        self.profile.setValue(settings.profile)
        self.scale.setValue(settings.scale_factor)
        self.sampling.setCurrentIndex(self.sampling.findData(settings.sampling_hz))
        self.text.setChecked(settings.text)
        if not (self.file.hasFocus() and self.file.isModified()):
            self.file.setText(state.file)
            self.file.setCursorPosition(0)
        self.file.setToolTip(f"{state.folder}\n{state.file}")
        for field in (self.serial, self.kind, self.profile, self.scale, self.sampling, self.text):
            field.setEnabled(not state.locked)
        self.file.setReadOnly(bool(state.locked))
        self._set_channels(state.channels)
        self._rendering = False

    def _set_channels(self, rows: tuple[ChannelRow, ...]) -> None:
        if rows == self._rows:
            return
        names = [row.name for row in rows]
        if names != [row.name for row in self._rows]:
            self.channels.clear()
            for row in rows:
                item = QListWidgetItem(f"{row.name}, {row.unit}" if row.unit else row.name)
                item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsUserCheckable)
                item.setData(Qt.ItemDataRole.UserRole, row.name)
                item.setCheckState(Qt.CheckState.Checked)
                self.channels.addItem(item)
        self._rows = rows
        for place, row in enumerate(rows):
            checked = Qt.CheckState.Checked if row.shown else Qt.CheckState.Unchecked
            self.channels.item(place).setCheckState(checked)

    def _on_edited(self) -> None:
        if self._rendering:
            return
        self.edited.emit(
            replace(
                self._settings,
                serial=self.serial.text().strip(),
                static=bool(self.kind.currentData()),
                profile=round(self.profile.value()),
                scale_factor=self.scale.value(),
                sampling_hz=int(self.sampling.currentData()),
                text=self.text.isChecked(),
            )
        )

    def _on_file(self) -> None:
        if self.file.isModified():
            self.file.setModified(False)
            self.file_named.emit(self.file.text())

    def _on_channel(self, item: QListWidgetItem) -> None:
        if not self._rendering:
            name = item.data(Qt.ItemDataRole.UserRole)
            self.channel_shown.emit(name, item.checkState() is Qt.CheckState.Checked)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            if self._state is not None:
                self.render(self._state)

    def _retranslate(self) -> None:
        self._head.setText(self.tr("Device and Port Settings"))
        names = {
            "port": self.tr("Port"),
            "serial": self.tr("Device #"),
            "kind": self.tr("Test"),
            "profile": self.tr("Profile #"),
            "scale": self.tr("Scale factor"),
            "rate": self.tr("Sampling frequency"),
        }
        for key, label in self._labels.items():
            label.setText(names[key])
        self.serial.setPlaceholderText(self.tr("as the device calls itself"))
        self.kind.setItemText(0, self.tr("Static"))
        self.kind.setItemText(1, self.tr("Dynamic"))
        self.sampling.setToolTip(
            self.tr("Rows a second of CVGCom's text file; the record keeps every sample")
        )
        self.text.setText(self.tr("Write CVGCom's text file too"))
        self._file_label.setText(self.tr("File name"))
        self.file.setAccessibleName(self.tr("File name"))
        self._channels_head.setText(self.tr("Channels"))
        self.channels.setAccessibleName(self.tr("Channels"))
