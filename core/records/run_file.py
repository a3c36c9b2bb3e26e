"""``NAME.run.csv``: a run as text for people, spreadsheets and other programs.

Head lines ``# key = value`` (TOML values), one line of column names, then the rows in the order of
measuring. Numbers are written so that they come back to the last bit, whatever the locale; an
empty cell is a missing number. Keys and columns that CalRig does not know are kept.

run_head
    The head lines.
run_table
    The table below them.
"""

import csv
import io
import json
import math
from pathlib import Path
from typing import cast

import numpy as np

from core.arrays import FloatArray, frozen
from core.errors import FormatError
from core.records.atomic import write_text_atomic
from core.records.run_head import (
    CONDITIONS,
    KNOWN,
    VERSION,
    VERSION_KEY,
    Head,
    Scalar,
    head_text,
    split_head,
    toml_list,
    toml_notes,
)
from core.records.run_table import LABELS, read_table
from core.records.text import decode, read_bytes
from core.samples.run import Conditions, Run

SENSORS = ("accelerometer", "gyro")
AXES = ("x", "y", "z")
NEEDED: dict[str, tuple[str, ...]] = {
    "dividing_head": ("mount", "head_deg"),
    "static_positions": ("mount", "head_deg"),
    "rate_table": ("set_rate_dps",),
    "accuracy": (),
    "record": ("t_s",),
    "headings": ("head_deg",),
}
"""Columns besides the outputs that a run of each test must have."""

_OPTIONAL = ("head_deg", "set_rate_dps", "temperature_c", "t_s")
_COLUMNS = ("run", "order", "mount", *_OPTIONAL)


def read_run(path: Path) -> Run:
    """Read a run file.

    Raises
    ------
    FormatError
        It is no run file, is damaged, or from a newer program; with line and column.
    """
    return parse_run(decode(read_bytes(path), path), str(path))


def write_run(run: Run, path: Path) -> None:
    """Write a run file, replacing `path`.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    write_text_atomic(path, run_text(run))


def parse_run(text: str, path: str) -> Run:
    """Read the text of a run file; `path` stands in messages.

    Raises
    ------
    FormatError
        As `read_run`.
    """
    head, body, first = split_head(text, path)
    table = read_table(body, first, path)
    test = head.choice("test", tuple(NEEDED))
    needed = NEEDED[test]
    for name in needed:
        if name not in table.cells:
            raise FormatError(path, f"a run of test {test!r} needs a column {name!r}", line=first)
    outputs = table.outputs(head.texts("channels"))
    used = {*_COLUMNS, *(o.y for o in outputs), *(o.se for o in outputs)}
    extra, labels = table.others(used)
    optional = {name: table.numbers(name, needed=name in needed) for name in _OPTIONAL}
    return Run(
        test=test,
        sensor=head.choice("sensor", SENSORS),
        device=head.text("device", ""),
        channels=head.texts("channels") or tuple(o.suffix or "y" for o in outputs),
        axes=_axes(head, tuple(o.suffix for o in outputs)),
        unit=head.text("output_unit", "code"),
        y=frozen(np.column_stack([table.numbers(o.y, needed=True) for o in outputs])),
        y_se=frozen(np.column_stack([table.numbers(o.se) for o in outputs])),
        run=table.integers("run", np.ones(len(table))),
        order=table.integers("order", np.arange(len(table), dtype=float)),
        mount=table.texts("mount"),
        conditions=Conditions(**{name: head.number(name) for name in CONDITIONS}),
        extra=extra,
        meta={**head.unknown(), **labels},
        notes=head.notes(),
        **optional,
    )


def run_text(run: Run) -> str:
    """The text of a run file."""
    out = io.StringIO()
    out.write(head_text(_head(run)))
    columns = _columns(run)
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values(), strict=True))
    return out.getvalue()


def _axes(head: Head, suffixes: tuple[str, ...]) -> tuple[str, ...]:
    axes = head.texts("axes") or _default_axes(suffixes, head.text("axis", ""))
    if len(axes) != len(suffixes) or not set(axes) <= {*AXES, ""}:
        raise FormatError(
            head.path, f"axes {', '.join(map(repr, axes))}; expected x, y or z for each output"
        )
    return axes


def _default_axes(suffixes: tuple[str, ...], axis: str) -> tuple[str, ...]:
    return tuple(suffix if suffix in AXES else axis for suffix in suffixes)


def _head(run: Run) -> list[tuple[str, Scalar]]:
    suffixes = _suffixes(run)
    axis = run.axes[0] if len(set(run.axes)) == 1 else ""
    head: list[tuple[str, Scalar]] = [
        (VERSION_KEY, VERSION),
        ("test", run.test),
        ("sensor", run.sensor),
    ]
    if axis:
        head.append(("axis", axis))
    head += [("device", run.device), ("output_unit", run.unit)]
    if tuple(suffix or "y" for suffix in suffixes) != run.channels:
        head.append(("channels", toml_list(run.channels)))
    if _default_axes(suffixes, axis) != run.axes:
        head.append(("axes", toml_list(run.axes)))
    stated = [(name, cast(float, getattr(run.conditions, name))) for name in CONDITIONS]
    head += [(name, value) for name, value in stated if not math.isnan(value)]
    head += [
        (key, value)
        for key, value in run.meta.items()
        if key not in KNOWN and not key.startswith(LABELS)
    ]
    if run.notes:
        head.append(("notes", toml_notes(run.notes)))
    return head


def _suffixes(run: Run) -> tuple[str, ...]:
    """What follows ``y_`` in the columns: the axes of a triad, else the channels' names."""
    if len(run.channels) == 1:
        return ("",)
    if len(set(run.axes)) == len(run.axes) and set(run.axes) <= set(AXES):
        return run.axes
    return run.channels


def _columns(run: Run) -> dict[str, list[str]]:
    columns = {"run": [str(value) for value in run.run.tolist()]}
    columns["order"] = [str(value) for value in run.order.tolist()]
    if any(run.mount) or "mount" in NEEDED[run.test]:
        columns["mount"] = list(run.mount)
    for name in _OPTIONAL:
        values = cast(FloatArray, getattr(run, name))
        if name in NEEDED[run.test] or not np.isnan(values).all():
            columns[name] = _cells(values)
    with_errors = not np.isnan(run.y_se).all()
    for place, suffix in enumerate(_suffixes(run)):
        tail = f"_{suffix}" if suffix else ""
        columns[f"y{tail}"] = _cells(run.y[:, place])
        if with_errors:
            columns[f"y_se{tail}"] = _cells(run.y_se[:, place])
    for name, values in run.extra.items():
        if name in columns:
            raise ValueError(f"the further column {name!r} has the name of another one")
        columns[name] = _labelled(run, name, values)
    return columns


def _labelled(run: Run, name: str, values: FloatArray) -> list[str]:
    labels = run.meta.get(LABELS + name)
    if labels is None:
        return _cells(values)
    texts = cast(list[str], json.loads(str(labels)))
    return [texts[int(place)] for place in values]


def _cells(values: FloatArray) -> list[str]:
    return ["" if math.isnan(value) else repr(value) for value in values.tolist()]
