"""Calibrated rates by (3.10), and whether the two files that it needs are of one unit.

(3.10) takes the scale factor from the rate table and the zero from the head. A head file of
another unit, or of another day, puts its whole difference of zeros into every rate: -3.5 deg/s for
the practicum's own Tables 3.2 and 3.3. Name, zero and temperature tell.
"""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FitError, Note, Severity
from core.fit.estimate import Estimate, freedom
from core.model.stimulus import table_axes
from core.procedures.g_sensitivity import GSensor
from core.procedures.rate_table import RateSensor
from core.samples.run import Run

_FAR_C = 2.0
_FAR_CODES = 5.0
_FEWEST = 3


@dataclass(frozen=True, slots=True)
class Pair:
    """What a table run and a head run say about each other.

    Parameters
    ----------
    zero_difference : zero on the table less the one that the head predicts there, outputs
    in_rate : the same in deg/s: what (3.10) puts into every rate
    same_name : whether both runs name the same device
    notes : every reason for doubt
    """

    zero_difference: Estimate
    in_rate: Estimate
    same_name: bool
    notes: tuple[Note, ...]

    @property
    def refused(self) -> bool:
        """Whether the two runs are not to be used together without a word from the operator."""
        return any(note.severity is Severity.ERROR for note in self.notes)


@dataclass(frozen=True, slots=True, eq=False)
class Table37:
    """Table 3.7: set rates, calibrated rates by (3.10) and their errors, deg/s.

    Parameters
    ----------
    set_rate, measured, error : (n,)
    pair : whether the two runs belong together
    """

    set_rate: FloatArray
    measured: FloatArray
    error: FloatArray
    pair: Pair


def compare_runs(table: Run, on_table: RateSensor, head: Run, on_head: GSensor) -> Pair:
    """Compare names, zeros and temperatures of a table run and a head run.

    Parameters
    ----------
    table, on_table : the table run, one sensor fitted from it
    head, on_head : the head run, the same sensor fitted from it alone
    """
    predicted, u_predicted, dof = _zero_on_table(table, on_table, on_head)
    zero, k = on_table.line.zero, on_table.line.slope
    parts = (zero.u, u_predicted)
    difference = Estimate(
        zero.value - predicted,
        float(np.hypot(*parts)),
        freedom(parts, (zero.dof, dof)),
        zero.unit,
    )
    in_rate = difference.scaled(1.0 / k.value, "deg/s")
    same = table.device.strip() == head.device.strip()
    notes: list[Note] = []
    if not same:
        notes.append(_names(table.device, head.device))
    if difference.significant or not same:
        notes.append(_zeros(on_table.channel, zero, predicted, in_rate, same))
    notes.extend(_temperatures(table, head))
    return Pair(difference, in_rate, same, tuple(notes))


def calibrated_by_3_10(
    table: Run,
    on_table: RateSensor,
    head: Run,
    on_head: GSensor,
    *,
    same_unit: bool = False,
) -> Table37:
    """Return Table 3.7: (U - U0 - b_zz g) / k_z against the set rates.

    Parameters
    ----------
    table, on_table, head, on_head : as `compare_runs`
    same_unit : the operator's word that both runs are of one unit, whatever the names say

    Raises
    ------
    FitError
        The runs name different devices and nobody said that they are one.
    """
    pair = compare_runs(table, on_table, head, on_head)
    if pair.refused and not same_unit:
        raise FitError(" ".join(note.text for note in pair.notes))
    zero = _zero_on_table(table, on_table, on_head)[0]
    measured = (on_table.line.output - zero) / on_table.line.slope.value
    return Table37(
        set_rate=on_table.line.set_rate,
        measured=frozen(measured),
        error=frozen(measured - on_table.line.set_rate),
        pair=pair,
    )


def _zero_on_table(
    table: Run, on_table: RateSensor, on_head: GSensor
) -> tuple[float, float, float]:
    """Zero on the table as the head predicts it, its uncertainty and freedom."""
    up = table_axes(table)[on_table.line.rows[0]]
    fit = on_head.fit
    weight = np.zeros(len(fit.values))
    weight[fit.index("bias")] = 1.0
    for axis in on_head.axes:
        weight[fit.index(f"g_sensitivity_{axis}")] = up["xyz".index(axis)] * on_head.g_mps2
    u = float(np.sqrt(weight @ fit.covariance @ weight))
    return float(weight @ fit.values), u, float(fit.t_dof.min())


def _names(table: str, head: str) -> Note:
    return Note(
        Severity.ERROR,
        "different_units",
        f"the table file is of {table!r}, the head file of {head!r}: scale factor and zero of two"
        " units do not belong together.",
    )


def _zeros(channel: str, zero: Estimate, predicted: float, in_rate: Estimate, same: bool) -> Note:
    why = "; another day, another temperature, or another unit?" if same else "."
    return Note(
        Severity.WARNING,
        "zero_differs",
        f"{channel}: the zero is {zero.value:.2f} {zero.unit} on the table, while the head lets"
        f" expect {predicted:.2f}; (3.10) puts {in_rate.value:+.3g} deg/s into every rate{why}",
    )


def _temperatures(table: Run, head: Run) -> list[Note]:
    warm, cold = _known(table.temperature_c), _known(head.temperature_c)
    if warm.size and cold.size and abs(warm.mean() - cold.mean()) > _FAR_C:
        text = (
            f"the table run was at {warm.mean():.1f} degC, the head run at {cold.mean():.1f} degC:"
            " the zero moves with temperature."
        )
        return [Note(Severity.WARNING, "temperature_differs", text)]
    notes: list[Note] = []
    for name in sorted(table.extra.keys() & head.extra.keys()):
        if name.startswith("temp"):
            notes.extend(_codes(name, table.extra[name], head.extra[name]))
    return notes


def _codes(name: str, table: FloatArray, head: FloatArray) -> list[Note]:
    """Temperatures that are still codes: copied, or far apart for their own scatter."""
    n = min(len(table), len(head))
    if n >= _FEWEST and np.array_equal(table[:n], head[:n]) and np.ptp(table[:n]) > 0:
        text = (
            f"{name}: the first {n} temperatures of the two files are the same digit for digit; one"
            " of them was copied, so they cannot tell whether the runs were alike."
        )
        return [Note(Severity.WARNING, "temperature_copied", text)]
    apart = float(head.mean() - table.mean())
    if abs(apart) > _FAR_CODES * max(float(table.std()), float(head.std()), 1.0):
        text = (
            f"{name}: the head run was {apart:+.0f} codes from the table run: the zero moves with"
            " temperature."
        )
        return [Note(Severity.WARNING, "temperature_differs", text)]
    return []


def _known(values: FloatArray) -> FloatArray:
    return values[np.isfinite(values)]
