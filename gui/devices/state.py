"""What the panel Device Properties shows."""

from dataclasses import dataclass, replace

from core.records.names import NO_NAME
from drivers.ports import PortInfo
from drivers.scan import Found
from gui.devices.setup import DeviceSetup


@dataclass(frozen=True, slots=True)
class PropertiesState:
    """What the panel shows.

    Parameters
    ----------
    rows : one a device
    ports : what can be chosen, likeliest first
    profiles : identifiers and names of the device files
    busy : what the worker does, empty while nothing
    progress : 0 to 1 while it can be told
    question : what the operator has to decide before anything is sent, empty for nothing
    report : what the last scan brought
    why_not_ok : reason why OK cannot be pressed, empty if it can
    """

    rows: tuple[DeviceSetup, ...] = (DeviceSetup(),)
    ports: tuple[PortInfo, ...] = ()
    profiles: tuple[tuple[str, str], ...] = ()
    busy: str = ""
    progress: float = 0.0
    question: str = ""
    report: str = ""
    why_not_ok: str = ""


def found_at(row: DeviceSetup, found: Found | None) -> DeviceSetup:
    """The row with what the scan found at its port."""
    if found is None:
        return replace(row, name=NO_NAME)
    return replace(row, baud=found.baud, profile_id=found.profile.id, name=found.name)


def why_not_ok(state: PropertiesState) -> str:
    """Why OK cannot be pressed; empty if it can."""
    urls = [row.url for row in state.rows]
    if state.busy:
        return "The scan goes on"
    if not all(urls):
        return "Choose a port for every device"
    if len(set(urls)) < len(urls):
        return "Two devices have the same port"
    return ""
