"""The work of a job: reading, finding north, and the advice how long to average."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.allan.model import NoiseModel
from core.errors import FitError, LabError
from core.procedures.gyrocompass import find_north
from core.procedures.north_seeking import (
    Seeking,
    averaging_advice,
    heading_uncertainty,
    held_uncertainty,
)
from core.records.open import read_any
from core.samples.run import Run
from gui.gyrocompass.state import Advice, CompassChoices, Found

_HOURS = (0.5, 1.0, 2.0, 4.0)
_HOUR_S = 3600.0


def read(path: Path, choices: CompassChoices) -> Found:
    """Read a run and find north; a latitude that the run states is taken over."""
    run = read_any(path, sensor="gyro")
    if np.all(np.isnan(run.head_deg)):
        raise FitError(f"{path.name}: the rows tell no heading of the base (column head_deg)")
    stated = run.conditions.latitude_deg
    latitude = float(stated) if np.isfinite(stated) else choices.latitude_deg
    return work(run, path.name, replace(choices, channel="", latitude_deg=latitude))


def work(run: Run | None, name: str, choices: CompassChoices) -> Found:
    """Find north in a run, if there is one, and tell how long to average, if the noise is known."""
    found = Found(choices, run, name)
    headings = choices.rows
    if run is not None:
        headings = tuple(run.head_deg.tolist())
        channel = run.channels.index(choices.channel) if choices.channel in run.channels else 0
        found = replace(found, choices=replace(choices, channel=run.channels[channel]))
        conditions = replace(run.conditions, latitude_deg=choices.latitude_deg)
        try:
            compass = find_north(
                run,
                conditions,
                channel=channel,
                scale_factor=choices.scale_factor or np.nan,
                u_tilt_arcmin=choices.u_tilt_arcmin,
                ramp=choices.ramp,
            )
            found = replace(found, compass=compass)
        except LabError as error:
            # The rows were read: latitude or scale factor may be stated otherwise.
            found = replace(found, why=str(error))
    if choices.noise[0] > 0:
        try:
            found = replace(found, advice=_advice(choices, headings))
        except LabError as error:
            found = replace(found, why_no_advice=str(error))
    return found


def _advice(choices: CompassChoices, headings: tuple[float, ...]) -> Advice:
    if np.isnan(choices.latitude_deg):
        raise FitError("how long to average depends on the latitude: state it")
    noise = NoiseModel(
        random_walk=choices.noise[0],
        bias_instability=choices.noise[1],
        rate_random_walk=choices.noise[2],
    )
    seeking = Seeking(choices.latitude_deg, headings, choices.pause_s)
    return Advice(
        headings,
        heading_uncertainty(noise, seeking, choices.average_s),
        averaging_advice(noise, seeking, target_deg=choices.target_deg or np.nan),
        _HOURS,
        held_uncertainty(noise, seeking, choices.average_s, np.array(_HOURS) * _HOUR_S),
    )
