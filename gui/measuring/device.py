"""What a measuring tab needs to know of a device."""

from collections.abc import Mapping
from dataclasses import dataclass

from core.samples.block import Channel


@dataclass(frozen=True, slots=True)
class SensorRow:
    """One row of the live table.

    Parameters
    ----------
    name : as the old screens call it: ``"X"``, ``"1"``
    main, main_temp : roles of the sensor that the tab measures, and of its thermometer
    other, other_temp : roles of the sensor of the other kind on the same axis
    """

    name: str
    main: str
    main_temp: str = ""
    other: str = ""
    other_temp: str = ""


@dataclass(frozen=True, slots=True)
class MeasuredDevice:
    """A device as a measuring tab sees it.

    Parameters
    ----------
    layout : the old program whose files fit it: ``"clbacc"``, ``"pointer"``, ``"clbdus"``...
    sensor : ``"accelerometer"`` or ``"gyro"``: what the tab measures
    checked : start of the roles of these sensors
    axes : (c,) case axis of each of them, empty where it is not known
    rows : of the live table
    unit : unit of their outputs
    """

    layout: str
    sensor: str
    checked: str
    axes: tuple[str, ...]
    rows: tuple[SensorRow, ...]
    unit: str

    @property
    def has_others(self) -> bool:
        """Whether it has sensors of the other kind too."""
        return any(row.other for row in self.rows)


def assembly(roles: Mapping[str, Channel], layout: str, sensor: str) -> MeasuredDevice:
    """An assembly of up to nine sensors of one kind at the inputs of a converter."""
    found = [role for role in roles if role.startswith("adc.")]
    rows = tuple(
        SensorRow(role.removeprefix("adc."), role, _if_there(f"temp.{role}", roles))
        for role in found
    )
    return MeasuredDevice(layout, sensor, "adc.", ("",) * len(found), rows, roles[found[0]].unit)


def triad(roles: Mapping[str, Channel], layout: str, sensor: str) -> MeasuredDevice:
    """Sensors named by their case axes; beside each the one of the other kind."""
    own, other = ("acc.", "rate.") if sensor == "accelerometer" else ("rate.", "acc.")
    found = [role for role in roles if role.startswith(own)]
    rows = tuple(
        SensorRow(
            role.removeprefix(own).upper(),
            role,
            _if_there(f"temp.{role}", roles),
            _if_there(role.replace(own, other), roles),
            _if_there(role.replace(own, f"temp.{other}"), roles),
        )
        for role in found
    )
    axes = tuple(role.removeprefix(own) for role in found)
    return MeasuredDevice(
        layout,
        sensor,
        own,
        tuple(axis if axis in ("x", "y", "z") else "" for axis in axes),
        rows,
        roles[found[0]].unit,
    )


def roles_of(channels: tuple[Channel, ...]) -> dict[str, Channel]:
    """Channels that have a role, by it."""
    return {channel.role: channel for channel in channels if channel.role}


def _if_there(role: str, roles: Mapping[str, Channel]) -> str:
    return role if role in roles else ""
