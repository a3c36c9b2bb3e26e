"""The one row of actions that every tab has, in the same place and with the same keys."""

from PySide6.QtCore import QEvent, QRect, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetrics,
    QKeySequence,
    QPaintEvent,
    QResizeEvent,
    QShortcut,
)
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QStyle,
    QStyleOptionButton,
    QStylePainter,
    QWidget,
)

from gui.languages.anchors import anchor
from gui.languages.shown import shown
from gui.widgets.states import ActionBarState, ActionItem
from gui.widgets.theme import current_theme
from gui.widgets.toggle import Toggle

_HANDS_FREE_KEY = "Ctrl+H"


class ActionBar(QWidget):
    """Buttons of a tab; the keys work anywhere in the window while the bar is visible.

    Space is the default action from everywhere except fields that text is typed into, and except
    a button or list that the operator walked to with Tab: that one is then pressed, as usual.
    """

    triggered = Signal(str)
    """Key of the action."""
    hands_free_toggled = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = ActionBarState(())
        self._places: list[_ActionButton] = []
        self._buttons: dict[str, _ActionButton] = {}
        unit = self.fontMetrics().height()
        self._row = QHBoxLayout()
        self._row.setSpacing(unit // 2)
        self._hands_free = Toggle()
        self._hands_free.clicked.connect(self.hands_free_toggled)
        self._hands_free_key = QShortcut(QKeySequence(_HANDS_FREE_KEY), self)
        self._hands_free_key.activated.connect(self._hands_free.click)
        outer = QHBoxLayout(self)
        outer.setContentsMargins(unit, unit // 2, unit, unit // 2)
        outer.setSpacing(unit)
        outer.addLayout(self._row)
        outer.addStretch(1)
        outer.addWidget(self._hands_free)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self._retranslate()
        self.render(self._state)

    def render(self, state: ActionBarState) -> None:
        """Show these actions."""
        self._state = state
        while len(self._places) > len(state.items):
            old = self._places.pop()
            self._row.removeWidget(old)
            old.hide()
            old.deleteLater()
        while len(self._places) < len(state.items):
            self._places.append(self._new_button())
        # A button keeps its place: what starts a measurement is also what stops it.
        self._buttons = {}
        for button, item in zip(self._places, state.items, strict=True):
            button.render(item)
            self._buttons[item.key] = button
        self._hands_free.setVisible(state.hands_free is not None)
        self._hands_free_key.setEnabled(state.hands_free is not None)
        self._hands_free.setChecked(bool(state.hands_free))
        self._fit()

    def button(self, key: str) -> QPushButton:
        """Return the button of an action.

        Raises
        ------
        KeyError
            The bar does not have this action now.
        """
        return self._buttons[key]

    def _new_button(self) -> "_ActionButton":
        button = _ActionButton(self)
        button.clicked.connect(self._on_clicked)
        self._row.addWidget(button)
        button.show()
        return button

    def _on_clicked(self) -> None:
        self.triggered.emit(self.sender().property("key"))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Leave the key hints out where the row would not fit with them."""
        buttons = self._buttons.values()
        margins = self.contentsMargins().left() + 4 * self.fontMetrics().height()
        toggle = self._hands_free.sizeHint().width() if self._hands_free.isVisibleTo(self) else 0
        spacing = self._row.spacing() * len(self._buttons)
        full = sum(button.full_width() for button in buttons) + spacing + margins + toggle
        for button in buttons:
            button.show_hint(full <= self.width())

    def minimumSizeHint(self) -> QSize:
        width = sum(button.bare_width() + self._row.spacing() for button in self._buttons.values())
        return QSize(
            width + self._hands_free.sizeHint().width(), super().minimumSizeHint().height()
        )

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()
            self.render(self._state)

    def _retranslate(self) -> None:
        self._hands_free.setText(self.tr("Hands-free"))
        tip = self.tr("Recognises rest in the next position and accumulates by itself ({key})")
        self._hands_free.setToolTip(tip.format(key=_HANDS_FREE_KEY))
        self._hands_free.setAccessibleDescription(self._hands_free.toolTip())


class _ActionButton(QPushButton):
    """A button that shows its key after its words."""

    def __init__(self, bar: ActionBar) -> None:
        super().__init__(bar)
        self.setProperty("big", True)
        # A mouse click leaves the focus where it was, so that Space stays the default action.
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._shortcut = QShortcut(self)
        self._shortcut.setAutoRepeat(False)
        self._shortcut.activated.connect(self._on_key)
        self._hint = ""
        self._anchor = ""
        self._hint_shown = True

    def render(self, item: ActionItem) -> None:
        self.setProperty("key", item.key)
        if self.property("primary") != item.default:
            self.setProperty("primary", item.default)
            self.style().unpolish(self)
            self.style().polish(self)
        sequence = QKeySequence(item.shortcut)
        if sequence != self._shortcut.key():
            self._shortcut.setKey(sequence)
        # As the keys are engraved, in every language.
        self._hint = sequence.toString(QKeySequence.SequenceFormat.PortableText)
        words = shown(item.text)
        self._anchor = anchor(item.text)
        self.setText(words)
        self.setEnabled(item.enabled)
        self.setAccessibleName(words)
        tip = shown(item.why_not) if not item.enabled and item.why_not else words
        self.setToolTip(f"{tip} ({self._hint})" if self._hint and item.enabled else tip)
        self.setAccessibleDescription(self.toolTip())

    def _on_key(self) -> None:
        focus = QApplication.focusWidget()
        by_tab = self.window().testAttribute(Qt.WidgetAttribute.WA_KeyboardFocusChange)
        if by_tab and self._shortcut.key() == QKeySequence(Qt.Key.Key_Space):
            if isinstance(focus, QAbstractButton):
                focus.click()
                return
            if isinstance(focus, QComboBox):
                focus.showPopup()
                return
        self.click()

    def full_width(self) -> int:
        return self.bare_width() + self._hint_width()

    def bare_width(self) -> int:
        width = super().sizeHint().width()
        if not self._anchor:
            return width
        margins = width - self.fontMetrics().horizontalAdvance(self.text())
        wide = QFontMetrics(self._small()).horizontalAdvance(self._anchor)
        return max(width, wide + margins)

    def _small(self) -> QFont:
        """The font of the English label under a translated one."""
        font = QFont(self.font())
        font.setBold(False)
        font.setPointSizeF(0.82 * font.pointSizeF())
        return font

    def _anchor_height(self) -> int:
        return round(0.9 * QFontMetrics(self._small()).height()) if self._anchor else 0

    def show_hint(self, shown: bool) -> None:
        if shown != self._hint_shown:
            self._hint_shown = shown
            self.updateGeometry()
            self.update()

    def _hint_width(self) -> int:
        if not self._hint:
            return 0
        metrics = self.fontMetrics()
        return metrics.horizontalAdvance(self._hint) + metrics.height() // 2

    def sizeHint(self) -> QSize:
        size = super().sizeHint()
        size.setWidth(self.full_width() if self._hint_shown else self.bare_width())
        size.setHeight(size.height() + self._anchor_height())
        return size

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def paintEvent(self, event: QPaintEvent) -> None:
        hint_words = self._hint if self._hint_shown else ""
        if not hint_words and not self._anchor:
            super().paintEvent(event)
            return
        theme = current_theme()
        painter = QStylePainter(self)
        option = QStyleOptionButton()
        self.initStyleOption(option)
        painter.drawControl(QStyle.ControlElement.CE_PushButtonBevel, option)
        words = self.fontMetrics().horizontalAdvance(self.text())
        low = self._anchor_height()
        height = self.height() - low
        left = (self.width() - words - (self._hint_width() if hint_words else 0)) // 2
        primary = bool(self.property("primary"))
        text, hint = (theme.on_accent,) * 2 if primary else (theme.text, theme.muted)
        if not self.isEnabled():
            text = hint = theme.disabled
        flags = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        painter.setPen(QColor(text))
        painter.drawText(QRect(left, 0, words + 2, height), flags, self.text())
        font = self.font()
        font.setBold(False)
        painter.setFont(font)
        painter.setPen(QColor(hint))
        gap = self.fontMetrics().height() // 2
        painter.drawText(QRect(left + words + gap, 0, self.width(), height), flags, hint_words)
        if self._anchor:
            painter.setFont(self._small())
            foot = QRect(0, height - low // 2, self.width(), low)
            painter.drawText(foot, Qt.AlignmentFlag.AlignCenter, self._anchor)
        painter.end()
