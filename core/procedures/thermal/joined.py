"""Several sessions of one unit as one set: a cycle is often measured over days."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from core.arrays import frozen, frozen_int
from core.errors import FitError, Note, Severity
from core.samples.run import Run


def joined(runs: Sequence[Run]) -> Run:
    """Put runs one after another, in the order of measuring.

    Parameters
    ----------
    runs : of one unit; put in order by the time of their beginning where all tell it

    Raises
    ------
    FitError
        There is none, or they differ in test, sensor, outputs or unit.

    Notes
    -----
    The conditions are those of the first; columns that only some hold are left out.
    """
    if not runs:
        raise FitError("there is no run")
    if len(runs) == 1:
        return runs[0]
    began = [str(run.meta.get("measured_utc", "")) for run in runs]
    if all(began):
        runs = [run for _, run in sorted(zip(began, runs, strict=True), key=lambda one: one[0])]
    first = runs[0]
    for run in runs[1:]:
        for what in ("test", "sensor", "channels", "axes", "unit"):
            if getattr(run, what) != getattr(first, what):
                raise FitError(
                    f"{run.device} and {first.device} differ in {what}: {getattr(run, what)!r} and"
                    f" {getattr(first, what)!r}; one set needs one unit, measured alike"
                )
    kept = [name for name in first.extra if all(name in run.extra for run in runs)]
    notes = [note for run in runs for note in run.notes]
    devices = list(dict.fromkeys(run.device for run in runs))
    if len(devices) > 1:
        words = f"the runs are of {', '.join(devices)}; is it one unit?"
        notes.append(Note(Severity.WARNING, "several_devices", words))
    g = {run.conditions.g_mps2 for run in runs if np.isfinite(run.conditions.g_mps2)}
    if len(g) > 1:
        words = f"the runs state different g: {', '.join(f'{one:.6g}' for one in sorted(g))} m/s^2"
        notes.append(Note(Severity.WARNING, "several_g", f"{words}; that of the first is taken"))
    total = np.cumsum([0, *(len(run) for run in runs)])
    return replace(
        first,
        y=frozen(np.vstack([run.y for run in runs])),
        y_se=frozen(np.vstack([run.y_se for run in runs])),
        run=frozen_int(np.concatenate([run.run for run in runs])),
        order=frozen_int(
            np.concatenate(
                [
                    np.argsort(np.argsort(run.order, kind="stable"), kind="stable") + before
                    for run, before in zip(runs, total[:-1].tolist(), strict=True)
                ]
            )
        ),
        mount=tuple(mount for run in runs for mount in run.mount),
        head_deg=frozen(np.concatenate([run.head_deg for run in runs])),
        set_rate_dps=frozen(np.concatenate([run.set_rate_dps for run in runs])),
        temperature_c=frozen(np.concatenate([run.temperature_c for run in runs])),
        t_s=frozen(np.concatenate([run.t_s for run in runs])),
        extra={name: frozen(np.concatenate([run.extra[name] for run in runs])) for name in kept},
        notes=tuple(dict.fromkeys(notes)),
    )
