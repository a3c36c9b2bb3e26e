"""The operator's settings on the rate table, in the words of ClbDUS."""

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from gui.languages.shown import shown
from gui.measuring.settings_view import SettingsForm, numbers_in
from gui.measuring.state import MeasuringState
from gui.rate_table.free import MOUNTINGS, usable
from gui.rate_table.guide import ON_TABLE
from gui.rate_table.settings import RateSettings
from gui.widgets.fields import ChoiceField

_NOT_STATED = -91.0
"""Below all latitudes."""


class RateForm(SettingsForm[RateSettings]):
    """Uncertainty of the table, the Earth, whole turns, free lists of rates."""

    rates_set = Signal(object, object, bool)
    """Rates, mounts, and whether both ways."""

    def build_more(self) -> None:
        self._whole = self._check()
        self._u_rate = self.number(0.0, 1000.0, 4, 0.001)
        self._u_ppm = self.number(0.0, 1e6, 1, 10.0)
        self._u_head = self.number(0.0, 3600.0, 1, 1.0)
        self._full_scale = self.number(0.0, 1e5, 1, 10.0)
        self._latitude = self.number(_NOT_STATED, 90.0, 3, 1.0)
        self._azimuth_known = self._check()
        self._azimuth = self.number(-360.0, 360.0, 2, 1.0)
        self.column.insertWidget(1, self._whole)
        grid = self.grid()
        self._u_rate_label = self.field(grid, lambda: self.tr("u(rate), deg/s"), self._u_rate)
        self._u_ppm_label = self.field(grid, lambda: self.tr("u(rate), ppm"), self._u_ppm)
        self._u_head_label = self.field(
            grid, lambda: self.tr("u(head angle), arcsec"), self._u_head
        )
        self.field(grid, lambda: self.tr("Full scale, deg/s"), self._full_scale)
        self.field(grid, lambda: self.tr("Latitude, deg"), self._latitude)
        row = grid.rowCount()
        self._azimuth.setFixedWidth(round(6.5 * self.fontMetrics().height()))
        grid.addWidget(self._azimuth_known, row, 0)
        grid.addWidget(self._azimuth, row, 1)
        self.column.addLayout(grid)
        self.column.addWidget(self._build_free())

    def _check(self) -> QCheckBox:
        box = QCheckBox()
        box.toggled.connect(self.edit)
        return box

    def _build_free(self) -> QWidget:
        self._free_box = QWidget()
        column = QVBoxLayout(self._free_box)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(self.fontMetrics().height() // 4)
        self._rates = QLineEdit()
        self._both_ways, self._set = QCheckBox(), QPushButton()
        self._mounts = ChoiceField()
        for name in MOUNTINGS:
            self._mounts.addItem(shown(name), name)
        self._set.clicked.connect(self._on_set)
        self._rates.returnPressed.connect(self._on_set)
        self._rates.textEdited.connect(self._on_typed)
        label = self.caption(lambda: self.tr("Rates of your own, deg/s"))
        label.setBuddy(self._rates)
        row = QHBoxLayout()
        self._axis_label = self.caption(lambda: self.tr("Axis"))
        self._axis_label.setBuddy(self._mounts)
        row.addWidget(self._axis_label)
        row.addWidget(self._mounts, 1)
        row.addWidget(self._set)
        column.addWidget(label)
        column.addWidget(self._rates)
        column.addWidget(self._both_ways)
        column.addLayout(row)
        return self._free_box

    def show_more(self, state: MeasuringState[RateSettings]) -> None:
        settings = state.settings
        self._whole.setChecked(settings.whole_turns)
        self._u_rate.setValue(settings.rate_u_dps)
        self._u_ppm.setValue(settings.rate_u_ppm)
        self._u_head.setValue(settings.head_u_arcsec)
        self._full_scale.setValue(settings.full_scale_dps)
        latitude = settings.latitude_deg
        self._latitude.setValue(_NOT_STATED if latitude is None else latitude)
        self._azimuth_known.setChecked(settings.azimuth_known)
        self._azimuth.setValue(settings.base.psi_deg)
        on_table = state.test == ON_TABLE
        for widget in (self._u_rate, self._u_rate_label, self._u_ppm, self._u_ppm_label):
            widget.setVisible(on_table)
        for widget in (self._u_head, self._u_head_label, self._azimuth, self._azimuth_known):
            widget.setVisible(not on_table)
        self._whole.setVisible(on_table)
        self._free_box.setVisible(on_table)
        self._azimuth.setEnabled(settings.azimuth_known)

    def read_more(self, settings: RateSettings) -> RateSettings:
        latitude = self._latitude.value()
        return replace(
            settings,
            whole_turns=self._whole.isChecked(),
            rate_u_dps=self._u_rate.value(),
            rate_u_ppm=self._u_ppm.value(),
            head_u_arcsec=self._u_head.value(),
            full_scale_dps=self._full_scale.value(),
            latitude_deg=None if latitude <= _NOT_STATED else max(latitude, -90.0),
            azimuth_known=self._azimuth_known.isChecked(),
            base=replace(settings.base, psi_deg=self._azimuth.value()),
        )

    def of_session(self) -> tuple[QWidget, ...]:
        return (self._rates, self._mounts, self._both_ways, self._set)

    def always_open(self) -> tuple[QWidget, ...]:
        return (self._whole, self._u_rate, self._u_ppm, self._u_head, self._full_scale)

    def _on_typed(self, text: str) -> None:
        self._set.setEnabled(usable(numbers_in(text)))

    def _on_set(self) -> None:
        rates = numbers_in(self._rates.text())
        if usable(rates):
            mounts = MOUNTINGS[self._mounts.currentData()]
            self.rates_set.emit(rates, mounts, self._both_ways.isChecked())

    def retranslate(self) -> None:
        super().retranslate()
        self._whole.setText(self.tr("Whole turns of the table"))
        self._whole.setToolTip(
            self.tr("Each accumulation is made as long as whole turns nearest to the time above")
        )
        self._full_scale.setSpecialValueText(self.tr("largest"))
        self._latitude.setSpecialValueText(self.tr("not stated"))
        self._azimuth_known.setText(self.tr("Azimuth, deg"))
        self._azimuth.setAccessibleName(self.tr("Azimuth of the shaft, deg"))
        self._rates.setPlaceholderText("\N{MINUS SIGN}40 \N{MINUS SIGN}20 0 20 40")
        self._both_ways.setText(self.tr("Up and down"))
        self._set.setText(self.tr("Set"))
        for place in range(self._mounts.count()):
            self._mounts.setItemText(place, shown(self._mounts.itemData(place)))
