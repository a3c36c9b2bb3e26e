"""Records for the procedures that take them: over temperature, and since switching on."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from core.arrays import FloatArray
from core.errors import FitError, Note, Severity
from core.procedures.drift.turn_on import TurnOn
from core.records.series import Series
from core.samples.block import Channel
from core.samples.run import Run

_SAME = 0.9
"""Correlation of the steps of two channels from which one is a copy of the other."""
_KINDS = {"rate.": "gyro", "acc.": "accelerometer"}


def record_run(
    series: Series, outputs: Sequence[str] = (), temperature: str = "", sensor: str = ""
) -> Run:
    """Return a record as a run of test ``"record"``.

    Parameters
    ----------
    series : the record
    outputs : names, roles or numbers of the outputs; by default all rates, or else all specific
        forces
    temperature : the same of the temperature; by default the channel that is called so
    sensor : ``"gyro"`` or ``"accelerometer"`` where the channels do not tell

    Raises
    ------
    FormatError
        There is no such channel.
    FitError
        Outputs or temperature cannot be told from the channels' names, or the outputs differ in
        unit.
    """
    places = [series.place(name) for name in outputs] or _outputs(series)
    channels = [series.channels[place] for place in places]
    if len({channel.unit for channel in channels}) > 1:
        raise FitError(
            f"{series.path}: outputs in {', '.join(channel.unit for channel in channels)}; take"
            " those of one unit at a time"
        )
    at = _temperature(series, temperature)
    y = np.column_stack([series.columns[place] for place in places]).astype(np.float64)
    warm = np.asarray(series.columns[at], dtype=np.float64)
    whole = np.isfinite(y).all(axis=1) & np.isfinite(warm)
    lost = int((~whole).sum())
    n = len(y) - lost
    unknown = np.full(n, np.nan)
    return Run(
        test="record",
        sensor=sensor or _kind(channels),
        device=series.device,
        channels=tuple(channel.name for channel in channels),
        axes=tuple(_axis(channel) for channel in channels),
        unit=channels[0].unit,
        y=y[whole],
        y_se=np.full((n, len(places)), np.nan),
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=unknown,
        set_rate_dps=unknown,
        temperature_c=warm[whole],
        t_s=_times(series)[whole],
        notes=(*series.notes, *([_lost(lost, len(y))] if lost else [])),
    )


def sampled_run(series: Series, output: str = "", sensor: str = "") -> Run:
    """Return one output of a record with all other channels beside it.

    Samples that are missing stay missing: whoever judges a record wants to know of them.

    Parameters
    ----------
    series : the record
    output : name, role or number of the output; by default the likeliest
    sensor : ``"gyro"`` or ``"accelerometer"`` where the channel does not tell

    Raises
    ------
    FormatError
        There is no such channel.
    """
    place = series.place(output) if output else series.main
    channel = series.channels[place]
    others = {
        series.channels[other].name: np.asarray(series.columns[other], dtype=np.float64)
        for other in range(len(series.channels))
        if other != place
    }
    y = np.asarray(series.columns[place], dtype=np.float64)
    # What has the noise of the output sample by sample is the output once more, and no cause.
    others = {name: values for name, values in others.items() if not _repeats(values, y)}
    warm = next((c.name for c in series.channels if c.name in others and _is_temperature(c)), "")
    n = series.n
    unknown = np.full(n, np.nan)
    return Run(
        test="record",
        sensor=sensor or _kind([channel]),
        device=series.device,
        channels=(channel.name,),
        axes=(_axis(channel),),
        unit=channel.unit,
        y=y[:, None],
        y_se=unknown[:, None],
        run=np.ones(n, dtype=np.int64),
        order=np.arange(n, dtype=np.int64),
        mount=("",) * n,
        head_deg=unknown,
        set_rate_dps=unknown,
        temperature_c=others.pop(warm, unknown),
        t_s=_times(series),
        extra=others,
        notes=series.notes,
    )


def with_first(run: Run, output: str) -> Run:
    """Return a run of a record with the output of that name, axis or number (from 1) as the first.

    Raises
    ------
    FitError
        There is no such output.
    """
    names = (*run.channels, *run.axes)
    count = len(run.channels)
    if output.isdigit() and 1 <= int(output) <= count:
        place = int(output) - 1
    elif output in names:
        place = names.index(output) % count
    else:
        raise FitError(f"there is no output {output!r}; there are: {', '.join(run.channels)}")
    order = [place, *(other for other in range(count) if other != place)]
    return replace(
        run,
        channels=tuple(run.channels[i] for i in order),
        axes=tuple(run.axes[i] for i in order),
        y=run.y[:, order],
        y_se=run.y_se[:, order],
    )


def turn_on_of(
    series: Series,
    channel: str = "",
    temperature: str = "",
    *,
    ambient_c: float = np.nan,
    rate: float = 0.0,
    scale_factor: float = 0.0,
) -> tuple[TurnOn, str]:
    """Return a record that began with switching on, and the unit of its output.

    Parameters
    ----------
    series : the record; its first sample is taken as the moment of switching on
    channel : name, role or number of the output; by default the likeliest
    temperature : the same of the chip's temperature; by default the channel that is called so
    ambient_c : temperature of the chamber; NaN where only the chip knows
    rate, scale_factor : what the file does not tell, see `Series.sampled`

    Raises
    ------
    FormatError
        There is no such channel.
    FitError
        The record has gaps, or its rate is not known.
    """
    place = series.place(channel) if channel else series.main
    sampled = series.sampled(place, rate, scale_factor)
    if sampled.index is not None:
        raise FitError(f"{series.path}: samples were lost; gaps cannot be averaged over")
    known = temperature or any(_is_temperature(one) for one in series.channels)
    values = np.asarray(sampled.values, dtype=np.float64)
    chip = (
        np.asarray(series.columns[_temperature(series, temperature)], dtype=np.float64)
        if known
        else np.full(len(values), np.nan)
    )
    return TurnOn(series.path, ambient_c, values, sampled.rate, chip), sampled.unit


def _repeats(values: FloatArray, y: FloatArray) -> bool:
    """Whether a channel goes with the output from each sample to the next."""
    steps = np.diff(values), np.diff(y)
    known = np.isfinite(steps[0]) & np.isfinite(steps[1])
    one, other = (each[known] - each[known].mean() for each in steps) if known.any() else steps
    size = float(np.linalg.norm(one) * np.linalg.norm(other))
    return size > 0.0 and abs(float(one @ other)) > _SAME * size


def _outputs(series: Series) -> list[int]:
    for start in _KINDS:
        found = [p for p, channel in enumerate(series.channels) if channel.role.startswith(start)]
        if found:
            return found
    names = ", ".join(channel.name for channel in series.channels)
    raise FitError(f"{series.path}: which channels are the outputs? There are: {names}")


def _is_temperature(channel: Channel) -> bool:
    return channel.role.startswith("temp") or "temp" in channel.name.lower()


def _temperature(series: Series, name: str) -> int:
    if name:
        return series.place(name)
    for place, channel in enumerate(series.channels):
        if _is_temperature(channel):
            return place
    names = ", ".join(channel.name for channel in series.channels)
    raise FitError(f"{series.path}: which channel is the temperature? There are: {names}")


def _kind(channels: Sequence[Channel]) -> str:
    kinds = {_KINDS.get(channel.role.partition(".")[0] + ".", "") for channel in channels}
    if len(kinds) == 1 and "" not in kinds:
        return kinds.pop()
    words = " ".join(channel.name.lower() for channel in channels)
    return "accelerometer" if "acc" in words else "gyro"


def _axis(channel: Channel) -> str:
    last = (channel.role or channel.name)[-1:].lower()
    return last if last in ("x", "y", "z") else ""


def _times(series: Series) -> FloatArray:
    if series.time is not None:
        return series.time - series.time[0]
    if series.rate > 0:
        index = np.arange(series.n) if series.index is None else series.index - series.index[0]
        return index / series.rate
    return np.full(series.n, np.nan)


def _lost(lost: int, rows: int) -> Note:
    return Note(Severity.INFO, "lost", f"{lost} of {rows} rows hold no number and were left out")
