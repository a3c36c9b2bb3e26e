"""The bytes in rows, one frame a row, coloured by what they are; columns can be pointed at."""

from PySide6.QtCore import QPoint, QRect, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QStaticText,
)
from PySide6.QtWidgets import QAbstractScrollArea, QWidget

from drivers.teach.rows import SheetRow
from gui.frames.state import BytesState, Named
from gui.widgets.colours import Theme, blend
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme

_TINT = 0.30
_NAMES = 2
"""Lines above the rows: names, then numbers of the bytes."""
_FIRST_LETTER, _DELETE = 33, 127
_HEX = tuple(QStaticText(f"{byte:02X}") for byte in range(256))
_LETTERS = tuple(QStaticText(chr(byte)) for byte in range(_DELETE))
for _text in (*_HEX, *_LETTERS):
    _text.setTextFormat(Qt.TextFormat.PlainText)


class BytesView(QAbstractScrollArea):
    """Rows of bytes. Arrows move the pointed column, Shift widens, Enter adds, Delete removes."""

    selected = Signal(int, int)
    """First byte of the columns pointed at, and the one after the last."""
    add_requested = Signal()
    remove_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.viewport().setCursor(Qt.CursorShape.IBeamCursor)
        self.setMinimumHeight(8 * self.fontMetrics().height())
        self._state = BytesState()
        self._selection: tuple[int, int] | None = None
        self._anchor = 0
        self._follow = True
        self.verticalScrollBar().valueChanged.connect(self._on_scrolled)

    def render(self, state: BytesState) -> None:
        """Show rows; the view follows the latest ones unless it was scrolled up."""
        self._state = state
        self._fit()
        self.viewport().update()

    def show_selection(self, selection: tuple[int, int] | None) -> None:
        """Show which columns are pointed at."""
        if selection != self._selection:
            self._selection = selection
            self.viewport().update()

    # --- geometry ---------------------------------------------------------------------------------

    @property
    def _cell(self) -> int:
        return (
            self._letter + 2 if self._state.text else self.fontMetrics().horizontalAdvance("DD") + 8
        )

    @property
    def _letter(self) -> int:
        return self.fontMetrics().horizontalAdvance("M")

    @property
    def _line(self) -> int:
        return self.fontMetrics().height() + 2

    def column_at(self, x: int) -> int:
        """Return the byte of a row that stands at a place of the viewport."""
        place = (x + self.horizontalScrollBar().value()) // self._cell
        return max(0, min(place, self._state.width - 1))

    def _x(self, column: int) -> int:
        return column * self._cell - self.horizontalScrollBar().value()

    def _fit(self) -> None:
        room = self.viewport().height() // self._line - _NAMES
        bar, follow = self.verticalScrollBar(), self._follow
        bar.setRange(0, max(0, len(self._state.rows) - room))
        bar.setPageStep(max(1, room))
        if follow:
            bar.setValue(bar.maximum())
        self._follow = follow
        letters = 0 if self._state.text else self._letter
        wide = self._state.width * (self._cell + letters) + 3 * self._letter
        across = self.horizontalScrollBar()
        across.setRange(0, max(0, wide - self.viewport().width()))
        across.setPageStep(self.viewport().width())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _on_scrolled(self, value: int) -> None:
        self._follow = value >= self.verticalScrollBar().maximum()

    # --- hands ------------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._anchor = self.column_at(event.position().toPoint().x())
            self._point(self._anchor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._point(self.column_at(event.position().toPoint().x()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Point at the whole part below the mouse."""
        column = self.column_at(event.position().toPoint().x())
        part = next((one.part for one in self._state.parts if _holds(one, column)), None)
        if part is not None:
            self._anchor = part.first
            self._point(part.stop - 1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        first, stop = self._selection or (0, 1)
        end = first if first < self._anchor else stop - 1
        step = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}.get(Qt.Key(event.key()), 0)
        if step:
            end = max(0, min(end + step, self._state.width - 1))
            if not event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
                self._anchor = end
            self._point(end)
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.add_requested.emit()
        elif event.key() == Qt.Key.Key_Delete:
            self.remove_requested.emit()
        else:
            super().keyPressEvent(event)

    def _point(self, column: int) -> None:
        low, high = sorted((self._anchor, column))
        self.show_selection((low, high + 1))
        self.selected.emit(low, high + 1)

    # --- painting ---------------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self.viewport())
        painter.fillRect(self.viewport().rect(), QColor(theme.base))
        self._paint_rows(painter, theme)
        self._paint_head(painter, theme)
        self._paint_selection(painter, theme)
        if not self._state.rows:
            self._paint_hint(painter, theme)
        painter.end()

    def _paint_hint(self, painter: QPainter, theme: Theme) -> None:
        unit = self.fontMetrics().height()
        painter.setPen(QColor(theme.muted))
        room = self.viewport().rect().adjusted(3 * unit, 3 * unit, -3 * unit, -3 * unit)
        words = self.tr(
            "Choose the port of the board and its baud rate, and press Listen; or open a raw log."
            " Frames, checksum and numbers are then looked for by themselves."
        )
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(room, flags, words)

    def _paint_head(self, painter: QPainter, theme: Theme) -> None:
        line, cell = self._line, self._cell
        painter.fillRect(0, 0, self.viewport().width(), _NAMES * line, QColor(theme.raised))
        metrics = self.fontMetrics()
        for named in self._state.parts:
            part = named.part
            box = QRect(self._x(part.first), 0, (part.stop - part.first) * cell - 2, line)
            painter.fillRect(box, _tint(named, theme, 2 * _TINT))
            painter.setPen(QColor(theme.text))
            room = box.adjusted(2, 0, 0, 0)
            name = metrics.elidedText(named.name, Qt.TextElideMode.ElideRight, room.width())
            painter.drawText(room, Qt.AlignmentFlag.AlignVCenter, name)
        painter.setPen(QColor(theme.muted))
        every = 5 if self._state.text else 1
        for column in range(0, self._state.width, every):
            box = QRect(self._x(column), line, every * cell - 2, line)
            where = Qt.AlignmentFlag.AlignLeft if self._state.text else Qt.AlignmentFlag.AlignCenter
            painter.drawText(box, where | Qt.AlignmentFlag.AlignVCenter, str(column % 1000))
        painter.setPen(QColor(theme.line))
        painter.drawLine(0, _NAMES * line - 1, self.viewport().width(), _NAMES * line - 1)

    def _paint_rows(self, painter: QPainter, theme: Theme) -> None:
        line = self._line
        first = self.verticalScrollBar().value()
        room = self.viewport().height() // line + 1 - _NAMES
        for place, row in enumerate(self._state.rows[first : first + room]):
            self._paint_row(painter, theme, row, (place + _NAMES) * line)

    def _paint_row(self, painter: QPainter, theme: Theme, row: SheetRow, top: int) -> None:
        line, cell = self._line, self._cell
        if row.whole:
            for named in self._state.parts:
                part = named.part
                box = QRect(self._x(part.first), top, (part.stop - part.first) * cell - 2, line - 1)
                painter.fillRect(box, _tint(named, theme, _TINT))
        known = row.whole or not self._state.parts
        painter.setPen(QColor(theme.text if known else theme.muted))
        if self._state.text:
            for place, byte in enumerate(row.data):
                letter = _LETTERS[byte] if byte < _DELETE else _HEX[byte]
                painter.drawStaticText(QPoint(self._x(place) + 2, top), letter)
            return
        for place, byte in enumerate(row.data):
            text = _HEX[byte]
            left = self._x(place) + (cell - 2 - round(text.size().width())) // 2
            painter.drawStaticText(QPoint(left, top), text)
        painter.setPen(QColor(theme.muted))
        letter, right = self._letter, self._x(self._state.width) + 8
        for place, byte in enumerate(row.data):
            if _FIRST_LETTER <= byte < _DELETE:
                painter.drawStaticText(QPoint(right + place * letter, top), _LETTERS[byte])

    def _paint_selection(self, painter: QPainter, theme: Theme) -> None:
        if self._selection is None:
            return
        first, stop = self._selection
        left, width = self._x(first) - 1, (stop - first) * self._cell - 1
        shade = QColor(theme.accent)
        shade.setAlpha(40)
        box = QRect(left, self._line, width, self.viewport().height() - self._line - 1)
        painter.fillRect(box, shade)
        painter.setPen(QColor(theme.accent))
        painter.drawRect(box)


def _holds(named: Named, column: int) -> bool:
    return named.part.first <= column < named.part.stop


def _tint(named: Named, theme: Theme, share: float) -> QColor:
    if named.part.kind == "sync":
        return blend(theme.accent, theme.base, share)
    if named.part.kind == "check":
        return blend(theme.tones[Tone.GOOD], theme.base, share)
    # The first curve colours come near those of header and checksum; fields begin behind them.
    colour = theme.curves[1:][named.colour % (len(theme.curves) - 1)]
    return blend(colour, theme.base, share)
