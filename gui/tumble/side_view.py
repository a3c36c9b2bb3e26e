"""What the operator decides about a tumble."""

from PySide6.QtWidgets import QCheckBox, QWidget

from gui.tumble.state import TumbleChoices, TumbleState
from gui.widgets.decision_form import DecisionForm
from gui.widgets.field_form import FieldForm
from gui.widgets.fields import ChoiceField, NumberField


class TumbleSide(DecisionForm):
    """Form of `TumbleChoices`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choices = TumbleChoices()
        self.channel, self.harmonics = ChoiceField(), ChoiceField()
        self.harmonics.addItems(["2", "3"])
        self.g = NumberField(0.1, 20.0, 5, "m/s²")
        self.u_g = NumberField(0.0, 0.1, 5, "m/s²")
        self.head_u = NumberField(0.0, 3600.0, 1, "″")
        self.drift, self.projection = QCheckBox(), QCheckBox()
        numbers = (self.g, self.u_g, self.head_u)
        form = self._form = FieldForm((self.channel, self.harmonics, *numbers))
        unit = self.fontMetrics().height()
        form.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        form.addRow(self.drift)
        form.addRow(self.projection)
        self.setLayout(form)
        self._listen(self.channel, self.harmonics, *numbers, self.drift, self.projection)
        self._retranslate()

    def render(self, state: TumbleState) -> None:
        """Show what is decided."""
        with self._showing():
            choices = self._choices = state.choices
            names = [self.channel.itemText(place) for place in range(self.channel.count())]
            if names != list(state.channels):
                self.channel.clear()
                self.channel.addItems(list(state.channels))
            self.channel.setCurrentIndex(self.channel.findText(choices.channel))
            self.channel.setEnabled(bool(state.channels))
            self.harmonics.setCurrentIndex(choices.harmonics - 2)
            self.g.setValue(choices.g_mps2)
            self.u_g.setValue(choices.u_g_mps2)
            self.head_u.setValue(choices.head_u_arcsec)
            self.drift.setChecked(choices.remove_drift)
            self.projection.setChecked(choices.gravity_projection)

    def _decision(self) -> TumbleChoices:
        return TumbleChoices(
            channel=self.channel.currentText(),
            harmonics=self.harmonics.currentIndex() + 2,
            remove_drift=self.drift.isChecked(),
            gravity_projection=self.projection.isChecked(),
            g_mps2=self.g.value(),
            u_g_mps2=self.u_g.value(),
            head_u_arcsec=self.head_u.value(),
        )

    def _retranslate(self) -> None:
        words = (
            (self.tr("Output"), self.tr("Which accelerometer; its axis must turn with the head.")),
            (self.tr("Harmonics"), self.tr("The third shows a nonlinearity of third order.")),
            (self.tr("Local g"), self.tr("1 where the readings are to be told per g.")),
            (self.tr("u(g)"), self.tr("Standard uncertainty, k = 1.")),
            (self.tr("u(head)"), self.tr("Standard uncertainty of one setting of the head.")),
        )
        self._form.say(words)
        self.drift.setText(self.tr("Fit a steady drift"))
        self.drift.setToolTip(self.tr("Over the run, along with the series."))
        self.projection.setText(self.tr("Signs of the paper"))
        self.projection.setToolTip(
            self.tr("k_x and k_y for the projection of gravity instead of specific force.")
        )
