"""What the operator decides: orders, reference, g, outputs of a record."""

import math
from dataclasses import replace

from PySide6.QtWidgets import QLineEdit, QWidget

from gui.thermal.state import FOUND, Settings
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import NumberField

_HIGHEST = 5
_UNKNOWN_C = -274.0
"""Below absolute zero: the field shows that nothing was stated."""


class SettingsView(DecisionForm):
    """Form of `Settings`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = Settings()
        self.bias_order = NumberField(FOUND, _HIGHEST)
        self.scale_order = NumberField(FOUND, _HIGHEST)
        self.reference = NumberField(_UNKNOWN_C, 300.0, 1, "°C")
        self.gravity = NumberField(9.7, 9.9, 5, "m/s²")
        self.outputs = QLineEdit()
        numbers = (self.bias_order, self.scale_order, self.reference, self.gravity)
        form = self._form = FieldForm((*numbers, self.outputs))
        unit = self.fontMetrics().height()
        form.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        self.setLayout(form)
        self._listen(*numbers, self.outputs)
        self._retranslate()

    def render(self, settings: Settings) -> None:
        """Show what is decided."""
        self._state = settings
        with self._showing():
            self.bias_order.setValue(settings.bias_order)
            self.scale_order.setValue(settings.scale_order)
            stated = math.isfinite(settings.reference_c)
            self.reference.setValue(settings.reference_c if stated else _UNKNOWN_C)
            self.gravity.setValue(settings.g_mps2)
            self.outputs.setText(settings.outputs)

    def _decision(self) -> Settings:
        reference = self.reference.value()
        return replace(
            self._state,
            bias_order=round(self.bias_order.value()),
            scale_order=round(self.scale_order.value()),
            reference_c=reference if reference > _UNKNOWN_C else self._unknown(),
            g_mps2=self.gravity.value(),
            outputs=self.outputs.text().strip(),
        )

    def _unknown(self) -> float:
        """The same NaN as before, which alone is equal to itself in a comparison of settings."""
        before = self._state.reference_c
        return before if math.isnan(before) else math.nan

    def _retranslate(self) -> None:
        words = (
            (
                self.tr("Order of U0"),
                self.tr(
                    "Of the bias; of the outputs of a standing unit. Found: by temperatures"
                    " left out."
                ),
            ),
            (self.tr("Order of k"), self.tr("Of the scale factor.")),
            (self.tr("T0"), self.tr("The constant terms hold at this temperature.")),
            (self.tr("g"), self.tr("Taken where the files state none.")),
            (self.tr("Outputs"), self.tr("Of a record: names, between commas.")),
        )
        self._form.say(words)
        self.bias_order.setSpecialValueText(self.tr("found"))
        self.scale_order.setSpecialValueText(self.tr("found"))
        self.reference.setSpecialValueText(self.tr("the first"))
        self.outputs.setPlaceholderText(self.tr("all rates"))
