"""Tables as text for the clipboard and for spreadsheets."""

import csv
import io

from gui.widgets.number_text import MINUS
from gui.widgets.states import TableState

_SPACES = str.maketrans(
    "", "", "\N{NARROW NO-BREAK SPACE}\N{FIGURE SPACE}\N{PUNCTUATION SPACE}\N{THIN SPACE}"
)


def table_text(table: TableState, *, separator: str = "\t", decimal: str = ".") -> str:
    """Return header and rows as separated values.

    Parameters
    ----------
    separator : a tab for the clipboard; ``","``, or ``";"`` where the decimal mark is a comma
    decimal : decimal mark of the numbers
    """
    out = io.StringIO()
    writer = csv.writer(out, delimiter=separator, lineterminator="\n")
    writer.writerow(table.header)
    for row in table.rows:
        writer.writerow(
            [
                text if column < table.words else number_cell(text, decimal)
                for column, text in enumerate(row)
            ]
        )
    return out.getvalue()


def number_cell(text: str, decimal: str = ".") -> str:
    """Return a number as spreadsheets read it: plain minus, no thin spaces, their decimal mark.

    Text that is no number, such as a dash or ``1.2 ± 0.3``, keeps its words.
    """
    plain = text.replace(MINUS, "-").translate(_SPACES)
    try:
        float(plain)
    except ValueError:
        return text
    return plain.replace(".", decimal)
