"""One candidate: its picture, its name, its numbers, and how strong the evidence is."""

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QVBoxLayout, QWidget

from gui.discrepancy.cause_view import paint_cause
from gui.discrepancy.state import CandidateRow, NextCard, ProposalCard
from gui.languages.shown import shown
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class CandidateView(QWidget):
    """A candidate that a click, or Enter, makes the chosen one."""

    chosen = Signal(str)

    def __init__(self, row: CandidateRow, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._row = row
        self._chosen = False
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(row.name)
        self.setAccessibleDescription(shown(f"{row.value}; {row.evidence}; {row.gap_after}"))
        self.setToolTip(shown(f"{row.name}\n{row.value}\n{row.evidence}, {row.gap_after}"))

    @property
    def key(self) -> str:
        """Identifier of the effect."""
        return self._row.key

    def mark(self, chosen: bool) -> None:
        """Show whether this is the chosen one."""
        if chosen != self._chosen:
            self._chosen = chosen
            self.update()

    def sizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(18 * unit, round((4.9 if self._row.value else 3.9) * unit))

    def minimumSizeHint(self) -> QSize:
        return QSize(12 * self.fontMetrics().height(), self.sizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        unit = self.fontMetrics().height()
        frame = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        focus = self._chosen or self.hasFocus()
        painter.setPen(QPen(QColor(theme.accent if focus else theme.line), 2 if focus else 1))
        painter.setBrush(QColor(theme.base))
        painter.drawRoundedRect(frame, 4, 4)
        side = 2.7 * unit
        picture = QRectF(0.5 * unit, 0.5 * unit, 1.3 * side, side)
        paint_cause(painter, picture, self._row.key)
        left = picture.right() + 0.6 * unit
        width = self.width() - left - 0.6 * unit
        font = self.font()
        font.setBold(True)
        painter.setFont(font)
        self._line(painter, left, 0.4 * unit, width, self._row.name, theme.text)
        painter.setFont(self.font())
        top = 1.5 * unit
        if self._row.value:
            self._line(painter, left, top, width, self._row.value, theme.text)
            top += 1.15 * unit
        bar = QRectF(left, top + 0.15 * unit, width, 0.55 * unit)
        painter.fillRect(bar, QColor(theme.grid))
        painter.fillRect(
            QRectF(bar.left(), bar.top(), bar.width() * self._row.share, bar.height()),
            QColor(theme.accent),
        )
        words = f"{shown(self._row.evidence)} · {shown(self._row.gap_after)}"
        self._line(painter, left, top + 0.85 * unit, width, words, theme.muted)
        painter.end()

    def _line(
        self, painter: QPainter, left: float, top: float, width: float, text: str, colour: str
    ) -> None:
        painter.setPen(QColor(colour))
        short = painter.fontMetrics().elidedText(
            shown(text), Qt.TextElideMode.ElideRight, int(width)
        )
        box = QRectF(left, top, width, 1.2 * self.fontMetrics().height())
        painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, short)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.chosen.emit(self._row.key)
            event.accept()
            return
        super().mousePressEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.chosen.emit(self._row.key)
            return
        super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.update()


class ProposalView(QFrame):
    """A card with all names that compete for one step."""

    chosen = Signal(str)

    def __init__(self, card: ProposalCard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        self.candidates: list[CandidateView] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, unit // 3, 0, unit // 3)
        column.setSpacing(unit // 3)
        title = WordLabel(card.title)
        font = title.font()
        font.setBold(True)
        title.setFont(font)
        title.setWordWrap(True)
        column.addWidget(title)
        if len(card.tied) > 1 or card.same:
            self.setFrameShape(QFrame.Shape.StyledPanel)
            column.setContentsMargins(unit // 2, unit // 2, unit // 2, unit // 2)
        for row in card.tied:
            column.addWidget(self._view(row))
        if card.same:
            same = WordLabel(card.same)
            same.setWordWrap(True)
            column.addWidget(same)
        if card.others:
            if card.tied:
                label = QLabel(self.tr("Less likely"))
                label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
                column.addWidget(label)
            for row in card.others:
                column.addWidget(self._view(row))

    def _view(self, row: CandidateRow) -> CandidateView:
        view = CandidateView(row)
        view.chosen.connect(self.chosen)
        self.candidates.append(view)
        return view


class ChanceBar(QWidget):
    """The chance that a measurement decides."""

    def __init__(self, card: NextCard, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._chance = card.chance
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        unit = self.fontMetrics().height()
        return QSize(12 * unit, round(1.2 * unit))

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        theme = current_theme()
        painter = QPainter(self)
        unit = self.fontMetrics().height()
        words = self.tr("{chance} % to decide").format(chance=round(100 * self._chance))
        room = self.width() - self.fontMetrics().horizontalAdvance(words) - unit
        bar = QRectF(0, 0.3 * unit, room, 0.6 * unit)
        painter.fillRect(bar, QColor(theme.grid))
        painter.fillRect(
            QRectF(0, bar.top(), room * self._chance, bar.height()), QColor(theme.accent)
        )
        painter.setPen(QColor(theme.text))
        painter.drawText(QPointF(room + 0.6 * unit, 0.95 * unit), words)
        painter.end()
