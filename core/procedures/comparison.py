"""Gyros side by side: the table of lab 6, with uncertainties, and who differs from whom.

Random walk and bias instability come from the Allan analysis; where it was not made their cells
stay empty, and say so.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from core.errors import FitError
from core.fit.estimate import Estimate
from core.procedures.g_sensitivity import GSensor
from core.procedures.rate_table import RateSensor

NOT_MEASURED = "not measured"
ROWS: tuple[tuple[str, str, str], ...] = (
    ("scale_factor", "Scale factor", "code/(deg/s)"),
    ("nonlinearity", "Nonlinearity", "ppm"),
    ("asymmetry", "Scale factor asymmetry", "ppm"),
    ("bias", "Bias", "deg/s"),
    ("g_sensitivity", "Acceleration-sensitive drift, largest axis", "(deg/s)/(m/s^2)"),
    ("random_walk", "Angle random walk", "deg/s/sqrt(Hz)"),
    ("bias_instability", "Bias instability", "deg/s"),
)
"""Rows: identifier, name, unit; the unit of the scale factor is that of the outputs."""


@dataclass(frozen=True, slots=True)
class Gyro:
    """What is known of one gyro.

    Parameters
    ----------
    name : type, maker, serial number: the heading of its column
    rate : its results on the rate table, None if there are none
    head : its results on the dividing head
    random_walk, bias_instability : of its Allan analysis, deg/s/sqrt(Hz) and deg/s
    """

    name: str
    rate: RateSensor | None = None
    head: GSensor | None = None
    random_walk: Estimate | None = None
    bias_instability: Estimate | None = None

    def quantity(self, row: str) -> Estimate | None:
        """The estimate that stands in a row of the table; None where it was not measured."""
        rate = self.rate
        match row:
            case "scale_factor":
                return rate.line.slope if rate else self.head.scale_factor if self.head else None
            case "nonlinearity":
                return rate.nonlinearity.ppm if rate else None
            case "asymmetry":
                return rate.slopes[2] if rate and rate.slopes else None
            case "bias":
                return _bias(self)
            case "g_sensitivity":
                return _largest_g_sensitivity(self.head)
            case "random_walk":
                return self.random_walk
            case "bias_instability":
                return self.bias_instability
            case _:
                raise KeyError(row)


@dataclass(frozen=True, slots=True)
class Row:
    """One quantity of all gyros.

    Parameters
    ----------
    id, name, unit : of the quantity; the unit of a cell stands in its estimate
    cells : (c,) estimates, None where it was not measured
    best : column with the smallest size, -1 where fewer than two are comparable, or where small is
        not better
    """

    id: str
    name: str
    unit: str
    cells: tuple[Estimate | None, ...]
    best: int


@dataclass(frozen=True, slots=True)
class Comparison:
    """The table.

    Parameters
    ----------
    columns : (c,) names of the gyros
    rows : the quantities
    """

    columns: tuple[str, ...]
    rows: tuple[Row, ...]

    def texts(self) -> list[list[str]]:
        """Cells as text with expanded uncertainty (95 %): heading, then one list a row."""
        heading = ["", *self.columns]
        return [heading, *([title_of(row), *map(_text, row.cells)] for row in self.rows)]


@dataclass(frozen=True, slots=True)
class Column:
    """What is known of one unit, from whatever source.

    Parameters
    ----------
    name : heading
    quantities : estimates by the identifiers of `ROWS`
    """

    name: str
    quantities: Mapping[str, Estimate]


def compare_gyros(gyros: Sequence[Gyro]) -> Comparison:
    """Put gyros side by side.

    Raises
    ------
    FitError
        There is none, or two have the same name.
    """
    columns: list[Column] = []
    for gyro in gyros:
        found = {row: gyro.quantity(row) for row, _, _ in ROWS}
        columns.append(Column(gyro.name, {row: q for row, q in found.items() if q is not None}))
    return compare_columns(columns)


def compare_columns(columns: Sequence[Column]) -> Comparison:
    """Put units side by side.

    Raises
    ------
    FitError
        There is none, or two have the same name.
    """
    names = tuple(column.name for column in columns)
    if not names:
        raise FitError("no gyro was chosen for the comparison")
    if len(set(names)) < len(names):
        raise FitError(f"two gyros have the same name ({', '.join(names)}); tell them apart")
    rows: list[Row] = []
    for identifier, name, unit in ROWS:
        cells = tuple(column.quantities.get(identifier) for column in columns)
        rows.append(Row(identifier, name, unit, cells, _best(identifier, cells)))
    return Comparison(names, tuple(rows))


def difference(one: Estimate, other: Estimate) -> float:
    """Difference of two independent estimates over its standard uncertainty (E_n times two).

    Raises
    ------
    FitError
        They are in different units.
    """
    if one.unit != other.unit:
        raise FitError(f"{one.unit} and {other.unit} cannot be compared")
    return abs(one.value - other.value) / (one.u**2 + other.u**2) ** 0.5


def _bias(gyro: Gyro) -> Estimate | None:
    if gyro.rate is not None:
        return gyro.rate.bias
    if gyro.head is not None and gyro.head.scale_factor is not None:
        return gyro.head.bias
    return None


def _largest_g_sensitivity(head: GSensor | None) -> Estimate | None:
    if head is None or head.scale_factor is None:
        return None
    return max((head.b_dps(axis) for axis in head.axes), key=lambda one: abs(one.value))


def _best(row: str, cells: tuple[Estimate | None, ...]) -> int:
    sizes = {place: abs(cell.value) for place, cell in enumerate(cells) if cell is not None}
    units = {cell.unit for cell in cells if cell is not None}
    if row == "scale_factor" or len(sizes) < 2 or len(units) > 1:
        return -1
    return min(sizes, key=lambda place: sizes[place])


def title_of(row: Row) -> str:
    """Name of a row with the unit that its cells are in."""
    units = sorted({cell.unit for cell in row.cells if cell is not None}) or [row.unit]
    return f"{row.name}, {' or '.join(units)}"


def _text(cell: Estimate | None) -> str:
    if cell is None:
        return NOT_MEASURED
    half = cell.expanded()
    if not 0 < half < float("inf"):
        return f"{cell.value:.6g} (no uncertainty)"
    return f"{cell.value:.6g} +- {half:.2g}"
