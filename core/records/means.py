"""Means of records, as CVG_Gyro_Mean made them, with the standard errors that it did not tell.

``means.dat``: one line a record, its file name and the mean of each channel as ``%1.9f``, separated
by tabs, CRLF, no head. No file of the old program is known; the layout is inferred from what
it is described to hold, and this page is the one place that knows it. Standard errors, numbers of
samples and times stand in ``means.csv`` beside it.
"""

import csv
import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.arrays import FloatArray, IntArray, frozen, frozen_int
from core.errors import FormatError, Note
from core.records.atomic import write_text_atomic
from core.records.text import decode, lines_of, read_bytes
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel
from core.samples.run import Run

NAME, TABLE = "means.dat", "means.csv"
_DECIMALS = 9


@dataclass(frozen=True, slots=True, eq=False)
class RecordMean:
    """Means of one record, or of an interval of it.

    Parameters
    ----------
    record : name of the file, with the interval where there are several
    channels : (c,) what the columns are; names alone where `means.dat` was read
    mean, se : (c,) means and standard errors; NaN where the file does not tell
    n : samples; 0 where the file does not tell
    start_s, seconds : beginning and length of the interval, s
    lost : samples within it that never came
    notes : doubts
    """

    record: str
    channels: tuple[Channel, ...]
    mean: FloatArray
    se: FloatArray
    n: int = 0
    start_s: float = math.nan
    seconds: float = math.nan
    lost: int = 0
    notes: tuple[Note, ...] = ()

    def place(self, role: str) -> int | None:
        """Column of the channel with this role."""
        return next((i for i, c in enumerate(self.channels) if c.role == role), None)


def mean_of(
    record: str,
    channels: tuple[Channel, ...],
    index: IntArray,
    data: FloatArray,
    rate: float,
    interval: tuple[float, float] | None = None,
) -> RecordMean:
    """Average a record, or an interval of it.

    Parameters
    ----------
    record : its name
    channels : (c,) columns
    index : (n,) sample numbers
    data : (n, c); rows of NaN are samples that never came
    rate : samples per second
    interval : seconds from the first sample, or None for the whole record

    Raises
    ------
    FormatError
        The interval holds no samples.
    """
    t = (index - index[0]) / rate if len(index) else np.empty(0)
    inside = ~np.isnan(data).any(axis=1)
    label = record
    if interval is not None:
        inside &= (t >= interval[0]) & (t < interval[1])
        label = f"{record}[{interval[0]:g}..{interval[1]:g}]"
    if not inside.any():
        raise FormatError(label, "holds no samples")
    t, numbers = t[inside], index[inside]
    steps = int(numbers[-1] - numbers[0]) + 1
    # A channel at a time: of hours of eleven, copies of all would take gigabytes.
    found = [
        accumulation_of(
            (channel,),
            t,
            data[inside, place : place + 1],
            first=int(numbers[0]),
            lost=steps - len(t),
            wanted=steps,
        )
        for place, channel in enumerate(channels)
    ]
    notes = {note.text: note for one in found for note in one.notes}
    return RecordMean(
        label,
        channels,
        frozen(np.concatenate([one.mean for one in found])),
        frozen(np.concatenate([one.se for one in found])),
        len(t),
        float(t[0]),
        steps / rate,
        steps - len(t),
        tuple(notes.values()),
    )


def write_means(means: Sequence[RecordMean], folder: Path) -> tuple[Path, Path]:
    """Write ``means.dat`` and ``means.csv`` into a folder, replacing older ones.

    Raises
    ------
    StorageError
        A file cannot be written.
    """
    rows = [
        "\t".join([_one_cell(one.record), *(f"{value:1.{_DECIMALS}f}" for value in one.mean)])
        for one in means
    ]
    write_text_atomic(folder / NAME, "".join(f"{row}\r\n" for row in rows))
    write_text_atomic(folder / TABLE, means_csv(means))
    return folder / NAME, folder / TABLE


