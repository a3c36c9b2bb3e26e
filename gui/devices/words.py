"""What the banner says of a link that needs the operator."""

from core.errors import Severity
from drivers.reader import Counters
from gui.devices.setup import DeviceSetup
from gui.widgets.states import BannerAction, BannerState

RETRY = BannerAction("retry", "Try again")
PROPERTIES = BannerAction("properties", "Device Properties")


def silent_banner(setup: DeviceSetup, counters: Counters) -> BannerState:
    """What to say of a port that is open and gives no samples."""
    if counters.frames:
        return BannerState(
            Severity.WARNING,
            f"{setup.name} has stopped sending",
            f"The port {setup.url} is open, but no frame has come for {counters.silent_s:.0f} s.",
            "Check the supply of the unit; measuring goes on by itself when frames come.",
        )
    if counters.bytes:
        return BannerState(
            Severity.WARNING,
            f"Nothing that comes from {setup.url} can be read",
            f"{counters.bytes} bytes have come, and no frame of the profile was among them.",
            "The baud rate or the profile is wrong: scan the port.",
            (PROPERTIES,),
        )
    return BannerState(
        Severity.WARNING,
        f"Nothing comes from {setup.url}",
        "The port is open, and no byte has arrived.",
        "Check the supply of the unit and the cable, or choose another port.",
        (PROPERTIES,),
    )


def lost_banner(setup: DeviceSetup, why: str) -> BannerState:
    """What to say when the cable is out."""
    return BannerState(
        Severity.ERROR,
        f"Link lost: {setup.url.partition('?')[0]}",
        f"{setup.name}: {why}. Everything accepted so far is on the disk.",
        "Plug the adapter in again; the program reconnects by itself and goes on.",
        closable=False,
    )


def paused_words(seconds: str) -> str:
    """What the log says of a computer that slept."""
    return (
        f"The program stood still for {float(seconds):.1f} s, as when the computer sleeps. What the"
        " port could not hold meanwhile is lost: a device with a counter tells how much, the record"
        " of another one runs on as if no time had passed."
    )
