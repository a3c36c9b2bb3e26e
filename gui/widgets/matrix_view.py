"""A matrix in brackets with uncertainties under its values and its equation beside it."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from gui.languages.shown import shown, shown_number
from gui.widgets.states import MatrixState, TableState
from gui.widgets.table_text import table_text
from gui.widgets.theme import current_theme


class MatrixView(QWidget):
    """One matrix; Ctrl+C copies its values."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._state = MatrixState("", ())
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def render(self, state: MatrixState) -> None:
        """Show a matrix."""
        self._state = state
        self.setAccessibleName(f"{state.symbol} {state.unit}")
        spoken = "; ".join(
            ", ".join(f"{value} ± {u}" if u else value for value, u in row) for row in state.cells
        )
        self.setAccessibleDescription(f"{spoken}. {state.equation}")
        self.updateGeometry()
        self.update()

    def _fonts(self) -> tuple[QFont, QFont]:
        value = QFont(self.font())
        value.setPointSizeF(self.font().pointSizeF() * 1.25)
        return value, self.font()

    def _pitch(self) -> tuple[float, float]:
        """Width and height of a cell."""
        value, small = (QFontMetricsF(font) for font in self._fonts())
        widths = [
            max(value.horizontalAdvance(text), small.horizontalAdvance(f"± {shown_number(u)}"))
            for row in self._state.cells
            for text, u in row
        ]
        uncertain = any(u for row in self._state.cells for _, u in row)
        height = value.height() + (0.95 * small.height() if uncertain else 0.0)
        return max(widths, default=0.0) + 1.4 * value.height(), height + 0.5 * small.height()

    def _left(self) -> float:
        value, _ = self._fonts()
        return QFontMetricsF(value).horizontalAdvance(self._state.symbol + "  ")

    def sizeHint(self) -> QSize:
        width, height = self._pitch()
        small = QFontMetricsF(self.font())
        rows = len(self._state.cells)
        columns = len(self._state.cells[0]) if rows else 0
        words = small.horizontalAdvance(self._state.equation)
        head = small.height() if self._state.columns else 0.0
        foot = small.height() * 1.2 if self._state.unit else 0.0
        return QSize(
            round(self._left() + columns * width + 2 * small.height() + words),
            round(rows * height + head + foot + 6),
        )

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy) and self._state.cells:
            rows = tuple(tuple(value for value, _ in row) for row in self._state.cells)
            columns = self._state.columns or tuple("" for _ in rows[0])
            table = TableState("", "", columns, rows, words=0)
            text = table_text(table)
            # The header is a line of nothing where the columns have no names.
            QGuiApplication.clipboard().setText(
                text if self._state.columns else text.split("\n", 1)[1]
            )
            return
        super().keyPressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if not self._state.cells:
            return
        theme = current_theme()
        value_font, small_font = self._fonts()
        small = QFontMetricsF(small_font)
        width, height = self._pitch()
        columns = len(self._state.cells[0])
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        top = 3.0 + (small.height() if self._state.columns else 0.0)
        inner = QRectF(self._left(), top, columns * width, len(self._state.cells) * height)
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.setFont(small_font)
        painter.setPen(QColor(theme.muted))
        for column, name in enumerate(self._state.columns):
            place = QRectF(inner.left() + column * width, 0, width, top)
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, shown(name))
        painter.drawText(
            QRectF(inner.right() + small.height(), inner.top(), self.width(), inner.height()),
            Qt.AlignmentFlag.AlignLeft | middle,
            shown(self._state.equation),
        )
        painter.drawText(
            QRectF(inner.left(), inner.bottom() + 2, inner.width(), 1.2 * small.height()),
            Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop,
            shown(self._state.unit),
        )
        painter.setFont(value_font)
        painter.setPen(QColor(theme.text))
        painter.drawText(
            QRectF(0, inner.top(), inner.left(), inner.height()),
            Qt.AlignmentFlag.AlignLeft | middle,
            self._state.symbol,
        )
        self._brackets(painter, inner.adjusted(0, 1, 0, -1))
        for row, cells in enumerate(self._state.cells):
            for column, (text, u) in enumerate(cells):
                cell = QRectF(
                    inner.left() + column * width, inner.top() + row * height, width, height
                )
                self._cell(painter, cell, text, u)
        if self.hasFocus():
            painter.setPen(QPen(QColor(theme.accent), 1, Qt.PenStyle.DotLine))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()

    def _brackets(self, painter: QPainter, inner: QRectF) -> None:
        painter.setPen(QPen(QColor(current_theme().text), 1.4))
        lip = 5.0
        for x, way in ((inner.left(), lip), (inner.right(), -lip)):
            painter.drawPolyline(
                [
                    QPointF(x + way, inner.top()),
                    QPointF(x, inner.top()),
                    QPointF(x, inner.bottom()),
                    QPointF(x + way, inner.bottom()),
                ]
            )

    def _cell(self, painter: QPainter, cell: QRectF, text: str, u: str) -> None:
        theme = current_theme()
        value_font, small_font = self._fonts()
        high = QFontMetricsF(value_font).height()
        low = QFontMetricsF(small_font).height() * 0.95 if u else 0.0
        top = cell.center().y() - (high + low) / 2
        painter.setFont(value_font)
        painter.setPen(QColor(theme.text))
        painter.drawText(
            QRectF(cell.left(), top, cell.width(), high),
            Qt.AlignmentFlag.AlignCenter,
            shown_number(text),
        )
        if u:
            painter.setFont(small_font)
            painter.setPen(QColor(theme.muted))
            place = QRectF(cell.left(), top + high, cell.width(), low)
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, f"± {shown_number(u)}")
