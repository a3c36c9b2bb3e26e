"""Sections of HTML on paper: A4, with number and page on every sheet (ISO/IEC 17025, 7.8.2.1 d)."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QBuffer, QCoreApplication, QIODevice, QMarginsF, QRectF, Qt
from PySide6.QtGui import QFont, QPageLayout, QPageSize, QPainter, QPdfWriter, QTextDocument
from PySide6.QtWidgets import QApplication

from core.records.atomic import write_bytes_atomic
from core.version import SOFTWARE
from gui.certificate.cutting import Cuts, cuts_of
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
MARGIN = _MARGIN_MM * _DPI / _MM_PER_INCH
"""White border of a sheet, dots of the layout."""
_KEPT_WHOLE = 0.25
"""A section up to this part of a page goes to the next one rather than being cut."""


@dataclass(frozen=True, slots=True)
class Piece:
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


def application_for_paper() -> QCoreApplication:
    """What Qt needs before anything is drawn, where there is no window; keep it while drawing."""
    return QApplication.instance() or QApplication(["calrig"])


class Paper:
    """Sections laid out in pages; a long one is cut between lines or rows, its header repeated.

    Parameters
    ----------
    sections : HTML with its pictures inside
    foot : stands at the bottom of every page, before the page's number
    before : a paper of the same thread whose sections need not be laid out again
    """

    def __init__(self, sections: tuple[str, ...], foot: str, before: "Paper | None" = None) -> None:
        self.foot = foot
        known = {} if before is None else before.sections
        self.sections: dict[str, QTextDocument] = {}
        inside = _A4.paintRect(QPageLayout.Unit.Millimeter).size() * (_DPI / _MM_PER_INCH)
        self.width, self.height = inside.width(), inside.height()
        self.pages: list[list[Piece]] = [[]]
        self._room = self.height - _FOOT
        self._top = 0.0
        for html in sections:
            section = self.sections[html] = known.get(html) or self._laid_out(html)
            self._place(section)

    def _place(self, section: QTextDocument) -> None:
        height = section.size().height()
        cuts: Cuts | None = None
        if self._top + height > self._room:
            if self._top and height <= _KEPT_WHOLE * self._room:
                self._new_page()
            else:
                cuts = cuts_of(section)
        begin = 0.0
        while cuts is not None:
            head = cuts.header(begin)
            free = self._room - self._top - (0.0 if head is None else head[1] - head[0])
            if height - begin <= free:
                break
            end = cuts.last_before(begin, begin + free)
            if end is None and self._top:
                self._new_page()
                continue
            self._put(section, cuts, (begin, begin + free if end is None else end))
            begin = begin + free if end is None else end
            self._new_page()
        self._put(section, cuts, (begin, height))
        self._top += _GAP

    def _put(self, section: QTextDocument, cuts: Cuts | None, source: tuple[float, float]) -> None:
        """Put a piece below what is there, under the header of the table that it goes on with."""
        head = None if cuts is None else cuts.header(source[0])
        for one in (head, source):
            if one is not None:
                self.pages[-1].append(Piece(section, one, self._top))
                self._top += one[1] - one[0]

    def _new_page(self) -> None:
        self.pages.append([])
        self._top = 0.0

    def draw(self, painter: QPainter, number: int) -> None:
        """Draw a page in dots of 1/96 inch, the corner inside its margins at the origin."""
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
        writer.setCreator(SOFTWARE)
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
