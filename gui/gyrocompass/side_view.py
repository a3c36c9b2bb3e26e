"""What the operator decides about a gyrocompass."""

import math
from dataclasses import replace

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from gui.gyrocompass.state import CompassChoices, CompassState
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.noise_fields import NoiseFields

_NOT_STATED = -91.0
_STEPS = (3, 4, 6, 8, 12)


class CompassSide(DecisionForm):
    """Form of `CompassChoices`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choices = CompassChoices()
        self.channel, self.headings = ChoiceField(), ChoiceField()
        self.headings.addItems([f"{count} × {360 // count}°" for count in _STEPS])
        self.latitude = NumberField(_NOT_STATED, 90.0, 4, "°")
        self.scale = NumberField(-1e9, 1e9, 4)
        self.tilt = NumberField(0.0, 600.0, 3, "′")
        self.average = NumberField(0.1, 1e5, 1, "s")
        self.pause = NumberField(0.0, 1e4, 1, "s")
        self.target = NumberField(0.0, 90.0, 3, "°")
        self.ramp = QCheckBox()
        self.noise = NoiseFields()
        unit = self.fontMetrics().height()
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        numbers = (
            self.latitude,
            self.scale,
            self.tilt,
            self.average,
            self.pause,
            self.target,
        )
        self._form = FieldForm((self.channel, self.headings, *numbers))
        self._form.addRow(self.ramp)
        column.addLayout(self._form)
        column.addWidget(self.noise)
        column.addStretch(1)
        for choice in (self.channel, self.headings):
            choice.setMinimumContentsLength(6)
        self._listen(self.channel, self.headings, *numbers, self.ramp)
        self._retranslate()

    def render(self, state: CompassState) -> None:
        """Show what is decided."""
        with self._showing():
            choices = self._choices = state.choices
            names = [self.channel.itemText(place) for place in range(self.channel.count())]
            if names != list(state.channels):
                self.channel.clear()
                self.channel.addItems(list(state.channels))
            self.channel.setCurrentIndex(self.channel.findText(choices.channel))
            self.channel.setEnabled(bool(state.channels))
            # A run brings its own headings.
            self.headings.setEnabled(not state.channels)
            self.headings.setCurrentIndex(_STEPS.index(choices.headings))
            latitude = choices.latitude_deg
            self.latitude.setValue(_NOT_STATED if math.isnan(latitude) else latitude)
            self.scale.setValue(choices.scale_factor)
            self.tilt.setValue(choices.u_tilt_arcmin)
            self.average.setValue(choices.average_s)
            self.pause.setValue(choices.pause_s)
            self.target.setValue(choices.target_deg)
            self.ramp.setChecked(choices.ramp)
            self.noise.render("gyro", choices.noise, choices.noise_source)

    def _decision(self) -> CompassChoices:
        latitude = self.latitude.value()
        return replace(
            self._choices,
            channel=self.channel.currentText(),
            headings=_STEPS[max(self.headings.currentIndex(), 0)],
            latitude_deg=math.nan if latitude < -90.0 else latitude,
            scale_factor=self.scale.value(),
            u_tilt_arcmin=self.tilt.value(),
            average_s=self.average.value(),
            pause_s=self.pause.value(),
            target_deg=self.target.value(),
            ramp=self.ramp.isChecked(),
        )

    def _retranslate(self) -> None:
        words = (
            (self.tr("Output"), self.tr("Which gyro.")),
            (self.tr("Headings"), self.tr("To plan for; a run that is loaded brings its own.")),
            (self.tr("Latitude"), self.tr("North positive, south negative.")),
            (self.tr("Scale factor"), self.tr("Output for 1 °/s; 0 where the output is a rate.")),
            (self.tr("u(tilt)"), self.tr("Of one reading of the tilt, k = 1.")),
            (self.tr("Average"), self.tr("At each heading.")),
            (self.tr("Turning"), self.tr("Time to turn and settle before each heading.")),
            (self.tr("Wanted u"), self.tr("Standard uncertainty of the heading; 0 for none.")),
        )
        self._form.say(words)
        self.latitude.setSpecialValueText(self.tr("not stated"))
        self.scale.setSpecialValueText("")
        self.ramp.setText(self.tr("The drift changes steadily"))
        self.ramp.setToolTip(self.tr("Estimate its change; needs times and five readings."))
