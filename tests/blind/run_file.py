"""The measured run as text, by the format of `NAME.run.csv`."""

import numpy as np

from tests.blind.long_record import AUX, Record
from tests.blind.world import KYIV_DEG, World


def quoted(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value)


def heading(items: dict[str, object]) -> str:
    lines = [f"# {key} = {quoted(value)}" for key, value in items.items()]
    return "\n".join(["# calrig-run = 1", *lines, ""])


def of_settings(world: World, readings) -> str:
    """Dividing head and rate table."""
    plan = world.plan
    items: dict[str, object] = {
        "test": plan.test,
        "sensor": "accelerometer" if world.sensor == "accelerometer" else "gyro",
        "axis": "xyz"[world.axes[0]] if world.outputs == 1 else "xyz",
        "device": "BLIND",
        "output_unit": world.unit,
        "g_mps2": 9.8106,
        "latitude_deg": KYIV_DEG,
        "accumulation_s": plan.accumulation,
        "sample_rate_hz": plan.sample_rate,
    }
    on_table = plan.test == "rate_table"
    items["rate_u_ppm" if on_table else "head_u_arcsec"] = 150.0 if on_table else 5.0
    columns: dict[str, list[str]] = {
        "run": [str(r) for r in plan.run],
        "order": [str(i + 1) for i in range(plan.size)],
    }
    if on_table:
        columns["set_rate_dps"] = [f"{v:.6g}" for v in plan.setting]
    else:
        columns["mount"] = list(plan.mount)
        columns["head_deg"] = [f"{v:.6g}" for v in plan.setting]
    if world.has_temperature:
        columns["temperature_c"] = [f"{v:.2f}" for v in readings.temperature]
    columns["t_s"] = [f"{v:.1f}" for v in plan.time]
    names = [""] if world.outputs == 1 else ["_x", "_y", "_z"]
    for channel, name in enumerate(names):
        columns[f"y{name}"] = [f"{v:.10g}" for v in readings.y[:, channel]]
        if world.has_se:
            columns[f"y{name}_se"] = [f"{v:.4g}" for v in readings.se[:, channel]]
    if world.has_amplitude:
        columns["AntiNodeAmplitude"] = [f"{v:.6f}" for v in world.amplitude]
    rows = zip(*columns.values(), strict=True)
    return heading(items) + "\n".join([",".join(columns), *(",".join(row) for row in rows), ""])


def of_record(record: Record, table: np.ndarray) -> str:
    items: dict[str, object] = {
        "test": "record",
        "sensor": "gyro",
        "axis": "z",
        "device": "BLIND",
        "output_unit": "V",
        "latitude_deg": KYIV_DEG,
        "sample_rate_hz": record.plan.sample_rate,
    }
    form = "%.2f,%.3f,%.9f" + ",%.7f" * len(AUX)
    names = ",".join(("t_s", "temperature_c", "y", *AUX))
    return heading(items) + "\n".join([names, *(form % tuple(row) for row in table.tolist()), ""])
