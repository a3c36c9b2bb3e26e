"""The table of noise coefficients that ``calrig allan`` exports, as quantities.

Of each coefficient the likelihood estimate in its own unit is taken, after the regression where
there was one; one that was not detected is no quantity.
"""

import csv
import io
from collections.abc import Iterator

from core.archive.entry import Quantity
from core.errors import FormatError

HEADER = "device,channel,term,symbol,method,convention,unit,value,u,lower95,upper95,"


def is_noise_file(head: str) -> bool:
    """Whether a text begins as a table of noise coefficients."""
    return head.startswith(HEADER)


def parse_noise(text: str, path: str) -> dict[str, tuple[Quantity, ...]]:
    """Return the quantities of each device.

    Raises
    ------
    FormatError
        A line is damaged.
    """
    found: dict[str, dict[tuple[str, str], tuple[bool, Quantity]]] = {}
    for number, row in _rows(text, path):
        if row["method"] != "likelihood":
            continue
        try:
            value, u = float(row["value"]), float(row["u"])
            limit, regressed = int(row["upper_limit"]), bool(row["regressed"])
        except (KeyError, TypeError, ValueError) as error:
            raise FormatError(path, f"no line of coefficients: {error}", line=number) from error
        key = (row["channel"], row["term"])
        of_device = found.setdefault(row["device"], {})
        # The first convention is the coefficient's own unit; a regressed record is the better one.
        if limit or (key in of_device and of_device[key][0] >= regressed):
            continue
        quantity = Quantity(*key, row["symbol"], row["unit"], value, u)
        of_device[key] = (regressed, quantity)
    return {
        device: tuple(quantity for _, quantity in rows.values()) for device, rows in found.items()
    }


def _rows(text: str, path: str) -> Iterator[tuple[int, dict[str, str]]]:
    """The lines below the head with their numbers."""
    reader = csv.DictReader(io.StringIO(text))
    try:
        yield from enumerate(reader, 2)
    except csv.Error as error:
        raise FormatError(path, f"is no table: {error}", line=reader.line_num) from error
