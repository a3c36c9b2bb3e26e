"""The pages as they will be printed: one at a time, whole or as near as wanted."""

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QKeySequence, QPainter, QPaintEvent, QResizeEvent, QShortcut
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from gui.certificate.pdf import MARGIN, Paper
from gui.widgets.fields import ChoiceField
from gui.widgets.theme import current_theme

_SCALES = (0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0)
_WIDTH, _PAGE = "width", "page"
_BORDER = 12


class PreviewView(QWidget):
    """Shows a `Paper`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sheet = SheetView()
        self.area = QScrollArea()
        self.area.setWidget(self.sheet)
        self.area.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.back, self.on = QToolButton(), QToolButton()
        self.place = QLabel()
        self.zoom = ChoiceField()
        self.zoom.activated.connect(self._fit)
        self.back.setText("◀")
        self.on.setText("▶")
        self.back.clicked.connect(self._on_back)
        self.on.clicked.connect(self._on_on)
        for key, step in ((Qt.Key.Key_PageUp, self._on_back), (Qt.Key.Key_PageDown, self._on_on)):
            QShortcut(QKeySequence(key), self).activated.connect(step)
        bar = QHBoxLayout()
        bar.addWidget(self.back)
        bar.addWidget(self.place)
        bar.addWidget(self.on)
        bar.addStretch(1)
        bar.addWidget(self.zoom)
        column = QVBoxLayout(self)
        column.addLayout(bar)
        column.addWidget(self.area, 1)
        self._retranslate()

    def render_paper(self, paper: Paper | None) -> None:
        """Show other pages; the place stays where it was, as far as there are so many."""
        count = 0 if paper is None else len(paper.pages)
        self.sheet.show_paper(paper, max(0, min(self.sheet.number, count - 1)))
        self._tell()
        self._fit()

    def go(self, number: int) -> None:
        """Show a page; there is no other before the first and after the last."""
        paper = self.sheet.paper
        if paper is not None and 0 <= number < len(paper.pages):
            self.sheet.show_paper(paper, number)
            self.area.verticalScrollBar().setValue(0)
            self._tell()

    def _on_back(self) -> None:
        self.go(self.sheet.number - 1)

    def _on_on(self) -> None:
        self.go(self.sheet.number + 1)

    def _tell(self) -> None:
        paper, number = self.sheet.paper, self.sheet.number
        count = 0 if paper is None else len(paper.pages)
        words = self.tr("Page {number} of {count}").format(number=number + 1, count=count)
        self.place.setText(words if count else "")
        self.back.setEnabled(number > 0)
        self.on.setEnabled(number + 1 < count)
        self.sheet.setAccessibleName(words)

    def _fit(self) -> None:
        chosen = self.zoom.currentData()
        bar = self.area.verticalScrollBar().sizeHint().width()
        room = self.area.contentsRect().size()
        fitted = chosen in (_WIDTH, _PAGE)
        off, needed = Qt.ScrollBarPolicy.ScrollBarAlwaysOff, Qt.ScrollBarPolicy.ScrollBarAsNeeded
        self.area.setHorizontalScrollBarPolicy(off if fitted else needed)
        if chosen == _WIDTH:
            scale = self.sheet.scale_for(QSize(room.width() - bar, 0))
        elif chosen == _PAGE:
            scale = self.sheet.scale_for(room)
        else:
            scale = float(chosen)
        self.sheet.set_scale(scale)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._retranslate()

    def _retranslate(self) -> None:
        chosen = max(0, self.zoom.currentIndex())
        self.zoom.clear()
        self.zoom.addItem(self.tr("Fit width"), _WIDTH)
        self.zoom.addItem(self.tr("Whole page"), _PAGE)
        for scale in _SCALES:
            self.zoom.addItem(f"{100 * scale:.0f} %", scale)
        self.zoom.setCurrentIndex(chosen)
        self.zoom.setAccessibleName(self.tr("Size of the page"))
        self.back.setToolTip(self.tr("Page before (Page Up)"))
        self.on.setToolTip(self.tr("Page after (Page Down)"))
        for button in (self.back, self.on):
            button.setAccessibleName(button.toolTip())
        self._tell()


class SheetView(QWidget):
    """One page on its sheet."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.paper: Paper | None = None
        self.number = 0
        self._scale = 1.0

    def show_paper(self, paper: Paper | None, number: int) -> None:
        """Show a page of a paper."""
        self.paper, self.number = paper, number
        self.update()

    def scale_for(self, room: QSize) -> float:
        """Scale at which the sheet fits; a height of 0 does not count."""
        sheet = self._sheet()
        across = (room.width() - 2 * _BORDER) / sheet.width()
        down = (room.height() - 2 * _BORDER) / sheet.height() if room.height() else across
        return max(0.1, min(across, down))

    def set_scale(self, scale: float) -> None:
        """Show it so many times as large as 96 dots an inch."""
        self._scale = scale
        sheet = self._sheet()
        self.setFixedSize(
            QSize(
                int(scale * sheet.width()) + 2 * _BORDER, int(scale * sheet.height()) + 2 * _BORDER
            )
        )
        self.update()

    def _sheet(self) -> QRectF:
        paper = self.paper
        width, height = (658.0, 986.0) if paper is None else (paper.width, paper.height)
        return QRectF(0.0, 0.0, width + 2 * MARGIN, height + 2 * MARGIN)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        if self.paper is None or self.number >= len(self.paper.pages):
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.translate(_BORDER, _BORDER)
        painter.scale(self._scale, self._scale)
        sheet = self._sheet()
        painter.fillRect(sheet, Qt.GlobalColor.white)
        painter.setPen(QColor(current_theme().line))
        painter.drawRect(sheet)
        painter.translate(QPointF(MARGIN, MARGIN))
        self.paper.draw(painter, self.number)
        painter.end()
