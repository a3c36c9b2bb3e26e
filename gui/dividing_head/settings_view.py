"""The operator's settings, in the words of ClbAcc and Pointer."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from core.plans.orientation import BaseOrientation
from gui.dividing_head.device import CLBACC
from gui.dividing_head.settings import TILTERS, HeadSettings, Tilter
from gui.dividing_head.state import HeadState
from gui.widgets.fields import ChoiceField, NumberField

MOUNTS = ("X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to")


class SettingsView(QWidget):
    """All fields; `edited` brings the whole settings anew whenever one of them changes."""

    edited = Signal(object)
    angle_added = Signal(str, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = HeadSettings()
        self._shown: object = None
        self._rendering = False
        self._captions: list[tuple[QLabel, Callable[[], str]]] = []
        self._accumulation = self._number(0.1, 3600.0, 1, 1.0)
        self._settle = self._number(0.0, 600.0, 1, 0.5)
        self._passes = self._number(1, 9, 0, 1)
        self._g = self._number(9.7, 9.9, 5, 0.0001)
        self._u_g = self._number(0.0, 0.1, 5, 0.0001)
        self._u_head = self._number(0.0, 3600.0, 1, 1.0)
        self._base = [self._number(-9999.0, 9999.0, 2, 1.0) for _ in range(4)]
        self._thermo, self._thermo_settings = QCheckBox(), QPushButton()
        self._thermo.toggled.connect(self._on_edited)
        self._thermo_settings.setCheckable(True)
        self._cycle = QLineEdit()
        self._cycle.editingFinished.connect(self._on_edited)
        self._temperature = ChoiceField()
        self._temperature.activated.connect(self._on_edited)
        self._modes = QButtonGroup(self)
        self._mode_buttons = [QRadioButton() for _ in TILTERS]
        for place, button in enumerate(self._mode_buttons):
            self._modes.addButton(button, place)
        self._modes.idClicked.connect(self._on_edited)
        self._tilter_number, self._tilter_position = (self._number(1, 99, 0, 1) for _ in range(2))
        self._tilt = [self._number(-360.0, 360.0, 3, 1.0) for _ in range(3)]
        self._free_mount, self._free_angle = (
            ChoiceField(),
            self._plain_number(-720.0, 720.0, 3, 15.0),
        )
        self._add = QPushButton()
        self._add.clicked.connect(self._on_add)
        self._build()
        self._thermo_settings.toggled.connect(self._cycle_row.setVisible)
        self._retranslate()

    # --- building ---------------------------------------------------------------------------------

    def _plain_number(self, low: float, high: float, decimals: int, step: float) -> NumberField:
        box = NumberField(low, high, decimals)
        box.setSingleStep(step)
        # The widest number of the range would claim a place that the column does not have.
        box.setMinimumWidth(4 * self.fontMetrics().height())
        return box

    def _number(self, low: float, high: float, decimals: int, step: float) -> NumberField:
        box = self._plain_number(low, high, decimals, step)
        box.valueChanged.connect(self._on_edited)
        return box

    def _caption(self, words: Callable[[], str]) -> QLabel:
        label = QLabel()
        self._captions.append((label, words))
        return label

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, unit // 3, 0)
        column.setSpacing(unit // 2)
        times = self._grid()
        self._field(times, 0, 0, lambda: self.tr("Accumulation Time, sec"), self._accumulation)
        self._field(times, 1, 0, lambda: self.tr("Settling time, sec"), self._settle)
        self._field(times, 2, 0, lambda: self.tr("Passes"), self._passes)
        self._field(times, 3, 0, lambda: self.tr("Local g, m/s²"), self._g)
        self._field(times, 4, 0, lambda: self.tr("u(g), m/s²"), self._u_g)
        self._field(times, 5, 0, lambda: self.tr("u(head angle), arcsec"), self._u_head)
        column.addLayout(times)
        column.addWidget(self._build_temperatures())
        column.addWidget(self._build_base())
        column.addWidget(self._build_tilter())
        column.addWidget(self._build_free())
        column.addStretch(1)

    def _grid(self) -> QGridLayout:
        unit = self.fontMetrics().height()
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(unit // 2)
        grid.setVerticalSpacing(unit // 4)
        grid.setColumnStretch(0, 1)
        return grid

    def _field(
        self, grid: QGridLayout, row: int, column: int, words: Callable[[], str], field: QWidget
    ) -> None:
        label = self._caption(words)
        label.setBuddy(field)
        field.setFixedWidth(round(6.5 * self.fontMetrics().height()))
        grid.addWidget(label, row, column)
        grid.addWidget(field, row, column + 1)

    def _build_temperatures(self) -> QWidget:
        box = QWidget()
        grid = self._grid()
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
        cycle.addWidget(self._caption(lambda: self.tr("Temperatures of the cycle, °C")))
        cycle.addWidget(self._cycle)
        self._cycle_row.hide()
        grid.addWidget(self._cycle_row, 1, 0, 1, 2)
        self._field(grid, 2, 0, lambda: self.tr("Temperatures, °C"), self._temperature)
        self._temperature_label = self._captions[-1][0]
        return box

    def _build_base(self) -> QWidget:
        self._base_box = QWidget()
        grid = self._grid()
        self._base_box.setLayout(grid)
        grid.addWidget(self._caption(lambda: self.tr("Base orientation")), 0, 0, 1, 4)
        names = ("α, ang. min.", "β, ang. min.", "γ, deg.", "ψ, deg.")
        for place, (name, field) in enumerate(zip(names, self._base, strict=True)):
            field.setAccessibleName(f"Base orientation {name}")
            label = QLabel(name)
            label.setBuddy(field)
            grid.addWidget(label, 1 + place % 2, 2 * (place // 2))
            grid.addWidget(field, 1 + place % 2, 2 * (place // 2) + 1)
        grid.setColumnStretch(0, 0)
        grid.setColumnStretch(1, 1)
        grid.setColumnStretch(3, 1)
        return self._base_box

    def _build_tilter(self) -> QWidget:
        self._tilter_box = QWidget()
        column = QVBoxLayout(self._tilter_box)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(self.fontMetrics().height() // 4)
        modes = QHBoxLayout()
        modes.addWidget(self._caption(lambda: self.tr("Tilter")))
        for button in self._mode_buttons:
            modes.addWidget(button)
        modes.addStretch(1)
        column.addLayout(modes)
        self._auto_row, self._manual_row = QWidget(), QWidget()
        auto = QHBoxLayout(self._auto_row)
        auto.setContentsMargins(0, 0, 0, 0)
        for words, field in (
            (lambda: self.tr("Tilter No."), self._tilter_number),
            (lambda: self.tr("Position"), self._tilter_position),
        ):
            auto.addWidget(self._caption(words))
            auto.addWidget(field)
        auto.addStretch(1)
        manual = self._grid()
        self._manual_row.setLayout(manual)
        for place, (name, field) in enumerate(zip("ψθγ", self._tilt, strict=True)):
            field.setAccessibleName(f"Tilter {name}")
            manual.addWidget(QLabel(f"{name}, deg"), 0, place)
            manual.addWidget(field, 1, place)
            manual.setColumnStretch(place, 1)
        column.addWidget(self._auto_row)
        column.addWidget(self._manual_row)
        return self._tilter_box

    def _build_free(self) -> QWidget:
        box = QWidget()
        grid = self._grid()
        box.setLayout(grid)
        for mount in MOUNTS:
            self._free_mount.addItem(f"{mount.replace('_', ' ')} ODH", mount)
        self._free_angle.setSuffix("°")
        grid.addWidget(self._caption(lambda: self.tr("Free angle")), 0, 0, 1, 3)
        grid.addWidget(self._free_mount, 1, 0)
        grid.addWidget(self._free_angle, 1, 1)
        grid.addWidget(self._add, 1, 2)
        grid.setColumnStretch(1, 1)
        return box

    # --- showing ----------------------------------------------------------------------------------

    def render(self, state: HeadState) -> None:
        """Show the settings of a state."""
        shown = (state.layout, state.settings, state.locked, state.temperatures)
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
        self._u_head.setValue(settings.head_u_arcsec)
        base = settings.base
        angles = (base.alpha_arcmin, base.beta_arcmin, base.gamma_deg, base.psi_deg)
        for field, value in zip(self._base, angles, strict=True):
            field.setValue(value)
        self._thermo.setChecked(settings.thermo)
        self._show_temperatures(state)
        self._show_tilter(settings.tilter)
        self._rendering = False
        assembly = state.layout == CLBACC
        self._base_box.setVisible(not assembly)
        self._tilter_box.setVisible(not assembly)
        self._thermo_row.setVisible(not assembly)
        self._cycle_row.setVisible(not assembly and self._thermo_settings.isChecked())
        self._enable(state)

    def _show_temperatures(self, state: HeadState) -> None:
        texts = [_signed(value) for value in state.temperatures]
        if [self._temperature.itemText(i) for i in range(self._temperature.count())] != texts:
            self._temperature.clear()
            self._temperature.addItems(texts)
        self._temperature.setCurrentIndex(state.settings.visit if texts else -1)
        for widget in (self._temperature, self._temperature_label):
            widget.setVisible(bool(texts))
        if not self._cycle.hasFocus():
            self._cycle.setText(" ".join(_signed(value) for value in state.settings.cycle_c))

    def _show_tilter(self, tilter: Tilter) -> None:
        self._mode_buttons[TILTERS.index(tilter.mode)].setChecked(True)
        self._tilter_number.setValue(tilter.number)
        self._tilter_position.setValue(tilter.position)
        angles = (tilter.psi_deg, tilter.theta_deg, tilter.gamma_deg)
        for field, value in zip(self._tilt, angles, strict=True):
            field.setValue(value)
        self._auto_row.setVisible(tilter.mode == "Auto")
        self._manual_row.setVisible(tilter.mode == "Manual")

    def _enable(self, state: HeadState) -> None:
        of_session = (*self._base, *self._tilt, *self._mode_buttons, self._tilter_number)
        for widget in (*of_session, self._tilter_position, self._passes, self._thermo, self._cycle):
            _allow(widget, state.locked.plan or state.locked.timing)
        for widget in (self._accumulation, self._settle, self._temperature, self._add):
            _allow(widget, state.locked.timing)
        for widget in (self._g, self._u_g, self._u_head):
            _allow(widget, state.locked.timing)

    # --- what the operator does -------------------------------------------------------------------

    def _on_edited(self, *_: object) -> None:
        if self._rendering:
            return
        alpha, beta, gamma, psi = (field.value() for field in self._base)
        tilt = [field.value() for field in self._tilt]
        self.edited.emit(
            replace(
                self._settings,
                accumulation_s=self._accumulation.value(),
                settle_s=self._settle.value(),
                passes=round(self._passes.value()),
                g_mps2=self._g.value(),
                u_g_mps2=self._u_g.value(),
                head_u_arcsec=self._u_head.value(),
                base=BaseOrientation(alpha, beta, gamma, psi),
                thermo=self._thermo.isChecked(),
                cycle_c=_temperatures(self._cycle.text()) or self._settings.cycle_c,
                visit=max(0, self._temperature.currentIndex()),
                tilter=Tilter(
                    TILTERS[self._modes.checkedId()],
                    round(self._tilter_number.value()),
                    round(self._tilter_position.value()),
                    *tilt,
                ),
            )
        )

    def _on_add(self) -> None:
        self.angle_added.emit(self._free_mount.currentData(), self._free_angle.value())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        for label, words in self._captions:
            label.setText(words())
            buddy = label.buddy()
            if buddy is not None:
                buddy.setAccessibleName(label.text())
        self._thermo.setText(self.tr("Termo calibration"))
        self._thermo_settings.setText(self.tr("Settings"))
        modes = (self.tr("None"), self.tr("Auto"), self.tr("Manual"))
        for button, text in zip(self._mode_buttons, modes, strict=True):
            button.setText(text)
        self._add.setText(self.tr("Add"))
        self._free_mount.setAccessibleName(self.tr("Mount of the free angle"))
        self._free_angle.setAccessibleName(self.tr("Free angle, deg"))


def _allow(widget: QWidget, why_not: str) -> None:
    widget.setEnabled(not why_not)
    widget.setToolTip(why_not)


def _signed(value: float) -> str:
    return f"{value:+g}".replace("-", "\N{MINUS SIGN}")


def _temperatures(text: str) -> tuple[float, ...]:
    """Numbers of a line; nothing if one of its words is no temperature."""
    words = text.replace("\N{MINUS SIGN}", "-").replace(",", ".").replace(";", " ").split()
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        return ()
    return values if all(-273.0 < value < 1000.0 for value in values) else ()
