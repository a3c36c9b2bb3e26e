"""A form of what is decided: it tells of what the operator edits, not of what it is shown."""

from abc import abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QDoubleSpinBox, QLineEdit, QWidget


class DecisionForm(QWidget):
    """A subclass shows a state within `_showing`, reads its fields in `_decision`, names them."""

    decided = Signal(object)
    """What the fields say now."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shows = False

    @abstractmethod
    def _decision(self) -> object:
        """What the fields say; None while there is nothing to decide."""

    @abstractmethod
    def _retranslate(self) -> None:
        """Write all words in the language of the window."""

    def _listen(self, *fields: QWidget) -> None:
        """Tell when one of these is edited."""
        for field in fields:
            match field:
                case QComboBox():
                    field.currentIndexChanged.connect(self._on_edited)
                case QDoubleSpinBox():
                    field.valueChanged.connect(self._on_edited)
                case QCheckBox():
                    field.toggled.connect(self._on_edited)
                case QLineEdit():
                    field.editingFinished.connect(self._on_edited)
                case _:
                    raise TypeError(f"{type(field).__name__} is no field of a form")

    @contextmanager
    def _showing(self) -> Iterator[None]:
        """Fields that are filled decide nothing."""
        self._shows = True
        try:
            yield
        finally:
            self._shows = False

    def _on_edited(self, *_: object) -> None:
        if self._shows:
            return
        decision = self._decision()
        if decision is not None:
            self.decided.emit(decision)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
