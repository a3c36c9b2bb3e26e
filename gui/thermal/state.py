"""Everything that the Thermal tab shows."""

from dataclasses import dataclass

from core.arrays import FloatArray
from gui.analysis.curves import LineState
from gui.widgets.records_page import RecordsState

FOUND = -1
"""Order of a polynomial: chosen by cross-validation."""
KYIV_G_MPS2 = 9.8106
"""Local gravity of the practicum's laboratory, where no file tells another."""


@dataclass(frozen=True, slots=True)
class Settings:
    """What the operator decides.

    Parameters
    ----------
    bias_order, scale_order : of the polynomials, `FOUND` for the best; a record takes the first
    reference_c : T0; NaN for the temperature of the first rows
    g_mps2 : local gravity where the files state none
    outputs : names of a record's outputs, between commas; empty for all rates, or all forces
    """

    bias_order: int = FOUND
    scale_order: int = FOUND
    reference_c: float = float("nan")
    g_mps2: float = KYIV_G_MPS2
    outputs: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class PointState:
    """Points, with bars from `low` to `high`; without bars both are empty."""

    x: FloatArray
    y: FloatArray
    low: FloatArray
    high: FloatArray
    colour: int
    name: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class PlotState:
    """One plot: a sensor, or an angle.

    Parameters
    ----------
    title : above it, with the number that it shows
    label : of its y axis
    """

    title: str
    label: str
    lines: tuple[LineState, ...]
    points: tuple[PointState, ...]


@dataclass(frozen=True, slots=True, eq=False)
class ThermalState:
    """The tab.

    Parameters
    ----------
    page : list, hint, findings, actions
    settings : as decided
    quantities : what can be plotted, in words
    quantity : which of them is
    plots : one above the other
    """

    page: RecordsState
    settings: Settings
    quantities: tuple[str, ...]
    quantity: int
    plots: tuple[PlotState, ...]
