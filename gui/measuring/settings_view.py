"""The operator's settings: the fields that every test has, and the means to add others."""

from collections.abc import Callable
from dataclasses import replace
from typing import Generic

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gui.languages.shown import shown
from gui.measuring.guide import S
from gui.measuring.state import MeasuringState
from gui.widgets.fields import ChoiceField, NumberField


class SettingsForm(Generic[S], QWidget):
    """Times, local g, temperatures; a tab derives its own form with more.

    A derived form makes its fields in `build_more`, fills them in `show_more`, reads them in
    `read_more` and names in `of_session` those that cannot change while a session is open.

    Parameters
    ----------
    settings : shown until the first state comes
    """

    edited = Signal(object)
    """The whole settings anew, whenever one of the fields changed."""

    def __init__(self, settings: S, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self._shown: object = None
        self._rendering = False
        self._captions: list[tuple[QLabel, Callable[[], str]]] = []
        self._accumulation = self.number(0.1, 3600.0, 1, 1.0)
        self._settle = self.number(0.0, 600.0, 1, 0.5)
        self._passes = self.number(1, 9, 0, 1)
        self._g = self.number(9.7, 9.9, 5, 0.0001)
        self._u_g = self.number(0.0, 0.1, 5, 0.0001)
        self._thermo, self._thermo_settings = QCheckBox(), QPushButton()
        self._thermo.toggled.connect(self._on_edited)
        self._thermo_settings.setCheckable(True)
        self._cycle = QLineEdit()
        self._cycle.editingFinished.connect(self._on_edited)
        self._temperature = ChoiceField()
        self._temperature.activated.connect(self._on_edited)
        unit = self.fontMetrics().height()
        self.column = QVBoxLayout(self)
        """Where a derived form puts what it has of its own."""
        self.column.setContentsMargins(0, 0, unit // 3, 0)
        self.column.setSpacing(unit // 2)
        self.times = self.grid()
        """Captions and fields in two columns."""
        self.field(self.times, lambda: self.tr("Accumulation Time, sec"), self._accumulation)
        self.field(self.times, lambda: self.tr("Settling time, sec"), self._settle)
        self.field(self.times, lambda: self.tr("Passes"), self._passes)
        self.field(self.times, lambda: self.tr("Local g, m/s²"), self._g)
        self.field(self.times, lambda: self.tr("u(g), m/s²"), self._u_g)
        self.column.addLayout(self.times)
        self.column.addWidget(self._build_temperatures())
        self.build_more()
        self.column.addStretch(1)
        self._thermo_settings.toggled.connect(self._cycle_row.setVisible)
        self.retranslate()

    # --- what a derived form has to say -----------------------------------------------------------

    def build_more(self) -> None:
        """Make the fields that the test has of its own."""

    def show_more(self, state: MeasuringState[S]) -> None:
        """Fill them."""

    def read_more(self, settings: S) -> S:
        """Take their values into the settings."""
        return settings

    def of_session(self) -> tuple[QWidget, ...]:
        """Those that belong to the session, and cannot change while it is open."""
        return ()

    def always_open(self) -> tuple[QWidget, ...]:
        """Those that can change between accumulations."""
        return ()

    def thermal_choice(self, state: MeasuringState[S]) -> bool:  # noqa: ARG002
        """Whether the operator chooses to go through temperatures; else it is always done."""
        return True

    # --- means ------------------------------------------------------------------------------------

    def plain_number(self, low: float, high: float, decimals: int, step: float) -> NumberField:
        """A number field that tells nobody."""
        box = NumberField(low, high, decimals)
        box.setSingleStep(step)
        # The widest number of the range would claim a place that the column does not have.
        box.setMinimumWidth(4 * self.fontMetrics().height())
        return box

    def number(self, low: float, high: float, decimals: int, step: float) -> NumberField:
        """A number field whose changes are edits."""
        box = self.plain_number(low, high, decimals, step)
        box.valueChanged.connect(self._on_edited)
        return box

    def caption(self, words: Callable[[], str]) -> QLabel:
        """A label whose words follow the language."""
        label = QLabel()
        self._captions.append((label, words))
        return label

    def grid(self) -> QGridLayout:
        """A tight grid whose first column takes the room."""
        unit = self.fontMetrics().height()
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(unit // 2)
        grid.setVerticalSpacing(unit // 4)
        grid.setColumnStretch(0, 1)
        return grid

    def field(self, grid: QGridLayout, words: Callable[[], str], field: QWidget) -> QLabel:
        """A caption and its field in the next row of a grid."""
        label = self.caption(words)
        label.setBuddy(field)
        field.setFixedWidth(round(6.5 * self.fontMetrics().height()))
        row = grid.rowCount()
        grid.addWidget(label, row, 0)
        grid.addWidget(field, row, 1)
        return label

    def edit(self) -> None:
        """A field that is none of the plain numbers was changed."""
        self._on_edited()

    # --- building ---------------------------------------------------------------------------------

    def _build_temperatures(self) -> QWidget:
        box = QWidget()
        grid = self.grid()
        box.setLayout(grid)
        self._thermo_row = QWidget()
        row = QHBoxLayout(self._thermo_row)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self._thermo, 1)
        row.addWidget(self._thermo_settings)
        grid.addWidget(self._thermo_row, 0, 0, 1, 2)
        self._cycle_row = QWidget()
        cycle = QVBoxLayout(self._cycle_row)
        cycle.setContentsMargins(0, 0, 0, 0)
        name = self.caption(lambda: self.tr("Temperatures of the cycle, °C"))
        name.setBuddy(self._cycle)
        cycle.addWidget(name)
        cycle.addWidget(self._cycle)
        self._cycle_row.hide()
        grid.addWidget(self._cycle_row, 1, 0, 1, 2)
        self._temperature_label = self.field(
            grid, lambda: self.tr("Temperatures, °C"), self._temperature
        )
        return box

    # --- showing ----------------------------------------------------------------------------------

    def render(self, state: MeasuringState[S]) -> None:
        """Show the settings of a state."""
        shown = (state.layout, state.test, state.settings, state.locked, state.temperatures)
        if shown == self._shown:
            return
        self._shown = shown
        settings = self._settings = state.settings
        self._rendering = True
        self._accumulation.setValue(settings.accumulation_s)
        self._settle.setValue(settings.settle_s)
        self._passes.setValue(settings.passes)
        self._g.setValue(settings.g_mps2)
        self._u_g.setValue(settings.u_g_mps2)
        self._thermo.setChecked(settings.thermo)
        self._show_temperatures(state)
        self.show_more(state)
        self._rendering = False
        choice = self.thermal_choice(state)
        self._thermo_row.setVisible(choice)
        self._cycle_row.setVisible(choice and self._thermo_settings.isChecked())
        self._enable(state)

    def _show_temperatures(self, state: MeasuringState[S]) -> None:
        texts = [_signed(value) for value in state.temperatures]
        if [self._temperature.itemText(i) for i in range(self._temperature.count())] != texts:
            self._temperature.clear()
            self._temperature.addItems(texts)
        self._temperature.setCurrentIndex(state.settings.visit if texts else -1)
        for widget in (self._temperature, self._temperature_label):
            widget.setVisible(bool(texts))
        if not self._cycle.hasFocus():
            self._cycle.setText(" ".join(_signed(value) for value in state.settings.cycle_c))

    def _enable(self, state: MeasuringState[S]) -> None:
        locked = state.locked.plan or state.locked.timing
        for widget in (self._passes, self._thermo, self._cycle, *self.of_session()):
            _allow(widget, locked)
        free = (self._accumulation, self._settle, self._temperature, self._g, self._u_g)
        for widget in (*free, *self.always_open()):
            _allow(widget, state.locked.timing)

    # --- what the operator does -------------------------------------------------------------------

    def _on_edited(self, *_: object) -> None:
        if self._rendering:
            return
        settings = replace(
            self._settings,
            accumulation_s=self._accumulation.value(),
            settle_s=self._settle.value(),
            passes=round(self._passes.value()),
            g_mps2=self._g.value(),
            u_g_mps2=self._u_g.value(),
            thermo=self._thermo.isChecked(),
            cycle_c=_temperatures(self._cycle.text()) or self._settings.cycle_c,
            visit=max(0, self._temperature.currentIndex()),
        )
        self.edited.emit(self.read_more(settings))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate()

    def retranslate(self) -> None:
        """Write all words; a derived form adds its own."""
        for label, words in self._captions:
            label.setText(words())
            buddy = label.buddy()
            if buddy is not None:
                buddy.setAccessibleName(label.text())
        self._thermo.setText(self.tr("Termo calibration"))
        self._thermo_settings.setText(self.tr("Settings"))


def _allow(widget: QWidget, why_not: str) -> None:
    widget.setEnabled(not why_not)
    widget.setToolTip(shown(why_not))


def _signed(value: float) -> str:
    return f"{value:+g}".replace("-", "\N{MINUS SIGN}")


def _temperatures(text: str) -> tuple[float, ...]:
    """Numbers of a line; nothing if one of its words is no temperature."""
    values = numbers_in(text)
    return values if all(-273.0 < value < 1000.0 for value in values) else ()


def numbers_in(text: str) -> tuple[float, ...]:
    """Numbers of a line, divided by blanks or semicolons; nothing if one word is no number."""
    words = text.replace("\N{MINUS SIGN}", "-").replace(",", ".").replace(";", " ").split()
    try:
        return tuple(float(word) for word in words)
    except ValueError:
        return ()
