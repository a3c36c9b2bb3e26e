"""N, B and K of a sensor in the units of its data sheet, or taken from a record."""

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QFileDialog, QLabel, QPushButton, QVBoxLayout, QWidget

from core.units import DPH_PER_DPS
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import NumberField

_ROOT_H = 60.0
"""Seconds under the root in one hour under the root."""
GYRO_FACTORS = (_ROOT_H, DPH_PER_DPS, DPH_PER_DPS * _ROOT_H)
"""deg/sqrt(h), deg/h, deg/h/sqrt(h) in deg/sqrt(s), deg/s, deg/s/sqrt(s)."""
_GYRO_UNITS = ("°/√h", "°/h", "°/h/√h")
ACCELEROMETER_FACTORS = (1e3, 1e3, 1e3)
_ACCELEROMETER_UNITS = ("mm/s²·√s", "mm/s²", "mm/s²/√s")


class NoiseFields(QWidget):
    """Three numbers and a button.

    The coefficients are told in deg/s or m/s^2 with seconds, as the core counts them.
    """

    decided = Signal(tuple)
    """N, B, K."""
    record_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rendering = False
        self._shown: tuple[str, tuple[float, float, float]] | None = None
        self._factors = GYRO_FACTORS
        self._dialog: QFileDialog | None = None
        self.fields = tuple(NumberField(0.0, 1e6, 5) for _ in range(3))
        self.button, self.source = QPushButton(), QLabel()
        self.source.setWordWrap(True)
        self._form = FieldForm(self.fields)
        for field in self.fields:
            field.setMinimumWidth(10 * self.fontMetrics().height())
            field.valueChanged.connect(self._on_edited)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(self._form)
        column.addWidget(self.button)
        column.addWidget(self.source)
        self.button.clicked.connect(self._open_dialog)
        self._retranslate()

    def render(self, kind: str, noise: tuple[float, float, float], source: str) -> None:
        """Show coefficients of a kind of sensor, and where they come from."""
        self.source.setText(source)
        self.source.setVisible(bool(source))
        if self._shown == (kind, noise):
            return
        self._shown = kind, noise
        self._rendering = True
        gyro = kind == "gyro"
        self._factors = GYRO_FACTORS if gyro else ACCELEROMETER_FACTORS
        units = _GYRO_UNITS if gyro else _ACCELEROMETER_UNITS
        rows = zip(self.fields, noise, self._factors, units, strict=True)
        for field, value, factor, unit in rows:
            field.setSuffix(f" {unit}")
            field.setValue(value * factor)
        self._rendering = False

    def _on_edited(self) -> None:
        if self._rendering or self._shown is None:
            return
        # A field that was not touched keeps all its digits.
        old = self._shown[1]
        rows = zip(self.fields, old, self._factors, strict=True)
        noise = tuple(
            before if abs(field.value() - before * factor) < 0.51e-5 else field.value() / factor
            for field, before, factor in rows
        )
        self.decided.emit(noise)

    def _open_dialog(self) -> None:
        """The file dialog; it blocks nothing."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.button.text())
            dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
            dialog.setNameFilters(
                [self.tr("Records (*.calrec *.txt *.csv *.dat)"), self.tr("All files (*)")]
            )
            dialog.fileSelected.connect(self.record_chosen)
            self._dialog = dialog
        self._dialog.show()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        words = (
            (self.tr("White noise N"), self.tr("Two-sided density, as the Allan tab tells it.")),
            (self.tr("Flicker B"), self.tr("Floor of the Allan curve over 0.664.")),
            (self.tr("Walk K"), self.tr("Random walk of the rate or of the acceleration.")),
        )
        self._form.say(words)
        self.button.setText(self.tr("Noise from a record …"))
        self.button.setToolTip(self.tr("Analyse a record of the sensor at rest, as the Allan tab"))
