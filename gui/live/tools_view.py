"""What concerns the display alone: points, decimation."""

from dataclasses import replace

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QFormLayout, QLabel, QWidget

from gui.live.settings import LiveSettings
from gui.widgets.fields import NumberField


class ToolsView(QWidget):
    """The lower part of the panel."""

    edited = Signal(object)
    """`LiveSettings`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = LiveSettings()
        self.points, self.decimation = NumberField(100, 1e9), NumberField(1, 1e6)
        self._points_label, self._decimation_label = QLabel(), QLabel()
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        for field in (self.points, self.decimation):
            # The largest number of the range would claim the place of the words.
            field.setMinimumWidth(7 * self.fontMetrics().height())
        form.addRow(self._points_label, self.points)
        form.addRow(self._decimation_label, self.decimation)
        self.points.valueChanged.connect(self._on_edited)
        self.decimation.valueChanged.connect(self._on_edited)
        self._retranslate()

    def render(self, settings: LiveSettings) -> None:
        """Show the settings."""
        self._settings = settings
        for field, value in (
            (self.points, settings.points),
            (self.decimation, settings.decimation),
        ):
            field.blockSignals(True)
            field.setValue(value)
            field.blockSignals(False)

    def set_tail(self, seconds: float) -> None:
        """Auto tracking shows so much."""
        self.edited.emit(replace(self._settings, tail_s=seconds))

    def _on_edited(self) -> None:
        points, decimation = round(self.points.value()), round(self.decimation.value())
        self.edited.emit(replace(self._settings, points=points, decimation=decimation))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._points_label.setText(self.tr("Point on chart"))
        self._decimation_label.setText(self.tr("Decimation (table)"))
        self.points.setAccessibleName(self._points_label.text())
        self.decimation.setAccessibleName(self._decimation_label.text())
        self.points.setToolTip(self.tr("Display only: the record is never decimated"))
        self.decimation.setToolTip(self.points.toolTip())
