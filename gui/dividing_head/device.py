"""What the dividing-head tab needs to know of a device."""

from collections.abc import Mapping
from dataclasses import dataclass

from core.samples.block import Channel
from drivers.profile import Profile

CLBACC, POINTER = "clbacc", "pointer"


@dataclass(frozen=True, slots=True)
class SensorRow:
    """One row of the live table.

    Parameters
    ----------
    name : as the old screens call it: ``"X"``, ``"1"``
    acc, acc_temp, rate, rate_temp : roles of its channels; empty where there is none
    """

    name: str
    acc: str
    acc_temp: str = ""
    rate: str = ""
    rate_temp: str = ""


@dataclass(frozen=True, slots=True)
class HeadDevice:
    """A device as the dividing head sees it.

    Parameters
    ----------
    layout : ``"clbacc"`` (an assembly of up to nine sensors) or ``"pointer"`` (a triad)
    checked : start of the roles of the accelerometers
    axes : (c,) case axis of each of them, empty where it is not known
    rows : of the live table
    unit : unit of the accelerometers' outputs
    """

    layout: str
    checked: str
    axes: tuple[str, ...]
    rows: tuple[SensorRow, ...]
    unit: str

    @property
    def has_rates(self) -> bool:
        """Whether it has gyros."""
        return any(row.rate for row in self.rows)


EMPTY = HeadDevice(POINTER, "acc.", (), (), "code")
"""No device yet: the Pointer layout, empty."""


def head_device(profile: Profile, channels: tuple[Channel, ...]) -> HeadDevice | None:
    """Return how a device is measured on the dividing head; None if it has no accelerometers."""
    roles = {channel.role: channel for channel in channels if channel.role}
    if profile.kind != "gyro" and any(role.startswith("adc.") for role in roles):
        return _assembly(roles)
    if any(role.startswith("acc.") for role in roles):
        return _triad(roles, profile.layout or POINTER)
    return None


def _assembly(roles: Mapping[str, Channel]) -> HeadDevice:
    found = [role for role in roles if role.startswith("adc.")]
    rows = tuple(
        SensorRow(role.removeprefix("adc."), role, _if_there(f"temp.{role}", roles))
        for role in found
    )
    return HeadDevice(CLBACC, "adc.", ("",) * len(found), rows, roles[found[0]].unit)


def _triad(roles: Mapping[str, Channel], layout: str) -> HeadDevice:
    found = [role for role in roles if role.startswith("acc.")]
    rows = tuple(
        SensorRow(
            role.removeprefix("acc.").upper(),
            role,
            _if_there(f"temp.{role}", roles),
            _if_there(role.replace("acc.", "rate."), roles),
            _if_there(role.replace("acc.", "temp.rate."), roles),
        )
        for role in found
    )
    axes = tuple(role.removeprefix("acc.") for role in found)
    return HeadDevice(
        layout if layout in (CLBACC, POINTER) else POINTER,
        "acc.",
        tuple(axis if axis in ("x", "y", "z") else "" for axis in axes),
        rows,
        roles[found[0]].unit,
    )


def _if_there(role: str, roles: Mapping[str, Channel]) -> str:
    return role if role in roles else ""
