"""Faults of the data of a run of accumulated rows, stated as facts."""

import numpy as np

from core.discrepancy.record_facts import Fact
from core.discrepancy.result import Fitted
from core.samples.run import Run

_FEWEST, _SHORTEST_S = 16, 300.0
_TYPED_DEGC = 0.5
_CHANCE = 1e-6


def row_facts(run: Run) -> tuple[Fact, ...]:
    """All faults of the data of a run."""
    return tuple(fact for fact in (_stale(run),) if fact is not None)


def _stale(run: Run) -> Fact | None:
    """A temperature that never changes by its last digit while the rows were measured.

    Whole and half degrees are taken as typed by hand, which says that nobody measured, no fault.
    """
    values, t = run.temperature_c, run.t_s
    if len(values) < _FEWEST or not np.all(np.isfinite(values)) or np.ptp(values) != 0.0:
        return None
    if not np.all(np.isfinite(t)) or np.ptp(t) < _SHORTEST_S or values[0] % _TYPED_DEGC == 0.0:
        return None
    minutes = float(np.ptp(t)) / 60.0
    return Fact(
        "stale_temperature",
        f"all {len(values)} rows of {minutes:.0f} min have the same temperature to the last digit,"
        f" {values[0]:g} degC: it does not come from the thermometer of the unit; effects of"
        " temperature cannot be judged",
        (
            Fitted("rows", float(len(values)), np.nan, ""),
            Fitted("temperature", float(values[0]), np.nan, "degC"),
        ),
        _CHANCE,
        np.zeros(0, dtype=np.int64),
    )
