"""The line that says whether the device is there and well."""

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from gui.languages.anchors import beside
from gui.languages.shown import shown_number
from gui.widgets.fields import ChoiceField
from gui.widgets.icons import paint_tone
from gui.widgets.number_text import grouped
from gui.widgets.states import DeviceStripState, LinkMark, Tone
from gui.widgets.theme import current_theme

_LINK_TONE = {
    LinkMark.OFFLINE: Tone.IDLE,
    LinkMark.OPENING: Tone.BUSY,
    LinkMark.STREAMING: Tone.GOOD,
    LinkMark.SILENT: Tone.DOUBT,
    LinkMark.LOST: Tone.BAD,
}


class DeviceStrip(QWidget):
    """Device, port, state and counters in one row."""

    device_chosen = Signal(int)
    properties_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = DeviceStripState()
        unit = self.fontMetrics().height()
        self._device = ChoiceField()
        self._device.setMinimumContentsLength(8)
        self._device.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._device.activated.connect(self.device_chosen)
        self._properties = QPushButton()
        self._properties.clicked.connect(self.properties_requested)
        self._orders = QToolButton()
        self._orders.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu = QMenu(self)
        """What can be done with the device; who owns the window puts its actions here."""
        self._orders.setMenu(self.menu)
        self._port = QLabel()
        self._sign = _Sign()
        self._link = QLabel()
        self._counters = {
            name: _Counter(name in ("bad_checksum", "lost", "garbage"))
            for name in ("frames", "received_bytes", "bad_checksum", "lost", "garbage")
        }
        self._temperature = QLabel()
        row = self._row = QHBoxLayout(self)
        row.setContentsMargins(unit, unit // 3, unit, unit // 3)
        row.setSpacing(round(0.6 * unit))
        row.addWidget(self._device)
        row.addWidget(self._properties)
        row.addWidget(self._orders)
        row.addSpacing(unit // 2)
        row.addWidget(self._port)
        row.addSpacing(unit // 2)
        row.addWidget(self._sign)
        row.addWidget(self._link)
        row.addStretch(1)
        for counter in self._counters.values():
            row.addWidget(counter)
        row.addSpacing(unit // 2)
        row.addWidget(self._temperature)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self._retranslate()

    def render(self, state: DeviceStripState) -> None:
        """Show a state."""
        names = [self._device.itemText(row) for row in range(self._device.count())]
        if names != list(state.devices):
            self._device.clear()
            self._device.addItems(list(state.devices))
        self._device.setCurrentIndex(state.current if state.devices else -1)
        self._device.setVisible(bool(state.devices))
        self._state = state
        baud = f"{state.baud}" if state.baud else ""
        self._port.setText(" ".join(part for part in (state.port, baud) if part))
        self._device.setToolTip(self._port.text())
        self._sign.set_tone(_LINK_TONE[state.link])
        link = self._link_text(state.link)
        if state.rate_hz is not None and state.link is LinkMark.STREAMING:
            link += f"  {shown_number(f'{state.rate_hz:.1f}')} " + self.tr("Hz")
        self._link.setText(link)
        for name, counter in self._counters.items():
            counter.set_value(getattr(state, name))
        self._temperature.setVisible(state.temperature_c is not None)
        if state.temperature_c is not None:
            self._temperature.setText(f"{shown_number(f'{state.temperature_c:.1f}')} °C")
        self.setAccessibleName(f"{self._device.currentText()} {self._port.text()} {link}")
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def minimumSizeHint(self) -> QSize:
        size = super().minimumSizeHint()
        narrow = sum(self._place(part) for part in self._yielding() if not part.isHidden())
        return QSize(max(0, size.width() - narrow), size.height())

    def _yielding(self) -> list[QWidget]:
        """What gives way where the row is too narrow, in this order; faults never do."""
        parts = [self._counters["received_bytes"], self._counters["frames"], self._port]
        return parts if self._state.temperature_c is None else [*parts, self._temperature]

    def _place(self, part: QWidget) -> int:
        return part.sizeHint().width() + self._row.spacing()

    def _fit(self) -> None:
        """Leave out what is needed least, as far as needed."""
        parts = self._yielding()
        needed = self.sizeHint().width()
        needed += sum(self._place(part) for part in parts if part.isHidden())
        for part in parts:
            part.setVisible(needed <= self.width())
            if part.isHidden():
                needed -= self._place(part)

    def _link_text(self, link: LinkMark) -> str:
        return {
            LinkMark.OFFLINE: self.tr("not connected"),
            LinkMark.OPENING: self.tr("opening"),
            LinkMark.STREAMING: self.tr("streaming"),
            LinkMark.SILENT: self.tr("open, no data"),
            LinkMark.LOST: self.tr("link lost"),
        }[link]

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        self._properties.setText(self.tr("Properties"))
        tip = self.tr("Device Properties: number, port, baud rate, scan")
        self._properties.setToolTip(beside(self._properties.text(), tip))
        self._orders.setText(self.tr("Device"))
        self._orders.setToolTip(self.tr("View ADC Data, Stop Device"))
        self._device.setAccessibleName(self.tr("Device"))
        self._temperature.setToolTip(self.tr("Temperature of the device"))
        captions = {
            "frames": (self.tr("frames"), self.tr("Frames received with a right checksum")),
            "received_bytes": (self.tr("bytes"), self.tr("Bytes received")),
            "bad_checksum": (self.tr("bad"), self.tr("Frames with a wrong checksum")),
            "lost": (self.tr("lost"), self.tr("Samples sent by the device that never came")),
            "garbage": (self.tr("garbage"), self.tr("Bytes that belong to no frame")),
        }
        for name, (caption, tip) in captions.items():
            self._counters[name].set_caption(caption, tip)
        self.render(self._state)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        painter.setPen(QColor(current_theme().line))
        painter.drawLine(0, self.height() - 1, self.width(), self.height() - 1)
        painter.end()


class _Sign(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self._tone = Tone.IDLE
        side = self.fontMetrics().height()
        self.setFixedSize(QSize(side, side))

    def set_tone(self, tone: Tone) -> None:
        if tone is not self._tone:
            self._tone = tone
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        rect = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        paint_tone(painter, rect, self._tone, current_theme().tones[self._tone])
        painter.end()


class _Counter(QWidget):
    """Caption and number; a fault counter above zero gets a warning sign before it."""

    def __init__(self, fault: bool) -> None:
        super().__init__()
        self._fault = fault
        self._value = -1
        self._caption = QLabel()
        self._caption.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self._number = QLabel()
        self._number.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._sign = _Sign()
        self._sign.set_tone(Tone.DOUBT)
        row = self._row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(self.fontMetrics().height() // 3)
        row.addWidget(self._sign)
        row.addWidget(self._caption)
        row.addWidget(self._number)
        self._sign.hide()

    def set_caption(self, caption: str, tip: str) -> None:
        self._caption.setText(caption)
        self.setToolTip(tip)

    def set_value(self, value: int) -> None:
        if value == self._value:
            return
        self._value = value
        text = grouped(value)
        self._number.setText(text)
        self._number.setAccessibleName(f"{self._caption.text()} {text}")
        # The place only grows, so that the row does not jitter while numbers run.
        width = self._number.fontMetrics().horizontalAdvance(text)
        self._number.setMinimumWidth(max(width, self._number.minimumWidth()))
        if self._fault:
            self._sign.setVisible(value > 0)
            font = self._number.font()
            font.setBold(value > 0)
            self._number.setFont(font)
        # The strip asks for the new width at once.
        self._row.activate()
