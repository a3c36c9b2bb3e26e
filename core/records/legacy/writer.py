"""Runs as legacy text, whole files and one row at a time.

Columns are parted by a tab and lines end with CR LF (the practicum shows neither): every script
that splits at white space reads them, and a name with blanks stays whole. Text is UTF-8 without
BOM. Outputs have two digits as in the tables; outputs in another unit than codes have nine
significant digits, since two would destroy them.
"""

import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, frozen, frozen_int
from core.errors import FormatError
from core.records.atomic import append_durable, not_stored, write_text_atomic
from core.records.legacy.file import LegacyFile
from core.records.legacy.layout import LegacyLayout, position_numbers, position_of
from core.records.names import name_in_file
from core.samples.run import Run


def write_legacy(source: Run | LegacyFile, layout: LegacyLayout, path: Path) -> None:
    """Write a whole legacy file, replacing `path`.

    Raises
    ------
    FormatError
        The layout cannot hold the source.
    StorageError
        The file cannot be written.
    """
    write_text_atomic(path, legacy_text(source, layout))


def legacy_text(source: Run | LegacyFile, layout: LegacyLayout) -> str:
    """The text of a legacy file.

    Raises
    ------
    FormatError
        The layout cannot hold the source.
    """
    rows = legacy_rows(source, layout) if isinstance(source, Run) else source
    if rows.layout.id != layout.id:
        raise FormatError(rows.path, f"holds rows of {rows.layout.title}, not of {layout.title}")
    return "".join(map(_line, [rows] * len(rows), range(len(rows))))


def append_row(path: Path, rows: LegacyFile) -> None:
    """Append rows to a legacy file, durable when the function returns.

    Raises
    ------
    StorageError
        They could not be written; the rows before them are untouched.
    """
    text = "".join(_line(rows, i) for i in range(len(rows)))
    try:
        handle = os.open(path, os.O_WRONLY | os.O_APPEND | getattr(os, "O_BINARY", 0))
        try:
            append_durable(handle, text.encode())
        finally:
            os.close(handle)
    except OSError as error:
        raise not_stored(path, error, "its earlier rows are untouched") from error


def legacy_rows(run: Run, layout: LegacyLayout) -> LegacyFile:
    """Return a run as rows of a layout, unused columns zero.

    Raises
    ------
    FormatError
        The layout has no place for the sensor, an output, a position, or something that it needs
        is missing.
    """
    _check_kind(run, layout)
    sources = {
        **{name: np.asarray(values) for name, values in run.extra.items()},
        **dict(zip(_columns_of_outputs(run, layout), run.y.T, strict=True)),
        "set temperature": _set_temperature(run),
        "head angle": run.head_deg,
        "set rate": run.set_rate_dps,
    }
    zero = np.zeros(len(run))
    values = np.column_stack(
        [
            _numbers(run, layout)
            if column.name.endswith(" number")
            else sources.get(column.name, zero)
            for column in layout.columns
        ]
    )
    _check_values(run, layout, values)
    return LegacyFile(
        path=run.device,
        layout=layout,
        devices=(name_in_file(run.device),) * len(run),
        values=frozen(values),
        lines=frozen_int(np.arange(1, len(run) + 1)),
        unit=run.unit,
    )


def _set_temperature(run: Run) -> FloatArray:
    stated = run.extra.get("set_temperature_c")
    if stated is None:
        return run.temperature_c
    return np.where(np.isfinite(stated), stated, run.temperature_c)


def _check_kind(run: Run, layout: LegacyLayout) -> None:
    test = layout.test.get(run.sensor)
    if test is None or run.sensor not in layout.outputs:
        raise FormatError(run.device, f"{layout.title} has no columns for a {run.sensor}")
    if test != run.test:
        raise FormatError(
            run.device, f"{layout.title} holds the test {test!r}, this run is {run.test!r}"
        )
    if not len(run):
        raise FormatError(run.device, "the run has no rows")


def _columns_of_outputs(run: Run, layout: LegacyLayout) -> Sequence[str]:
    """Output column of each channel: by name, else by axis, else by place."""
    columns = layout.outputs[run.sensor]
    if all(name in columns for name in run.channels):
        return run.channels
    axes = layout.axes[run.sensor]
    if len(set(axes)) > 1:
        if len(set(run.axes)) == len(run.axes) and set(run.axes) <= set(axes):
            return [columns[axes.index(axis)] for axis in run.axes]
        raise FormatError(
            run.device, f"{layout.title} needs outputs of axes x, y, z, this run has {run.axes}"
        )
    if len(run.channels) > len(columns):
        raise FormatError(
            run.device, f"{layout.title} holds {len(columns)} outputs, not {len(run.channels)}"
        )
    return columns[: len(run.channels)]


def _numbers(run: Run, layout: LegacyLayout) -> FloatArray:
    """The zero-based position, rate or row number of each row."""
    if layout.has("head angle"):
        if not np.all(np.isfinite(run.head_deg)):
            raise FormatError(run.device, f"{layout.title} needs the head angle of every row")
        return np.array([position_of(angle) for angle in run.head_deg.tolist()], dtype=float)
    if layout.plan:
        return _positions_in_plan(run, layout)
    step = run.extra.get("step")
    if step is not None:
        return step - 1.0
    if layout.has("set rate"):
        return np.searchsorted(np.unique(run.set_rate_dps), run.set_rate_dps).astype(float)
    return np.arange(len(run), dtype=float)


def _positions_in_plan(run: Run, layout: LegacyLayout) -> FloatArray:
    numbers = position_numbers(layout.plan)
    found: list[float] = []
    for row, (mount, angle) in enumerate(zip(run.mount, run.head_deg.tolist(), strict=True)):
        number = numbers.get((mount, angle % 360.0))
        if number is None:
            raise FormatError(
                run.device,
                f"row {row + 1}: {layout.title} has no position for mount {mount!r} at"
                f" {angle:g} deg",
            )
        found.append(float(number))
    return np.array(found)


def _check_values(run: Run, layout: LegacyLayout, values: FloatArray) -> None:
    for place in range(len(run)):
        missing = np.flatnonzero(~np.isfinite(values[place]))
        if missing.size:
            name = layout.columns[int(missing[0])].name
            raise FormatError(
                run.device,
                f"row {place + 1}: {layout.title} needs the {name}, which this run does not hold",
            )
        column, doubt = layout.first_doubt(values[place])
        if doubt:
            raise FormatError(run.device, f"row {place + 1}, column {column}: {doubt}")


def _line(rows: LegacyFile, place: int) -> str:
    layout = rows.layout
    fine = rows.unit != "code"
    outputs = layout.outputs[layout.sensor]
    cells = [
        f"{value:.9g}" if fine and column.name in outputs else column.write(value)
        for column, value in zip(layout.columns, rows.values[place].tolist(), strict=True)
    ]
    return "\t".join([name_in_file(rows.devices[place]), *cells]) + "\r\n"
