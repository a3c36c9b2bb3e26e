"""The table in 16-bit integers, as a C header with its reference function, as a document."""

import re
from dataclasses import dataclass

import numpy as np

from core.arrays import IntArray, frozen_int
from core.errors import FitError
from core.procedures.calibration import Provenance
from core.procedures.drift.compensate import DriftResult
from core.procedures.drift.table import DriftTable

CENTI = 100
"""Counts in one degC."""
_LARGEST = 32767
_LARGEST_TIME = 65535
_UNITS_MS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
FORMAT = "calrig-drift"
VERSION = 1


@dataclass(frozen=True, slots=True, eq=False)
class IntegerTable:
    """A `DriftTable` as a microcontroller holds it.

    Parameters
    ----------
    lsb : output unit of one count of `values`
    time_unit_ms : ms of one count of `times`
    times : (p,) 0 ... 65535, ascending
    temperatures : (m,) hundredths of a degC, ascending
    values : (m, p) -32767 ... 32767
    """

    lsb: float
    time_unit_ms: int
    times: IntArray
    temperatures: IntArray
    values: IntArray

    def lookup(self, time: int, temperature: int) -> int:
        """The correction in counts, in the integer arithmetic of the C function."""
        i, a, width = _segment(self.times, time)
        j, b, height = _segment(self.temperatures, temperature)
        right = min(i + 1, len(self.times) - 1)
        low, high = (
            int(self.values[row, i]) * (width - a) + int(self.values[row, right]) * a
            for row in (j, min(j + 1, len(self.temperatures) - 1))
        )
        total, whole = low * (height - b) + high * b, width * height
        half = whole // 2
        return (total + half) // whole if total >= 0 else -((half - total) // whole)


def _segment(edges: IntArray, at: int) -> tuple[int, int, int]:
    """Place of the segment's start, distance from it, and its length; held beyond the ends."""
    if len(edges) == 1 or at <= int(edges[0]):
        return 0, 0, 1
    if at >= int(edges[-1]):
        return len(edges) - 1, 0, 1
    place = int(np.searchsorted(edges, at, side="right")) - 1
    return place, at - int(edges[place]), int(edges[place + 1] - edges[place])


def quantised(table: DriftTable) -> IntegerTable:
    """Round a table to 16-bit integers.

    Raises
    ------
    FitError
        Two knots or two temperatures fall on the same count, or a number does not fit.
    """
    unit = next((u for u in _UNITS_MS if table.times_s[-1] * 1e3 / u <= _LARGEST_TIME), 0)
    if not unit:
        raise FitError(f"a horizon of {table.times_s[-1]:g} s does not fit 16 bits")
    largest = float(np.abs(table.values).max())
    lsb = largest / _LARGEST if largest > 0 else 1.0
    times = np.round(table.times_s * 1e3 / unit).astype(np.int64)
    temperatures = np.round(table.temperatures_c * CENTI).astype(np.int64)
    if np.any(np.diff(times) <= 0) or np.any(np.diff(temperatures) <= 0):
        raise FitError("knots or temperatures fall on the same count of the 16-bit table")
    if np.abs(temperatures).max() > _LARGEST:
        raise FitError("temperatures beyond +-327 degC do not fit the 16-bit table")
    values = np.round(table.values / lsb).astype(np.int64)
    return IntegerTable(lsb, unit, frozen_int(times), frozen_int(temperatures), frozen_int(values))


def c_header(table: DriftTable, name: str, provenance: Provenance) -> str:
    """The table and its reference function in C99.

    Parameters
    ----------
    table : what to write
    name : becomes the prefix of every identifier, e.g. ``"gyro_x_drift"``
    provenance : goes into the head comment
    """
    prefix = identifier(name)
    integers = quantised(table)
    guard = f"{prefix.upper()}_H"
    rows = ",\n".join(f"    {{{_list(row)}}}" for row in integers.values)
    return _C.format(
        prefix=prefix,
        upper=prefix.upper(),
        guard=guard,
        device=_comment(provenance.device or "unknown device"),
        software=_comment(provenance.software),
        computed=provenance.computed_utc,
        unit=_comment(table.unit),
        lsb=f"{integers.lsb:.9e}",
        time_unit=integers.time_unit_ms,
        start=f"{table.alignment.start_s:g}",
        stop=f"{table.alignment.stop_s:g}",
        horizon=f"{table.times_s[-1]:g}",
        coldest=f"{table.temperatures_c[0]:.2f}",
        hottest=f"{table.temperatures_c[-1]:.2f}",
        bytes=table.bytes,
        knots=len(integers.times),
        temperatures=len(integers.temperatures),
        times_list=_list(integers.times),
        temperatures_list=_list(integers.temperatures),
        rows=rows,
    )


