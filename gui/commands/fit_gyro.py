"""Gyros on the rate table and on the head, for ``calrig fit``."""

from core.procedures.g_sensitivity import GSensitivity, GSensor, fit_g_sensitivity
from core.procedures.rate_and_head import fit_rate_and_head
from core.procedures.rate_table import RateSensor, calibrate_rate_table
from core.procedures.two_files import Table37, calibrated_by_3_10, compare_runs
from gui.commands.fitted import Fitted, estimate_text, note_lines


def fit_rates(fitted: Fitted) -> None:
    """Scale factor, zero and straightness of every gyro of a table run."""
    table = calibrate_rate_table(
        fitted.run, fitted.conditions, full_scale_dps=fitted.full_scale_dps
    )
    fitted.rates = fitted.run, table
    fitted.give(
        rate_table=table,
        bias={sensor.channel: sensor.bias for sensor in table.sensors},
        residuals_dps={sensor.channel: sensor.residuals_dps for sensor in table.sensors},
    )
    fitted.say(f"{fitted.path}: {table.device} on the rate table, practicum (3.6)")
    for sensor in table.sensors:
        fitted.say(f"  {sensor.channel}, axis {sensor.axis.upper()}", *_of_rates(sensor))
    fitted.say(*note_lines(table.notes, "  "))


def _of_rates(sensor: RateSensor) -> list[str]:
    lines = [
        estimate_text(sensor.line.symbol, sensor.line.slope),
        estimate_text("zero", sensor.line.zero),
        estimate_text("bias", sensor.bias),
        estimate_text("nonlin.", sensor.nonlinearity.ppm)
        + f" of {sensor.nonlinearity.full_scale:g} deg/s",
    ]
    if sensor.slopes is not None:
        lines.append(estimate_text("asymm.", sensor.slopes[2]))
    if sensor.hysteresis is not None:
        lines.append(estimate_text("hyster.", sensor.hysteresis.mean))
    lines += [estimate_text(line.symbol, line.slope) for line in sensor.others]
    return [f"    {line}" for line in lines] + note_lines(sensor.notes, "    ")


def fit_positions(fitted: Fitted) -> None:
    """g-sensitivity of every gyro of a head run, in deg/s if the table run came before."""
    head = fitted.run
    rates = {} if fitted.rates is None else {s.channel: s for s in fitted.rates[1].sensors}
    slopes = {channel: sensor.line.slope for channel, sensor in rates.items()}
    found = fit_g_sensitivity(head, fitted.conditions, scale_factors=slopes)
    fitted.say(f"{fitted.path}: {found.device} on the head, {found.procedure}")
    tables: dict[str, object] = {}
    for sensor in found.sensors:
        fitted.say(f"  {sensor.channel}, axis {sensor.axis.upper()}", *_of_head(sensor))
        if fitted.rates is not None and sensor.channel in rates:
            table_run, on_table = fitted.rates[0], rates[sensor.channel]
            pair = compare_runs(table_run, on_table, head, sensor)
            fitted.say(*note_lines(pair.notes, "    "))
            tables[sensor.channel] = pair
            if fitted.same_unit or not pair.refused:
                tables[sensor.channel] = calibrated_by_3_10(
                    table_run, on_table, head, sensor, same_unit=fitted.same_unit
                )
    fitted.say(*note_lines(found.notes, "  "))
    together = any(isinstance(table, Table37) for table in tables.values())
    fitted.give(
        g_sensitivity=found,
        table_3_7=tables,
        joint=_joint(fitted) if together else None,
    )


def _joint(fitted: Fitted) -> GSensitivity | None:
    """Table and head of one unit in one model, (3.3)."""
    if fitted.rates is None:
        return None
    found = fit_rate_and_head(
        fitted.rates[0], fitted.run, fitted.conditions, same_unit=fitted.same_unit
    )
    fitted.say(f"  table and head together: {found.procedure}")
    for sensor in found.sensors:
        rows = zip(sensor.fit.parameters, sensor.fit.values, sensor.fit.expanded(), strict=True)
        fitted.say(
            f"  {sensor.channel}, axis {sensor.axis.upper()}",
            *(
                f"    {p.symbol:<8} {value:>14.8g} +- {u:.2g} {p.unit}  (95 %)"
                for p, value, u in rows
            ),
        )
    return found


def _of_head(sensor: GSensor) -> list[str]:
    lines: list[str] = []
    for axis in sensor.axes:
        lines.append(estimate_text(f"b_{sensor.axis}{axis}", sensor.b(axis)))
        if sensor.scale_factor is not None:
            lines.append(estimate_text("", sensor.b_dps(axis)))
            lines.append(estimate_text("", sensor.b_dph_per_g(axis)))
    return [f"    {line}" for line in lines] + note_lines(sensor.notes, "    ")
