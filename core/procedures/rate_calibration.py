"""A rate-table result as the calibration that exports and reports take."""

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np

from core.arrays import FloatArray, frozen
from core.fit.linear import Rows
from core.fit.result import FitResult
from core.model.effect import Parameter, Sensor
from core.model.stimulus import stimulus_of
from core.procedures.added import NOTHING, Added, AddedEffect, with_effects
from core.procedures.calibration import Calibration, Provenance
from core.procedures.rate_table import PROCEDURE, RateLine, RateSensor, RateTable
from core.samples.run import Run
from core.version import SOFTWARE


def calibration_of(found: RateTable, run: Run | None = None, added: Added = NOTHING) -> Calibration:
    """Bias, scale factor and, where the unit was re-mounted, cross axes of every sensor.

    The bias is the zero in the mounting about the sensor's own axis, with what gravity adds there.

    Parameters
    ----------
    found : the fits
    run : what they were made of; only added effects need it
    added : effects beyond the line, in the rows about each sensor's own axis
    """
    effects: tuple[tuple[AddedEffect, ...], ...] = ()
    if added and run is not None:
        pairs = [_bent(found, run, sensor, added) for sensor in found.sensors]
        found = replace(found, sensors=tuple(sensor for sensor, _ in pairs))
        effects = tuple(acting for _, acting in pairs)
    lines = [line for s in found.sensors for line in (s.line, *s.others)]
    rows = 1 + max((int(line.rows.max()) for line in lines), default=0)
    return Calibration(
        sensor="gyro",
        unit=found.unit,
        channels=tuple(sensor.channel for sensor in found.sensors),
        axes=tuple(sensor.axis for sensor in found.sensors),
        fits=tuple(_whole(sensor, rows) for sensor in found.sensors),
        conditions=found.conditions,
        temperature_c=found.temperature_c,
        notes=(*found.notes, *(note for sensor in found.sensors for note in sensor.notes)),
        provenance=Provenance(
            procedure=PROCEDURE,
            device=found.device,
            software=SOFTWARE,
            computed_utc=datetime.now(UTC).isoformat(timespec="seconds"),
        ),
        effects=effects,
    )


def _bent(
    found: RateTable, run: Run, sensor: RateSensor, added: Added
) -> tuple[RateSensor, tuple[AddedEffect, ...]]:
    """A sensor whose line has further effects in its model."""
    line, place = sensor.line, run.channels.index(sensor.channel)
    latitude = found.conditions.latitude_deg
    stimulus = stimulus_of(
        run, found.conditions.g_mps2, latitude_deg=latitude if np.isfinite(latitude) else None
    )
    se_dof = run.extra.get("se_dof", np.full(len(run), np.inf))[line.rows]
    y = run.y[line.rows, place] + added.change(sensor.channel, line.rows)
    fit, acting = with_effects(
        line.fit,
        Sensor("gyro", sensor.axis, run.unit),
        stimulus,
        Rows(y, run.y_se[line.rows, place], se_dof),
        found.conditions,
        added.of(sensor.channel),
        added.columns,
        line.rows,
    )
    return replace(sensor, line=replace(line, fit=fit)), acting


def _whole(sensor: RateSensor, rows: int) -> FitResult:
    """The lines of one sensor in one result; they share no rows, so nothing ties them together."""
    cross: dict[str, RateLine] = {}
    for line in sensor.others:
        if line.symbol != sensor.line.symbol:
            cross.setdefault(line.symbol[-1], line)
    if not cross:
        return sensor.line.fit
    main = sensor.line.fit
    parts = [main, *(line.fit for line in cross.values())]
    slope = main.index("scale_factor")
    p = len(main.values)
    covariance = np.zeros((p + len(cross),) * 2)
    covariance[:p, :p] = main.covariance
    for place, line in enumerate(cross.values(), start=p):
        covariance[place, place] = line.slope.u**2
    unit = main.parameters[slope].unit
    return FitResult(
        parameters=(
            *main.parameters,
            *(Parameter(f"cross_axis_{axis}", line.symbol, unit) for axis, line in cross.items()),
        ),
        values=frozen([*main.values, *(line.slope.value for line in cross.values())]),
        covariance=frozen(covariance),
        shared=frozen(
            np.vstack(
                [
                    _by_row(sensor.line, range(p), rows),
                    *(_by_row(line, [slope], rows) for line in cross.values()),
                ]
            )
        ),
        t_dof=frozen([*main.t_dof, *(line.slope.dof for line in cross.values())]),
        fitted=frozen(np.concatenate([part.fitted for part in parts])),
        residuals=frozen(np.concatenate([part.residuals for part in parts])),
        sigma=frozen(np.concatenate([part.sigma for part in parts])),
        free=frozen(np.concatenate([part.free for part in parts])),
        sigma_source=main.sigma_source,
        chi2=sum(part.chi2 for part in parts),
        dof=sum(part.dof for part in parts),
        p_value=main.p_value,
        condition=max(part.condition for part in parts),
        lack_of_fit=main.lack_of_fit,
        notes=main.notes,
    )


def _by_row(line: RateLine, parameters: range | list[int], rows: int) -> FloatArray:
    """Response (p, 2 rows + 1) to the errors that all sensors share, at the rows of the run."""
    of_fit = line.fit.shared[list(parameters)]
    m = len(line.rows)
    whole = np.zeros((len(of_fit), 2 * rows + 1))
    whole[:, line.rows] = of_fit[:, :m]
    whole[:, rows + line.rows] = of_fit[:, m : 2 * m]
    whole[:, -1] = of_fit[:, -1]
    return whole
