"""Sections of HTML on paper: A4, with number and page on every sheet (ISO/IEC 17025, 7.8.2.1 d)."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QBuffer, QCoreApplication, QIODevice, QMarginsF, QRectF, Qt
from PySide6.QtGui import QFont, QPageLayout, QPageSize, QPainter, QPdfWriter, QTextDocument

from core.records.atomic import write_bytes_atomic
from gui.certificate.html import STYLE
from gui.widgets.theme import FAMILY

_DPI = 96
"""Of the layout; the writer is twelve times as fine."""
_FINE = 12
_MARGIN_MM = 18.0
_FOOT = 26.0
_GAP = 8.0
_MM_PER_INCH = 25.4
_A4 = QPageLayout(
    QPageSize(QPageSize.PageSizeId.A4),
    QPageLayout.Orientation.Portrait,
    QMarginsF(_MARGIN_MM, _MARGIN_MM, _MARGIN_MM, _MARGIN_MM),
    QPageLayout.Unit.Millimeter,
)


@dataclass(frozen=True, slots=True)
class _Piece:
    """What of a section stands on one page.

    Parameters
    ----------
    section : the laid-out text
    source : top and bottom of what is shown of it
    top : where it stands on the page
    """

    section: QTextDocument
    source: tuple[float, float]
    top: float


class Paper:
    """Sections laid out in pages; a section that fits a page is never cut.

    Parameters
    ----------
    sections : HTML with its pictures inside
    foot : stands at the bottom of every page, before the page's number
    """

    def __init__(self, sections: tuple[str, ...], foot: str) -> None:
        self.foot = foot
        inside = _A4.paintRect(QPageLayout.Unit.Millimeter).size() * (_DPI / _MM_PER_INCH)
        self.width, self.height = inside.width(), inside.height()
        self.pages: list[list[_Piece]] = [[]]
        room, top = self.height - _FOOT, 0.0
        for html in sections:
            section = self._laid_out(html)
            height = section.size().height()
            if top and top + height > room:
                self.pages.append([])
                top = 0.0
            begin = 0.0
            while begin + room < height:  # longer than a page
                self.pages[-1].append(_Piece(section, (begin, begin + room), 0.0))
                self.pages.append([])
                begin += room
            self.pages[-1].append(_Piece(section, (begin, height), top))
            top += height - begin + _GAP

    def draw(self, painter: QPainter, number: int) -> None:
        """Draw a page in dots of 1/96 inch, its upper left corner at the origin."""
        for piece in self.pages[number]:
            painter.save()
            begin, end = piece.source
            painter.translate(0.0, piece.top - begin)
            piece.section.drawContents(painter, QRectF(0.0, begin, self.width, end - begin))
            painter.restore()
        font = QFont(FAMILY)
        font.setPixelSize(10)
        painter.setFont(font)
        painter.setPen(Qt.GlobalColor.darkGray)
        below = QRectF(0, self.height - _FOOT, self.width, _FOOT)
        painter.drawText(
            below, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom, self.foot
        )
        words = QCoreApplication.translate("Certificate", "Page {number} of {count}").format(
            number=number + 1, count=len(self.pages)
        )
        painter.drawText(below, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom, words)

    def save(self, path: Path) -> None:
        """Write the pages as PDF.

        Raises
        ------
        StorageError
            The file could not be written; an older one is left as it was.
        """
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        writer = QPdfWriter(buffer)
        writer.setTitle(self.foot)
        writer.setResolution(_DPI * _FINE)
        writer.setPageLayout(_A4)
        painter = QPainter(writer)
        painter.scale(_FINE, _FINE)
        try:
            for number in range(len(self.pages)):
                if number:
                    writer.newPage()
                self.draw(painter, number)
        finally:
            painter.end()
        write_bytes_atomic(path, bytes(buffer.data().data()))

    def _laid_out(self, html: str) -> QTextDocument:
        section = QTextDocument()
        font = QFont(FAMILY)
        font.setPixelSize(12)
        section.setDefaultFont(font)
        section.setDocumentMargin(0)
        # Black whatever the screen wears: the text engine takes the colour of the palette.
        section.setHtml(f"<style>{STYLE}</style><div style='color: #000'>{html}</div>")
        section.setTextWidth(self.width)
        return section
