"""The whole model (3.3) of gyros from a table run and a head run at once.

The zero is that of the head, the scale factor that of the table, and every row weighs by what is
known of it; so a contradiction between the two runs shows in the residuals and is said by name,
zero and temperature.
"""

from dataclasses import replace

import numpy as np

from core.errors import FitError, Note
from core.fit.estimate import parameter
from core.fit.linear import Rows, fit_sensor
from core.model.catalogue.common import CrossAxis
from core.model.catalogue.listing import CATALOGUE
from core.model.effect import AXES, Sensor
from core.model.sensor_model import SensorModel
from core.model.stimulus import Stimulus, stack, stimulus_of
from core.procedures.g_sensitivity import (
    EXCITED,
    UNKNOWN_SITE,
    GSensitivity,
    GSensor,
    HeadSite,
    earth_notes,
    fit_g_sensitivity,
    g_effect,
    head_stimulus,
    result_of,
    rows_of,
)
from core.procedures.rate_table import calibrate_rate_table
from core.procedures.two_files import compare_runs
from core.samples.run import Conditions, Run

PROCEDURE = "gyros on rate table and dividing head, practicum (3.3)"


def fit_rate_and_head(
    table: Run,
    head: Run,
    conditions: Conditions,
    site: HeadSite = UNKNOWN_SITE,
    *,
    same_unit: bool = False,
) -> GSensitivity:
    """Estimate bias, scale factor, cross axes and g-sensitivity of every gyro of both runs.

    Parameters
    ----------
    table, head : the two runs; outputs are matched by name
    conditions : g, u of the settings, latitude
    site : how the head stands
    same_unit : the operator's word that both runs are of one unit, whatever the names say

    Raises
    ------
    FitError
        The runs name different devices, have different outputs or units, or determine nothing.
    """
    common = _common(table, head)
    pairs = _pair_notes(table, head, conditions, site, common, same_unit)
    latitude = conditions.latitude_deg if np.isfinite(conditions.latitude_deg) else None
    on_table = stimulus_of(table, conditions.g_mps2, latitude_deg=latitude)
    stimulus = stack(on_table, head_stimulus(head, conditions, site))
    sensors: list[GSensor] = []
    for name in common:
        of_table, of_head = table.channels.index(name), head.channels.index(name)
        axis = head.axes[of_head] or "z"
        rows = _stacked(rows_of(table, of_table), rows_of(head, of_head))
        model = _model(axis, head.unit, on_table, stimulus)
        fit = fit_sensor(model, stimulus, rows, conditions)
        k = parameter(fit, "scale_factor")
        sensor = GSensor(name, axis, fit, k, conditions.g_mps2, pairs[name])
        found = earth_notes(sensor, conditions, site)
        sensors.append(replace(sensor, notes=(*sensor.notes, *found)))
    return result_of(head, sensors, conditions, PROCEDURE, (*table.notes, *head.notes))


def _common(table: Run, head: Run) -> list[str]:
    if table.unit != head.unit:
        raise FitError(f"the table run is in {table.unit}, the head run in {head.unit}")
    common = [name for name in table.channels if name in head.channels]
    if not common:
        raise FitError(
            f"no output stands in both runs: {', '.join(table.channels)} and"
            f" {', '.join(head.channels)}"
        )
    return common


def _pair_notes(
    table: Run,
    head: Run,
    conditions: Conditions,
    site: HeadSite,
    common: list[str],
    same_unit: bool,
) -> dict[str, tuple[Note, ...]]:
    """What names, zeros and temperatures say, by output; refused if the names differ."""
    on_table = calibrate_rate_table(table, conditions)
    slopes = {sensor.channel: sensor.line.slope for sensor in on_table.sensors}
    on_head = fit_g_sensitivity(head, conditions, site, slopes)
    notes: dict[str, tuple[Note, ...]] = {}
    for name in common:
        if name not in slopes:
            raise FitError(f"{name} did not answer to the rate table")
        pair = compare_runs(table, on_table.sensor(name), head, on_head.sensor(name))
        if pair.refused and not same_unit:
            raise FitError(" ".join(note.text for note in pair.notes))
        notes[name] = pair.notes
    return notes


def _model(axis: str, unit: str, on_table: Stimulus, stimulus: Stimulus) -> SensorModel:
    turned = [AXES[i] for i in np.flatnonzero(np.abs(on_table.dw_drate).max(axis=0) > EXCITED)]
    effects = (
        CATALOGUE["bias"],
        CATALOGUE["scale_factor"],
        CrossAxis("".join(turned)),
        g_effect(stimulus),
    )
    return SensorModel(Sensor("gyro", axis, unit), effects)


def _stacked(*parts: Rows) -> Rows:
    return Rows(
        np.concatenate([part.y for part in parts]),
        np.concatenate([part.se for part in parts]),
        np.concatenate([part.se_dof for part in parts]),
    )
