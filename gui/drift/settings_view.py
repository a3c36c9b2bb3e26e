"""What the operator decides: chamber temperature, alignment, blocks, memory, knots."""

import math
from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QLineEdit, QWidget

from gui.drift.state import ChoiceState, Settings
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import NumberField

_UNKNOWN_C = -274.0
"""Below absolute zero: the field shows that nothing was stated."""


class SettingsView(DecisionForm):
    """Form of `Settings`."""

    ambient_stated = Signal(float)
    """Temperature of the chamber; NaN for none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: ChoiceState | None = None
        self.ambient = NumberField(_UNKNOWN_C, 300.0, 1, "°C")
        self.start = NumberField(0.0, 1e4, 2, "s")
        self.stop = NumberField(0.0, 1e4, 2, "s")
        self.block = NumberField(0.001, 1e4, 3, "s")
        self.horizon = NumberField(0.0, 1e6, 1, "s")
        self.limit = NumberField(2, 1000)
        self.memory = NumberField(0, 65536, 0, "bytes")
        self.knots = NumberField(0, 1000)
        self.rate = NumberField(0.0, 1e6, 3, "Hz")
        self.scale = NumberField(0.0, 1e9, 6)
        self.channel = QLineEdit()
        alignment = (self.start, self.stop, self.block, self.horizon)
        table = (self.limit, self.memory, self.knots)
        output = (self.rate, self.scale)
        form = self._form = FieldForm((self.ambient, *alignment, *table, self.channel, *output))
        unit = self.fontMetrics().height()
        form.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        # From below, so that the rows above keep their numbers.
        for row in (8, 5, 1):
            line = QFrame()
            line.setFrameShape(QFrame.Shape.HLine)
            form.insertRow(row, line)
        self.setLayout(form)
        self._listen(*alignment, *table, *output, self.channel)
        self.ambient.valueChanged.connect(self._on_ambient)
        self._retranslate()

    def render(self, state: ChoiceState) -> None:
        """Show what is decided."""
        if state == self._state:
            return
        self._state = state
        with self._showing():
            settings = state.settings
            stated = math.isfinite(state.ambient_c)
            self.ambient.setEnabled(state.has_file)
            self.ambient.setValue(state.ambient_c if stated else _UNKNOWN_C)
            self.start.setValue(settings.start_s)
            self.stop.setValue(settings.stop_s)
            self.block.setValue(settings.block_s)
            self.horizon.setValue(settings.horizon_s)
            self.limit.setValue(settings.limit)
            self.memory.setValue(settings.memory)
            self.knots.setValue(settings.knots)
            self.channel.setText(settings.channel)
            self.rate.setValue(settings.rate)
            self.scale.setValue(settings.scale_factor)

    def _decision(self) -> Settings | None:
        if self._state is None:
            return None
        return replace(
            self._state.settings,
            start_s=self.start.value(),
            stop_s=self.stop.value(),
            block_s=self.block.value(),
            horizon_s=self.horizon.value(),
            limit=round(self.limit.value()),
            memory=round(self.memory.value()),
            knots=round(self.knots.value()),
            channel=self.channel.text().strip(),
            rate=self.rate.value(),
            scale_factor=self.scale.value(),
        )

    def _on_ambient(self, value: float) -> None:
        if not self._shows:
            self.ambient_stated.emit(value if value > _UNKNOWN_C else math.nan)

    def _retranslate(self) -> None:
        words = (
            (
                self.tr("Chamber"),
                self.tr("Of the chosen record; the same number for all turn-ons of one set."),
            ),
            (
                self.tr("Start from"),
                self.tr("The mean over this time is brought to zero, here and in use."),
            ),
            (self.tr("Start to"), self.tr("The compensation works from here on.")),
            (
                self.tr("Block"),
                self.tr("Means over this time; long against noise, short against a bend."),
            ),
            (self.tr("Horizon"), self.tr("How long the compensation shall work.")),
            (self.tr("Most knots tp"), self.tr("What the microcontroller has room for.")),
            (self.tr("Memory"), self.tr("Of times, temperatures and values, 2 bytes each.")),
            (
                self.tr("Knots"),
                self.tr("By held-out turn-ons: the fewest that leave at most 2 % more."),
            ),
            (self.tr("Output"), self.tr("Name or number of the channel.")),
            (self.tr("Rate"), self.tr("Samples per second, where the file does not tell it.")),
            (self.tr("Scale factor"), self.tr("Output for 1 °/s.")),
        )
        self._form.say(words)
        self.ambient.setSpecialValueText(self.tr("by the chip"))
        self.horizon.setSpecialValueText(self.tr("whole record"))
        self.memory.setSpecialValueText(self.tr("by tp alone"))
        self.knots.setSpecialValueText(self.tr("found"))
        self.rate.setSpecialValueText(self.tr("of the file"))
        self.scale.setSpecialValueText(self.tr("of the file"))
        self.channel.setPlaceholderText(self.tr("likeliest"))
