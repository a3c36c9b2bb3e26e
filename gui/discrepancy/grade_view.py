"""What a plan can show, effect by effect, as a list of lights."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from gui.discrepancy.state import LightRow
from gui.languages.shown import shown
from gui.widgets.icons import paint_tone
from gui.widgets.states import Tone
from gui.widgets.theme import current_theme
from gui.widgets.word_label import WordLabel


class Light(QWidget):
    """The sign of a tone in the look of the window."""

    def __init__(self, tone: Tone, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tone = tone
        unit = self.fontMetrics().height()
        self.setFixedSize(unit + 2, unit + 2)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002
        painter = QPainter(self)
        area = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        paint_tone(painter, area, self._tone, current_theme().tones[self._tone])
        painter.end()


class GradeView(QWidget):
    """One line an effect: light, name, from which size on."""

    def __init__(self, rows: tuple[LightRow, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        unit = self.fontMetrics().height()
        grid = self._grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, unit // 2)
        grid.setHorizontalSpacing(unit // 2)
        grid.setVerticalSpacing(unit // 4)
        grid.setColumnStretch(1, 1)
        for place, row in enumerate(rows):
            title, detail = WordLabel(row.title), WordLabel(row.detail)
            detail.setForegroundRole(detail.palette().ColorRole.PlaceholderText)
            for label in (title, detail):
                label.setWordWrap(True)
                label.setTextFormat(Qt.TextFormat.PlainText)
            light = Light(row.tone)
            light.setAccessibleName(f"{shown(row.title)}: {shown(row.detail)}")
            grid.addWidget(light, 2 * place, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(title, 2 * place, 1)
            grid.addWidget(detail, 2 * place + 1, 1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # A page that scrolls asks no widget how high it is at its width.
        self.setMinimumHeight(self._grid.heightForWidth(event.size().width()))
