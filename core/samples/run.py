"""A run: the accumulated rows of one test, in the order of measuring.

Legacy files, run files (``NAME.run.csv``) and sessions all become a `Run`; every procedure and
the finder of discrepancies take one. What a source does not hold is NaN (or an empty text), never
a made-up value.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from core.arrays import FloatArray, IntArray
from core.errors import Note


@dataclass(frozen=True, slots=True)
class Conditions:
    """What the laboratory states about a run; NaN where it states nothing.

    Parameters
    ----------
    g_mps2 : local gravity, m/s^2
    u_g_mps2 : its standard uncertainty
    latitude_deg : geodetic latitude
    accumulation_s : length of one accumulation
    head_u_arcsec : standard uncertainty of one setting of the dividing head
    rate_u_ppm : standard uncertainty of one setting of the rate table, ppm of the rate
    rate_u_dps : the same, absolute part, deg/s
    repeatability : standard deviation between accumulations of the same position beyond their
        own noise (drift, bias instability), input units; NaN where it is unknown and must be
        found from the residuals
    sample_rate_hz : samples per second within an accumulation
    """

    g_mps2: float = np.nan
    u_g_mps2: float = np.nan
    latitude_deg: float = np.nan
    accumulation_s: float = np.nan
    head_u_arcsec: float = np.nan
    rate_u_ppm: float = np.nan
    rate_u_dps: float = np.nan
    repeatability: float = 0.0
    sample_rate_hz: float = np.nan


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """Accumulated means, one row an accumulation.

    Parameters
    ----------
    test : ``"dividing_head"``, ``"static_positions"``, ``"rate_table"``, ``"accuracy"``,
        ``"record"`` or ``"headings"`` (of a level base, `head_deg` clockwise from above)
    sensor : ``"accelerometer"`` or ``"gyro"``
    device : name or serial number
    channels : (c,) names of the outputs
    axes : (c,) case axis of each output, ``"x"``, ``"y"``, ``"z"``; empty where unknown
    unit : unit of `y`
    y, y_se : (n, c) mean output and its standard error
    run : (n,) which pass of the plan
    order : (n,) place in the order of measuring
    mount : (n,) how the unit stood, e.g. ``"X_from"``; empty where it does not matter
    head_deg, set_rate_dps, temperature_c, t_s : (n,) set angle, set rate, temperature, time
    conditions : what the laboratory states
    extra : further columns, (n,) each, kept as they came
    meta : further keys of the source, kept as they came
    notes : doubts that arose when the source was read
    """

    test: str
    sensor: str
    device: str
    channels: tuple[str, ...]
    axes: tuple[str, ...]
    unit: str
    y: FloatArray
    y_se: FloatArray
    run: IntArray
    order: IntArray
    mount: tuple[str, ...]
    head_deg: FloatArray
    set_rate_dps: FloatArray
    temperature_c: FloatArray
    t_s: FloatArray
    conditions: Conditions = Conditions()
    extra: Mapping[str, FloatArray] = field(default_factory=dict[str, FloatArray])
    meta: Mapping[str, str | float | bool] = field(default_factory=dict[str, str | float | bool])
    notes: tuple[Note, ...] = ()

    def __post_init__(self) -> None:
        n, c = self.y.shape
        if len(self.channels) != c or len(self.axes) != c or self.y_se.shape != (n, c):
            raise ValueError(f"{c} outputs, {len(self.channels)} names, {len(self.axes)} axes")
        columns = {
            "run": self.run,
            "order": self.order,
            "mount": self.mount,
            "head_deg": self.head_deg,
            "set_rate_dps": self.set_rate_dps,
            "temperature_c": self.temperature_c,
            "t_s": self.t_s,
            **self.extra,
        }
        for name, column in columns.items():
            if len(column) != n:
                raise ValueError(f"column {name} has {len(column)} rows, y has {n}")

    def __len__(self) -> int:
        return self.y.shape[0]

    def rows(self, chosen: Sequence[int] | IntArray) -> "Run":
        """The run with only these rows, in this order."""
        index: IntArray = np.asarray(chosen, dtype=np.int64)
        return replace(
            self,
            y=self.y[index],
            y_se=self.y_se[index],
            run=self.run[index],
            order=self.order[index],
            mount=tuple(self.mount[int(i)] for i in index),
            head_deg=self.head_deg[index],
            set_rate_dps=self.set_rate_dps[index],
            temperature_c=self.temperature_c[index],
            t_s=self.t_s[index],
            extra={name: column[index] for name, column in self.extra.items()},
        )
