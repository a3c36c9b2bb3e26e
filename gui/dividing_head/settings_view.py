"""The operator's settings, in the words of ClbAcc and Pointer."""

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from core.plans.orientation import BaseOrientation
from gui.dividing_head.device import CLBACC
from gui.dividing_head.settings import TILTERS, HeadSettings, Tilter
from gui.measuring.settings_view import SettingsForm
from gui.measuring.state import MeasuringState
from gui.widgets.fields import ChoiceField
from gui.widgets.word_label import WordLabel

MOUNTS = ("X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to")


class HeadForm(SettingsForm[HeadSettings]):
    """The head's uncertainty, its base plate, the tilter, free angles."""

    angle_added = Signal(str, float)

    def build_more(self) -> None:
        self._u_head = self.number(0.0, 3600.0, 1, 1.0)
        self._base = [self.number(-9999.0, 9999.0, 2, 1.0) for _ in range(4)]
        self._modes = QButtonGroup(self)
        self._mode_buttons = [QRadioButton() for _ in TILTERS]
        for place, button in enumerate(self._mode_buttons):
            self._modes.addButton(button, place)
        self._modes.idClicked.connect(self.edit)
        self._tilter_number, self._tilter_position = (self.number(1, 99, 0, 1) for _ in range(2))
        self._tilt = [self.number(-360.0, 360.0, 3, 1.0) for _ in range(3)]
        self._free_mount = ChoiceField()
        self._free_angle = self.plain_number(-720.0, 720.0, 3, 15.0)
        self._add = QPushButton()
        self._add.clicked.connect(self._on_add)
        self.field(self.times, lambda: self.tr("u(head angle), arcsec"), self._u_head)
        self.column.addWidget(self._build_base())
        self.column.addWidget(self._build_tilter())
        self.column.addWidget(self._build_free())

    def _build_base(self) -> QWidget:
        self._base_box = QWidget()
        grid = self.grid()
        self._base_box.setLayout(grid)
        grid.addWidget(self.caption(lambda: self.tr("Base orientation")), 0, 0, 1, 4)
        names = ("α, ang. min.", "β, ang. min.", "γ, deg.", "ψ, deg.")
        for place, (name, field) in enumerate(zip(names, self._base, strict=True)):
            field.setAccessibleName(f"Base orientation {name}")
            label = WordLabel(name)
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
        # Above its buttons: beside them it would make the form too wide in some languages.
        column.addWidget(self.caption(lambda: self.tr("Tilter")))
        modes = QHBoxLayout()
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
            name = self.caption(words)
            name.setBuddy(field)
            auto.addWidget(name)
            auto.addWidget(field)
        auto.addStretch(1)
        manual = self.grid()
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
        grid = self.grid()
        box.setLayout(grid)
        for mount in MOUNTS:
            self._free_mount.addItem(f"{mount.replace('_', ' ')} ODH", mount)
        self._free_angle.setSuffix("°")
        self._free_angle.setMinimumWidth(5 * self.fontMetrics().height())
        grid.addWidget(self.caption(lambda: self.tr("Free angle")), 0, 0, 1, 2)
        grid.addWidget(self._add, 0, 2)
        grid.addWidget(self._free_mount, 1, 0)
        grid.addWidget(self._free_angle, 1, 1, 1, 2)
        grid.setColumnStretch(1, 1)
        return box

    def show_more(self, state: MeasuringState[HeadSettings]) -> None:
        settings = state.settings
        self._u_head.setValue(settings.head_u_arcsec)
        base = settings.base
        angles = (base.alpha_arcmin, base.beta_arcmin, base.gamma_deg, base.psi_deg)
        for field, value in zip(self._base, angles, strict=True):
            field.setValue(value)
        self._show_tilter(settings.tilter)
        assembly = state.layout == CLBACC
        self._base_box.setVisible(not assembly)
        self._tilter_box.setVisible(not assembly)

    def _show_tilter(self, tilter: Tilter) -> None:
        self._mode_buttons[TILTERS.index(tilter.mode)].setChecked(True)
        self._tilter_number.setValue(tilter.number)
        self._tilter_position.setValue(tilter.position)
        angles = (tilter.psi_deg, tilter.theta_deg, tilter.gamma_deg)
        for field, value in zip(self._tilt, angles, strict=True):
            field.setValue(value)
        self._auto_row.setVisible(tilter.mode == "Auto")
        self._manual_row.setVisible(tilter.mode == "Manual")

    def read_more(self, settings: HeadSettings) -> HeadSettings:
        alpha, beta, gamma, psi = (field.value() for field in self._base)
        tilt = [field.value() for field in self._tilt]
        return replace(
            settings,
            head_u_arcsec=self._u_head.value(),
            base=BaseOrientation(alpha, beta, gamma, psi),
            tilter=Tilter(
                TILTERS[self._modes.checkedId()],
                round(self._tilter_number.value()),
                round(self._tilter_position.value()),
                *tilt,
            ),
        )

    def of_session(self) -> tuple[QWidget, ...]:
        tilter = (self._tilter_number, self._tilter_position)
        return (*self._base, *self._tilt, *self._mode_buttons, *tilter)

    def always_open(self) -> tuple[QWidget, ...]:
        return (self._u_head, self._add)

    def thermal_choice(self, state: MeasuringState[HeadSettings]) -> bool:
        return state.layout != CLBACC

    def _on_add(self) -> None:
        self.angle_added.emit(self._free_mount.currentData(), self._free_angle.value())

    def retranslate(self) -> None:
        super().retranslate()
        modes = (self.tr("None"), self.tr("Auto"), self.tr("Manual"))
        for button, text in zip(self._mode_buttons, modes, strict=True):
            button.setText(text)
        self._add.setText(self.tr("Add"))
        self._free_mount.setAccessibleName(self.tr("Mount of the free angle"))
        self._free_angle.setAccessibleName(self.tr("Free angle, deg"))