def identifier(name: str) -> str:
    """A C identifier made of a name."""
    text = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_").lower()
    return text if text[:1].isalpha() else f"drift_{text}".rstrip("_")


def document(result: DriftResult, provenance: Provenance) -> dict[str, object]:
    """The table with all that speaks for it, for JSON."""
    table, integers = result.table, quantised(result.table)
    return {
        "format": FORMAT,
        "version": VERSION,
        "provenance": provenance,
        "unit": table.unit,
        "alignment": table.alignment,
        "times_s": table.times_s,
        "temperatures_c": table.temperatures_c,
        "values": table.values,
        "u": table.u,
        "dof": table.dof,
        "bytes": table.bytes,
        "integers": integers,
        "limit": result.limit,
        "knot_scores": result.knot_scores,
        "methods": [
            {
                "method": one.method,
                "rms": one.rms,
                "by_temperature": one.by_temperature,
                "bytes": one.bytes,
            }
            for one in result.methods
        ],
        "notes": result.notes,
    }


def _list(values: IntArray) -> str:
    return ", ".join(str(value) for value in values.tolist())


def _comment(text: str) -> str:
    return text.replace("*/", "* /").replace("\n", " ")


_C = """\
/* Drift after switching on, to be subtracted from the output of {device}.
 *
 * {software}, {computed}
 * Subtract the mean over {start} ... {stop} s from the output, then {prefix}_correction().
 * Measured from {stop} to {horizon} s and from {coldest} to {hottest} degC (chip, at the start);
 * beyond, the outermost values are held.
 * {bytes} bytes of tables. C99, integers only.
 */
#ifndef {guard}
#define {guard}

#include <stdint.h>

#define {upper}_LSB {lsb} /* {unit} in one count */
#define {upper}_TIME_UNIT_MS {time_unit}
#define {upper}_TIMES {knots}
#define {upper}_TEMPERATURES {temperatures}

/* Time since switching on, counts of {time_unit} ms. */
static const uint16_t {prefix}_time[{upper}_TIMES] = {{{times_list}}};
/* Chip temperature at the start, 0.01 degC. */
static const int16_t {prefix}_temperature[{upper}_TEMPERATURES] = {{{temperatures_list}}};
static const int16_t {prefix}_value[{upper}_TEMPERATURES][{upper}_TIMES] = {{
{rows}
}};

/* Correction in counts of {upper}_LSB.
 * time: since switching on, counts of {time_unit} ms; temperature: at the start, 0.01 degC.
 */
static inline int32_t {prefix}_correction(uint32_t time, int32_t temperature)
{{
    int32_t i = 0, j = 0;
    int64_t a = 0, b = 0, width = 1, height = 1, low, high, total, whole, half;
    const int16_t *row, *next;

    if (time >= {prefix}_time[{upper}_TIMES - 1]) {{
        i = {upper}_TIMES - 1;
    }} else if (time > {prefix}_time[0]) {{
        while (time >= {prefix}_time[i + 1])
            ++i;
        a = (int64_t)time - {prefix}_time[i];
        width = (int64_t){prefix}_time[i + 1] - {prefix}_time[i];
    }}
    if (temperature >= {prefix}_temperature[{upper}_TEMPERATURES - 1]) {{
        j = {upper}_TEMPERATURES - 1;
    }} else if (temperature > {prefix}_temperature[0]) {{
        while (temperature >= {prefix}_temperature[j + 1])
            ++j;
        b = (int64_t)temperature - {prefix}_temperature[j];
        height = (int64_t){prefix}_temperature[j + 1] - {prefix}_temperature[j];
    }}
    row = {prefix}_value[j];
    next = b ? {prefix}_value[j + 1] : row;
    low = row[i] * (width - a) + (a ? row[i + 1] * a : 0);
    high = next[i] * (width - a) + (a ? next[i + 1] * a : 0);
    total = low * (height - b) + high * b;
    whole = width * height;
    half = whole / 2;
    return (int32_t)(total >= 0 ? (total + half) / whole : (total - half) / whole);
}}

#endif
"""
