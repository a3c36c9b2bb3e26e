"""The sensor and the rig at hand."""

from dataclasses import replace

from PySide6.QtWidgets import QCheckBox, QLabel, QVBoxLayout, QWidget

from core.procedures.prediction.bench import TOOLS
from gui.advisor.state import AdvisorChoices, AdvisorState
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.noise_fields import NoiseFields

_KINDS = ("accelerometer", "gyro")
_AXES = ("x", "y", "z")


class AdvisorSide(DecisionForm):
    """Form of `AdvisorChoices`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choices = AdvisorChoices()
        self.kind, self.axis = ChoiceField(), ChoiceField()
        self.kind.addItems([""] * len(_KINDS))
        self.axis.addItems([axis.upper() for axis in _AXES])
        self.noise = NoiseFields()
        self.tools = {name: QCheckBox() for name in TOOLS}
        self.accumulation = NumberField(0.0, 1e5, 1, "s")
        self.pause = NumberField(0.0, 1e4, 1, "s")
        self.g = NumberField(9.7, 9.9, 5, "m/s²")
        self.u_g = NumberField(0.0, 0.1, 5, "m/s²")
        self.head_u = NumberField(0.0, 3600.0, 1, "″")
        self.rate_u = NumberField(0.0, 1e5, 1, "ppm")
        self.latitude = NumberField(-90.0, 90.0, 3, "°")
        self._numbers = (
            self.accumulation,
            self.pause,
            self.g,
            self.u_g,
            self.head_u,
            self.rate_u,
            self.latitude,
        )
        unit = self.fontMetrics().height()
        column = QVBoxLayout(self)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 3)
        self._heads = [QLabel() for _ in range(2)]
        for head in self._heads:
            font = head.font()
            font.setBold(True)
            head.setFont(font)
        self._sensor, self._rig = FieldForm((self.kind, self.axis)), FieldForm(self._numbers)
        column.addWidget(self._heads[0])
        column.addLayout(self._sensor)
        column.addWidget(self.noise)
        column.addWidget(self._heads[1])
        for tool in self.tools.values():
            column.addWidget(tool)
        column.addLayout(self._rig)
        column.addStretch(1)
        self._listen(self.kind, self.axis, *self.tools.values(), *self._numbers)
        with self._showing():
            self._retranslate()

    def render(self, state: AdvisorState) -> None:
        """Show what is decided."""
        with self._showing():
            choices = self._choices = state.choices
            self.kind.setCurrentIndex(_KINDS.index(choices.kind))
            self.axis.setCurrentIndex(_AXES.index(choices.axis))
            self.noise.render(choices.kind, choices.noise, choices.noise_source)
            for name, tool in self.tools.items():
                tool.setChecked(name in choices.tools)
            values = (
                choices.accumulation_s,
                choices.pause_s,
                choices.g_mps2,
                choices.u_g_mps2,
                choices.head_u_arcsec,
                choices.rate_u_ppm,
                choices.latitude_deg,
            )
            for number, value in zip(self._numbers, values, strict=True):
                number.setValue(value)

    def _decision(self) -> AdvisorChoices:
        return replace(
            self._choices,
            kind=_KINDS[max(self.kind.currentIndex(), 0)],
            axis=_AXES[max(self.axis.currentIndex(), 0)],
            tools=frozenset(name for name, tool in self.tools.items() if tool.isChecked()),
            accumulation_s=self.accumulation.value(),
            pause_s=self.pause.value(),
            g_mps2=self.g.value(),
            u_g_mps2=self.u_g.value(),
            head_u_arcsec=self.head_u.value(),
            rate_u_ppm=self.rate_u.value(),
            latitude_deg=self.latitude.value(),
        )

    def _retranslate(self) -> None:
        for head, text in zip(self._heads, (self.tr("Sensor"), self.tr("Rig")), strict=True):
            head.setText(text)
        kinds = (self.tr("Accelerometer"), self.tr("Gyro"))
        for place, text in enumerate(kinds):
            self.kind.setItemText(place, text)
        tools = {
            "dividing head": self.tr("Dividing head"),
            "rate table": self.tr("Rate table"),
            "climate chamber": self.tr("Climate chamber"),
            "level base": self.tr("Level base"),
        }
        for name, tool in self.tools.items():
            tool.setText(tools[name])
        sensor = (
            (self.tr("Kind"), ""),
            (self.tr("Axis"), self.tr("Case axis along which it looks.")),
        )
        rig = (
            (self.tr("Accumulate"), self.tr("At each position; 0 takes the time of the plan.")),
            (self.tr("Turning"), self.tr("Time that a change of the position takes.")),
            (self.tr("Local g"), ""),
            (self.tr("u(g)"), self.tr("Standard uncertainty, k = 1.")),
            (self.tr("u(head)"), self.tr("Of one setting of the dividing head.")),
            (self.tr("u(table)"), self.tr("Of one setting of the rate table.")),
            (self.tr("Latitude"), self.tr("North positive, south negative.")),
        )
        self._sensor.say(sensor)
        self._rig.say(rig)
        self.accumulation.setSpecialValueText(self.tr("as the plan"))
