"""Where a device is and what it speaks."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import cast

from core.records.names import NO_NAME
from gui.settings import Section, number_of, text_of

BAUD = 115200
"""Baud rate of all devices of the practicum."""
BAUDS = (9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600)


@dataclass(frozen=True, slots=True)
class DeviceSetup:
    """One row of Device Properties.

    Parameters
    ----------
    url : the port
    baud : its speed
    profile_id : what the device speaks; empty until that is known or chosen
    name : as the device calls itself
    """

    url: str = ""
    baud: int = BAUD
    profile_id: str = ""
    name: str = NO_NAME

    @property
    def simulated(self) -> bool:
        """Whether it stands on the simulated rig within this program."""
        return self.url.startswith("sim://")


def setups_to_section(setups: Sequence[DeviceSetup]) -> Section:
    """The setups as plain values."""
    return {"devices": [asdict(setup) for setup in setups]}


def setups_of_section(section: Section) -> tuple[DeviceSetup, ...]:
    """The setups in a section of the settings; what is no setup is left out."""
    rows = section.get("devices")
    if not isinstance(rows, list):
        return ()
    return tuple(
        DeviceSetup(
            url=text_of(row, "url"),
            baud=round(number_of(row, "baud", BAUD, 1, 1e8)),
            profile_id=text_of(row, "profile_id"),
            name=text_of(row, "name", NO_NAME),
        )
        for row in (
            cast(Mapping[str, object], row)
            for row in cast(list[object], rows)
            if isinstance(row, dict)
        )
    )
