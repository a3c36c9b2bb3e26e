"""Customer, item and surroundings."""

import math
from dataclasses import fields

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from core.certificates.certificate import Order, Surroundings
from gui.certificate.limits import number_of
from gui.certificate.state import CertificateState
from gui.certificate.text_form_view import TextForm, embolden
from gui.widgets.number_text import MINUS

_ORDER = tuple(item.name for item in fields(Order))
_AIR = tuple(item.name for item in fields(Surroundings))


class OrderForm(QWidget):
    """What is particular to one certificate."""

    order_edited = Signal(object)
    """An `Order`."""
    surroundings_edited = Signal(object)
    """`Surroundings`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.order = TextForm(_ORDER, ("before", "remarks", "change"))
        self.air = TextForm(_AIR)
        self._air_title = QLabel()
        embolden(self._air_title)
        self.order.edited.connect(self._on_order)
        self.air.edited.connect(self._on_air)
        column = QVBoxLayout(self)
        column.addWidget(self.order)
        column.addWidget(self._air_title)
        column.addWidget(self.air)
        column.addStretch(1)
        self._retranslate()

    def render(self, state: CertificateState) -> None:
        """Show a state."""
        self.setEnabled(bool(state.subject))
        self.order.show_values({name: getattr(state.order, name) for name in _ORDER})
        typed = self.air.values()
        self.air.show_values(
            {name: _text(getattr(state.surroundings, name), typed[name]) for name in _AIR}
        )
        self.order.set_read_only(state.issued)
        self.air.set_read_only(state.issued)
        for widget in (self.order.labels["change"], self.order.fields["change"]):
            widget.setVisible(bool(state.order.replaces))

    def _on_order(self) -> None:
        self.order_edited.emit(Order(**self.order.values()))

    def _on_air(self) -> None:
        values = {name: number_of(text) for name, text in self.air.values().items()}
        self.surroundings_edited.emit(Surroundings(**values))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        day = self.tr("year-month-day")
        self._air_title.setText(self.tr("Surroundings"))
        self.order.set_words(
            {
                "customer": self.tr("Customer"),
                "contact": self.tr("Contact"),
                "item": self.tr("Item"),
                "model": self.tr("Type"),
                "serial": self.tr("Serial number"),
                "condition": self.tr("Condition"),
                "received": self.tr("Received"),
                "calibrated": self.tr("Calibrated"),
                "issued": self.tr("Issued"),
                "before": self.tr("Before adjustment"),
                "remarks": self.tr("Remarks"),
                "replaces": self.tr("Replaces No."),
                "change": self.tr("What was changed"),
            },
            {
                "customer": self.tr("name and address"),
                "item": self.tr("e.g. inclinometer, triad of accelerometers"),
                "condition": self.tr("e.g. without visible damage"),
                "received": day,
                "calibrated": day,
                "issued": day,
                "before": self.tr("what was found, or that nothing was adjusted"),
                "remarks": self.tr("deviations from the method, opinions"),
                "change": self.tr("and why"),
            },
        )
        self.air.set_words(
            {
                "temperature_c": self.tr("Air temperature, °C"),
                "humidity_percent": self.tr("Relative humidity, %"),
                "pressure_hpa": self.tr("Air pressure, hPa"),
                "supply_v": self.tr("Supply of the item, V"),
            },
            {},
        )


def _text(value: float, typed: str) -> str:
    """A number as text; what was typed as long as it means the same."""
    same = number_of(typed)
    if same == value or (math.isnan(same) and math.isnan(value)):
        return typed
    return "" if math.isnan(value) else f"{value:.10g}".replace("-", MINUS)
