"""The dock of the simulated rig."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gui.rig.dial_view import Dial
from gui.rig.presenter import RigPresenter, RigView
from gui.widgets.fields import ChoiceField, NumberField
from gui.widgets.side_scroll import SideScroll
from gui.widgets.toggle import Toggle
from gui.widgets.word_label import WordLabel

MOUNTS = ("X_from", "X_to", "Y_from", "Y_to", "Z_from", "Z_to")


class RigPanel(QWidget):
    """What a hand could do to the bench: turn, re-mount, heat, spin, pull the cable."""

    def __init__(self, presenter: RigPresenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self.dial = Dial()
        self.dial.turned.connect(presenter.turn)
        self._words = WordLabel()
        self._words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._angle = NumberField(-720.0, 720.0, 3, "°")
        self._go = QPushButton()
        self._go.clicked.connect(self._on_go)
        self._mount = ChoiceField()
        for mount in MOUNTS:
            self._mount.addItem(f"{mount.replace('_', ' ')} ODH", mount)
        self._mount.activated.connect(self._on_mount)
        self._celsius = NumberField(-60.0, 120.0, 1, "°C")
        self._celsius.setValue(27.0)
        for field, step in ((self._angle, 15.0), (self._celsius, 10.0)):
            field.setSingleStep(step)
        self._celsius.valueChanged.connect(presenter.heat)
        self._rate = NumberField(-400.0, 400.0, 2, "°/s")
        self._rate.setSingleStep(10.0)
        self._rate.valueChanged.connect(presenter.spin)
        self.operator = Toggle()
        self.operator.clicked.connect(presenter.set_operator)
        self._plug = QPushButton()
        self._plug.setCheckable(True)
        self._plug.clicked.connect(self._on_plug)
        self._burst = QPushButton()
        self._burst.clicked.connect(presenter.burst)
        self._faults = QButtonGroup(self)
        self._faults.setExclusive(False)
        self._fault_buttons = {name: QPushButton() for name in ("noise", "drop", "stuck")}
        for button in self._fault_buttons.values():
            button.setCheckable(True)
            button.clicked.connect(self._on_fault)
        self._labels = [QLabel() for _ in range(4)]
        self._title = QLabel()
        self._view: RigView | None = None
        self._retranslate()
        self._build()
        presenter.changed.connect(self.render)

    def _build(self) -> None:
        unit = self.fontMetrics().height()
        page = QWidget()
        column = QVBoxLayout(page)
        column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        column.setSpacing(unit // 2)
        column.addWidget(self.operator)
        column.addWidget(self.dial)
        column.addWidget(self._words)
        grid = QGridLayout()
        grid.setHorizontalSpacing(unit // 2)
        grid.setVerticalSpacing(unit // 3)
        exact = QHBoxLayout()
        exact.addWidget(self._angle, 1)
        exact.addWidget(self._go)
        grid.addWidget(self._labels[0], 0, 0)
        grid.addLayout(exact, 0, 1)
        for row, field in enumerate((self._mount, self._celsius, self._rate), start=1):
            grid.addWidget(self._labels[row], row, 0)
            grid.addWidget(field, row, 1)
            self._labels[row].setBuddy(field)
        grid.setColumnStretch(1, 1)
        column.addLayout(grid)
        column.addSpacing(unit // 2)
        column.addWidget(self._title)
        buttons = QGridLayout()
        buttons.setSpacing(unit // 3)
        for place, button in enumerate((self._plug, self._burst, *self._fault_buttons.values())):
            buttons.addWidget(button, place // 2, place % 2)
        column.addLayout(buttons)
        column.addStretch(1)
        for field in (self._angle, self._celsius, self._rate, self._mount):
            field.setMinimumWidth(4 * unit)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(SideScroll(page, 17 * unit))
        for button in (self._plug, self._burst, *self._fault_buttons.values(), self._go):
            button.setMinimumWidth(2 * unit)

    def render(self, view: RigView | None) -> None:
        """Show a state."""
        self._view = view
        if view is None:
            return
        rig = view.rig
        self.dial.set_angles(rig.head_deg, rig.head_target_deg)
        words = self.tr("moving") if rig.moving else self.tr("at rest")
        place = f"{rig.mount.replace('_', ' ')} ODH, {words}"
        if rig.axis:
            place = self.tr("table: {rate} deg/s about {axis}").format(
                rate=f"{rig.table_dps:+.4g}".replace("-", "\N{MINUS SIGN}"), axis=rig.axis.upper()
            )
        self._words.setText(f"{place}, {rig.case_c:.1f} °C")
        place = self._mount.findData(rig.mount)
        if not self._mount.view().isVisible() and place >= 0:
            self._mount.setCurrentIndex(place)
        self.operator.setChecked(view.operator)
        self._plug.setChecked(not rig.plugged)
        self._plug.setText(self.tr("Unplug") if rig.plugged else self.tr("Plug in"))
        for name, button in self._fault_buttons.items():
            button.setChecked(view.fault == name)

    def _on_go(self) -> None:
        self._presenter.turn(self._angle.value())

    def _on_mount(self, index: int) -> None:
        self._presenter.remount(self._mount.itemData(index))

    def _on_plug(self, pulled: bool) -> None:
        self._presenter.set_plugged(not pulled)

    def _on_fault(self) -> None:
        button = self.sender()
        name = next(n for n, one in self._fault_buttons.items() if one is button)
        self._presenter.set_fault(name if self._fault_buttons[name].isChecked() else "")

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self.render(self._view)

    def _retranslate(self) -> None:
        self.operator.setText(self.tr("Operator turns it for me"))
        words = (
            self.tr("Angle"),
            self.tr("Mount"),
            self.tr("Temperature"),
            self.tr("Rate table"),
        )
        for label, text in zip(self._labels, words, strict=True):
            label.setText(text)
        self._angle.setAccessibleName(self.tr("Angle of the head"))
        self._go.setText(self.tr("Turn"))
        self.operator.setToolTip(self.tr("Somebody sets every position that the test asks for"))
        self._title.setText(self.tr("Faults"))
        self._plug.setText(self.tr("Unplug"))
        self._burst.setText(self.tr("Noise burst"))
        names = {
            "noise": self.tr("Noisy line"),
            "drop": self.tr("Lost frames"),
            "stuck": self.tr("Stuck channel"),
        }
        for name, button in self._fault_buttons.items():
            button.setText(names[name])
