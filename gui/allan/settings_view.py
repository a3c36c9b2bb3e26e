"""What the operator decides about the chosen record: channel, rate, scale, unit, regression."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QWidget

from core.records.noise_study import StudyRequest
from gui.allan.state import ChoiceState
from gui.allan.texts import DEVIATIONS
from gui.languages.shown import shown, shown_number
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import ChoiceField, NumberField

_UNITS = ("", "deg/s", "m/s^2", "code", "V")


class SettingsView(DecisionForm):
    """Form of a `StudyRequest`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state: ChoiceState | None = None
        self.channel, self.unit = ChoiceField(), ChoiceField()
        self.rate = NumberField(0.0, 1e6, 3, "Hz")
        self.scale = NumberField(0.0, 1e9, 6)
        self.bandwidth = NumberField(0.0, 1e5, 2, "Hz")
        self.increments = QCheckBox()
        self.regressor, self.order = ChoiceField(), ChoiceField()
        self.order.addItems(["1", "2", "3"])
        self.beside = ChoiceField()
        for key in ("", *DEVIATIONS):
            self.beside.addItem("", key)
        self.unit.addItems(_UNITS)
        fields = (
            self.channel,
            self.rate,
            self.scale,
            self.unit,
            self.bandwidth,
            self.regressor,
            self.order,
            self.beside,
        )
        form = self._form = FieldForm(fields)
        unit = self.fontMetrics().height()
        form.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        form.addRow(self.increments)
        self.setLayout(form)
        for field in (self.channel, self.unit, self.regressor, self.order, self.beside):
            field.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
            field.setMinimumContentsLength(6)
        self._listen(*fields, self.increments)
        self._retranslate()
        self.render(None)

    def render(self, state: ChoiceState | None) -> None:
        """Show what is decided; nothing can be changed while there is no record."""
        self.setEnabled(state is not None)
        if state is None or state == self._state:
            return
        self._state = state
        with self._showing():
            request = state.request
            _fill(self.channel, state.channels, state.channel)
            others = [name for name in state.channels if name != state.channel]
            _fill(self.regressor, [self.tr("none"), *others], "".join(request.regressors[:1]))
            self.rate.setValue(request.rate)
            self.rate.setSpecialValueText(
                f"{state.rate:.6g} Hz" if state.rate else self.tr("state it")
            )
            self.scale.setValue(request.scale_factor)
            self.scale.setSpecialValueText(shown_number(f"{state.factor:.6g}"))
            self.bandwidth.setValue(request.bandwidth)
            _fill(self.unit, _UNITS, request.unit)
            self.unit.setItemText(0, state.unit or shown("code"))
            self.order.setCurrentIndex(request.order - 1)
            self.increments.setChecked(request.increments)
            self.beside.setCurrentIndex(self.beside.findData(request.beside))
            of_records = (self.rate, self.bandwidth, self.regressor, self.order, self.increments)
            for field in (*of_records, self.beside):
                field.setEnabled(not state.live)

    def _decision(self) -> StudyRequest | None:
        if self._state is None:
            return None
        before = self._state.request
        channel = self.channel.currentText()
        regressed = self.regressor.currentIndex() > 0
        unit = _UNITS[max(self.unit.currentIndex(), 0)]
        same = channel == self._state.channel
        request: StudyRequest = replace(
            before,
            channel=before.channel if same else channel,
            rate=self.rate.value(),
            scale_factor=self.scale.value(),
            unit=unit,
            bandwidth=self.bandwidth.value(),
            increments=self.increments.isChecked(),
            regressors=(self.regressor.currentText(),) if regressed else (),
            order=self.order.currentIndex() + 1,
            beside=str(self.beside.currentData()),
        )
        if channel in request.regressors:
            request = replace(request, regressors=())
        return request

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            state, self._state = self._state, None
            self.render(state)

    def _retranslate(self) -> None:
        words = (
            (self.tr("Channel"), ""),
            (self.tr("Rate"), self.tr("Samples per second; 0 takes that of the file.")),
            (
                self.tr("Scale factor"),
                self.tr("Output for 1 °/s (1 m/s²); the samples are divided by it."),
            ),
            (self.tr("Unit"), self.tr("Of the samples, after the scale factor.")),
            (
                self.tr("Bandwidth"),
                self.tr("Of the sensor. A filter within the band falsifies N and B most."),
            ),
            (
                self.tr("Regress on"),
                self.tr("Show the curve before and after taking off what this channel explains."),
            ),
            (self.tr("Order"), self.tr("Highest power of that channel.")),
            (
                self.tr("Beside"),
                self.tr("Another deviation beside Allan's; needs the package AllanTools."),
            ),
        )
        self._form.say(words)
        names = (self.tr("nothing"), self.tr("Hadamard"), self.tr("modified"), self.tr("total"))
        for place, name in enumerate(names):
            self.beside.setItemText(place, name)
        self.bandwidth.setSpecialValueText(self.tr("found"))
        self.increments.setText(self.tr("Angle increments (fit Q)"))
        self.increments.setToolTip(
            self.tr("The device sends increments of angle; a rate output has no quantisation Q.")
        )


def _fill(field: QComboBox, names: Sequence[str], chosen: str) -> None:
    """Offer these names; what is not among them chooses the first."""
    if [field.itemText(place) for place in range(field.count())] != list(names):
        field.clear()
        field.addItems(list(names))
    field.setCurrentIndex(max(field.findText(chosen, Qt.MatchFlag.MatchExactly), 0))
