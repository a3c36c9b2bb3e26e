"""The operator's settings of an accuracy check."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QFileDialog,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QWidget,
)

from core.procedures.angle_errors import PITCH, ROLL
from core.procedures.conformity import RULES
from gui.accuracy.checking import NEAREST, NONE
from gui.accuracy.settings import AccuracySettings
from gui.measuring.settings_view import SettingsForm
from gui.measuring.state import MeasuringState
from gui.widgets.fields import ChoiceField

_KINDS = (PITCH, ROLL)
_FILE = "file"


class AccuracyForm(SettingsForm[AccuracySettings]):
    """Pitch or roll, the list Angles, limit and rule, the calibration."""

    angles_typed = Signal(str)
    """The list Angles as the operator left it."""

    def build_more(self) -> None:
        self._kinds = QButtonGroup(self)
        self._kind_buttons = [QRadioButton() for _ in _KINDS]
        row = QHBoxLayout()
        for place, button in enumerate(self._kind_buttons):
            self._kinds.addButton(button, place)
            row.addWidget(button)
        row.addStretch(1)
        self._kinds.idClicked.connect(self._on_kind)
        self.angles = QLineEdit()
        self.angles.editingFinished.connect(self._on_angles)
        self._u_head = self.number(0.0, 3600.0, 1, 1.0)
        self._limit = self.number(0.0, 90.0, 3, 0.05)
        self._rule = ChoiceField()
        for key in RULES:
            self._rule.addItem("", key)
        self._rule.activated.connect(self.edit)
        self._calibration = ChoiceField()
        for key in (NEAREST, NONE, _FILE):
            self._calibration.addItem("", key)
        self._calibration.activated.connect(self._on_calibration)
        self._choose = QPushButton()
        self._choose.clicked.connect(self._open)
        self._dialog: QFileDialog | None = None
        self._kind = PITCH
        self._file = ""
        self.column.insertLayout(0, row)
        listed = self.grid()
        listed.addWidget(self.caption(lambda: self.tr("Angles")), 0, 0)
        listed.addWidget(self.angles, 1, 0)
        self.column.insertLayout(1, listed)
        self.field(self.times, lambda: self.tr("u(head angle), arcsec"), self._u_head)
        self.field(self.times, lambda: self.tr("Limit ±, deg (0: none)"), self._limit)
        grid = self.grid()
        grid.addWidget(self.caption(lambda: self.tr("Decision rule")), 0, 0, 1, 2)
        grid.addWidget(self._rule, 1, 0, 1, 2)
        grid.addWidget(self.caption(lambda: self.tr("Own angles by the calibration")), 2, 0, 1, 2)
        grid.addWidget(self._calibration, 3, 0)
        grid.addWidget(self._choose, 3, 1)
        self.column.addLayout(grid)

    def show_more(self, state: MeasuringState[AccuracySettings]) -> None:
        settings = state.settings
        self._kind = ROLL if settings.plan_id.startswith(ROLL) else PITCH
        self._kind_buttons[_KINDS.index(self._kind)].setChecked(True)
        self._u_head.setValue(settings.head_u_arcsec)
        self._limit.setValue(settings.limit_deg)
        self._rule.setCurrentIndex(max(0, self._rule.findData(settings.rule)))
        chosen = settings.calibration
        self._file = chosen if chosen not in (NEAREST, NONE) else ""
        key = _FILE if self._file else chosen
        self._calibration.setCurrentIndex(self._calibration.findData(key))
        self._name_file()

    def read_more(self, settings: AccuracySettings) -> AccuracySettings:
        key = self._calibration.currentData()
        return replace(
            settings,
            head_u_arcsec=self._u_head.value(),
            limit_deg=self._limit.value(),
            rule=self._rule.currentData(),
            calibration=self._file or NEAREST if key == _FILE else key,
        )

    def show_angles(self, text: str) -> None:
        """Show the list of the plan; what the operator types is left alone."""
        if not self.angles.hasFocus():
            self.angles.setText(text)
            self.angles.setCursorPosition(0)

    def of_session(self) -> tuple[QWidget, ...]:
        return tuple(self._kind_buttons)

    def always_open(self) -> tuple[QWidget, ...]:
        return (self._u_head, self._limit, self._rule, self._calibration, self._choose, self.angles)

    def _on_kind(self, place: int) -> None:
        """The same list of angles, of the other kind."""
        kind = _KINDS[place]
        if kind != self._kind:
            plan_id = self._settings.plan_id.replace(self._kind, kind, 1)
            self.edited.emit(replace(self._settings, plan_id=plan_id))

    def _on_angles(self) -> None:
        if self.angles.isModified():
            self.angles.setModified(False)
            self.angles_typed.emit(self.angles.text())

    def _on_calibration(self) -> None:
        if self._calibration.currentData() == _FILE and not self._file:
            self._open()
        else:
            self.edit()

    def _open(self) -> None:
        """Choose a calibration, in a window that does not block the others."""
        if self._dialog is None:
            dialog = QFileDialog(self, self.tr("Calibration"))
            dialog.setModal(False)
            dialog.setNameFilters(
                [
                    self.tr("Calibrations and positions (*.cal.json *.txt *.run.csv session.json)"),
                    self.tr("All files (*)"),
                ]
            )
            dialog.fileSelected.connect(self.use_file)
            self._dialog = dialog
        self._dialog.show()

    def use_file(self, name: str) -> None:
        """Judge the raw codes by this calibration."""
        self.edited.emit(replace(self._settings, calibration=name))

    def _name_file(self) -> None:
        place = self._calibration.findData(_FILE)
        text = Path(self._file).name if self._file else self.tr("a file...")
        self._calibration.setItemText(place, text)
        self._calibration.setToolTip(self._file)

    def retranslate(self) -> None:
        super().retranslate()
        self._dialog = None
        for button, text in zip(
            self._kind_buttons, (self.tr("Pitch"), self.tr("Roll")), strict=True
        ):
            button.setText(text)
        self.angles.setAccessibleName(self.tr("Angles"))
        self.angles.setToolTip(self.tr("Pitch or roll to set, e.g. 0, 30, 60; Enter takes it"))
        names = {
            "guarded": self.tr("with uncertainty: guard band U"),
            "simple": self.tr("simple acceptance"),
        }
        for place in range(self._rule.count()):
            key = self._rule.itemData(place)
            self._rule.setItemText(place, names[key])
        self._rule.setAccessibleName(self.tr("Decision rule"))
        for key, text in ((NEAREST, self.tr("nearest of this unit")), (NONE, self.tr("none"))):
            self._calibration.setItemText(self._calibration.findData(key), text)
        self._calibration.setAccessibleName(self.tr("Calibration"))
        self._choose.setText(self.tr("Choose"))
        self._name_file()