def means_csv(means: Sequence[RecordMean]) -> str:
    """The table with standard errors: one row a record."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    channels = max((one.channels for one in means), key=len, default=())
    head = ["record", "start_s", "seconds", "n", "lost"]
    for channel in channels:
        name = f"{channel.name} [{channel.unit}]" if channel.unit else channel.name
        head += [name, f"se {name}"]
    writer.writerow(head)
    for one in means:
        row: list[object] = [one.record, repr(one.start_s), repr(one.seconds), one.n, one.lost]
        for value, se in zip(one.mean.tolist(), one.se.tolist(), strict=True):
            row += [repr(value), repr(se)]
        writer.writerow(row)
    return out.getvalue()


def read_means(path: Path, names: Sequence[str] = ()) -> tuple[RecordMean, ...]:
    """Read ``means.dat``.

    Parameters
    ----------
    path : the file
    names : of the channels; numbers where they are not given

    Raises
    ------
    FormatError
        A line has no number where one must stand, or another number of them.
    """
    found: list[RecordMean] = []
    for number, line in enumerate(lines_of(decode(read_bytes(path), path)), 1):
        if not line.strip():
            continue
        record, values = _cells(line, path, number)
        if found and len(values) != len(found[0].mean):
            raise FormatError(
                path, f"{len(values)} means; the first line has {len(found[0].mean)}", line=number
            )
        channels = tuple(
            Channel(names[i] if i < len(names) else f"{i + 1}", "") for i in range(len(values))
        )
        nothing = frozen(np.full(len(values), np.nan))
        found.append(RecordMean(record, channels, frozen(values), nothing))
    if not found:
        raise FormatError(path, "holds no means")
    return tuple(found)


def _cells(line: str, path: Path, number: int) -> tuple[str, list[float]]:
    """Name and means of a line; a name with blanks stands before a tab."""
    name, _, rest = line.partition("\t") if "\t" in line else line.strip().partition(" ")
    values: list[float] = []
    for word in rest.replace(",", ".").split():
        try:
            values.append(float(word))
        except ValueError:
            raise FormatError(path, f"{word!r} is no number", line=number) from None
    if not values:
        raise FormatError(path, "no means after the name of the record", line=number)
    return name.strip(), values


def means_run(
    means: Sequence[RecordMean],
    device: str,
    *,
    rates_dps: Sequence[float] = (),
    positions: Sequence[tuple[str, float]] = (),
) -> Run:
    """Rows for the fits of the rate table or of the gyro on the head.

    Parameters
    ----------
    means : one a row, with a channel of role ``"rate..."``
    device : serial number
    rates_dps : set rate of each record, deg/s, for the rate table
    positions : mount and angle of the head of each record, deg, instead of rates

    Raises
    ------
    FormatError
        The records have no rate output, or there are more or fewer rates or positions than means.
    """
    given = len(rates_dps) or len(positions)
    if given != len(means) or (rates_dps and positions):
        raise FormatError("means", f"{len(means)} records, {given} rates or positions for them")
    first = means[0]
    columns = [i for i, channel in enumerate(first.channels) if channel.role.startswith("rate.")]
    if not columns:
        raise FormatError(first.record, "has no output of a gyro")
    if any(one.channels != first.channels for one in means):
        raise FormatError("means", "the records have different channels")
    n = len(means)
    missing = np.full(n, np.nan)
    temperature = first.place("temp")
    outputs = [first.channels[i] for i in columns]
    return Run(
        test="rate_table" if rates_dps else "dividing_head",
        sensor="gyro",
        device=device,
        channels=tuple(channel.name for channel in outputs),
        axes=tuple(channel.role.removeprefix("rate.") for channel in outputs),
        unit=outputs[0].unit,
        y=frozen([one.mean[columns] for one in means]),
        y_se=frozen([one.se[columns] for one in means]),
        run=frozen_int(np.ones(n)),
        order=frozen_int(np.arange(n)),
        mount=tuple(mount for mount, _ in positions) or ("",) * n,
        head_deg=frozen([angle for _, angle in positions] if positions else missing),
        set_rate_dps=frozen(rates_dps if rates_dps else missing),
        temperature_c=frozen(
            missing if temperature is None else [one.mean[temperature] for one in means]
        ),
        t_s=frozen(missing),
        meta={"records": ", ".join(one.record for one in means)},
    )


def position_of(text: str) -> tuple[str, float]:
    """Mount and angle of the head, deg, of ``X_from:90``.

    Raises
    ------
    FormatError
        It is no position.
    """
    mount, colon, angle = text.strip().rpartition(":")
    if not colon:
        raise FormatError("means", f"{text!r} is no position; write X_from:90")
    return mount, number_of(angle)


def number_of(text: str) -> float:
    """A number with either decimal mark and either minus sign.

    Raises
    ------
    FormatError
        It is no number.
    """
    try:
        return float(text.strip().replace(",", ".").replace("\N{MINUS SIGN}", "-"))
    except ValueError:
        raise FormatError("means", f"{text!r} is no number") from None


def _one_cell(text: str) -> str:
    return " ".join(text.split())
