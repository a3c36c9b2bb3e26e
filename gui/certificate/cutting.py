"""Where a text may be cut by the end of a page: between lines, and between rows of its tables."""

from dataclasses import dataclass

from PySide6.QtGui import QTextBlock, QTextCursor, QTextDocument, QTextTable

_ROWS = 2
"""No fewer rows than these stand alone before a cut or after it."""


@dataclass(frozen=True, slots=True)
class TableCuts:
    """Where the rows of one table meet.

    Parameters
    ----------
    header : top and bottom of its header; equal where it has none
    rows : between its rows, from above
    bottom : its end
    """

    header: tuple[float, float]
    rows: tuple[float, ...]
    bottom: float


@dataclass(frozen=True, slots=True)
class Cuts:
    """Where a text may be cut.

    Parameters
    ----------
    places : from above
    tables : whose headers are repeated where they go on
    """

    places: tuple[float, ...]
    tables: tuple[TableCuts, ...]

    def last_before(self, begin: float, end: float) -> float | None:
        """The last place after `begin` and not after `end`; None for none."""
        return max((y for y in self.places if begin < y <= end), default=None)

    def header(self, begin: float) -> tuple[float, float] | None:
        """The header to be repeated over a piece that begins here; None for none."""
        for table in self.tables:
            if begin in table.rows and table.header[1] > table.header[0]:
                return table.header
        return None


def cuts_of(section: QTextDocument) -> Cuts:
    """Find the places of a text that is laid out."""
    layout = section.documentLayout()
    tables: list[TableCuts] = []
    places: list[float] = []
    for frame in section.rootFrame().childFrames():
        if isinstance(frame, QTextTable) and frame.rows() > 2 * _ROWS:
            edges = _edges(section, frame)
            head = frame.format().toTableFormat().headerRowCount()
            box = layout.frameBoundingRect(frame)
            rows = tuple(edges[head + _ROWS : len(edges) - _ROWS + 1])
            header = (edges[0], edges[head]) if head else (edges[0], edges[0])
            tables.append(TableCuts(header, rows, box.bottom()))
            places += rows
    block = section.begin()
    while block.isValid():
        if QTextCursor(block).currentTable() is None:
            places += _lines(section, block)
        block = block.next()
    return Cuts(tuple(sorted(places)), tuple(tables))


def _edges(section: QTextDocument, table: QTextTable) -> list[float]:
    """Tops of the rows: midway between the text of a row and that of the row before."""
    layout = section.documentLayout()
    padding = table.format().toTableFormat().cellPadding()
    return [
        min(
            layout.blockBoundingRect(table.cellAt(row, column).firstCursorPosition().block()).top()
            for column in range(table.columns())
        )
        - padding
        - 0.5
        for row in range(table.rows())
    ]


def _lines(section: QTextDocument, block: QTextBlock) -> list[float]:
    """Tops of the lines of a paragraph but the first: it stays with what is above it."""
    top = section.documentLayout().blockBoundingRect(block).top()
    lines = block.layout()
    return [top + lines.lineAt(number).y() for number in range(1, lines.lineCount())]
