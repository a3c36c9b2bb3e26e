"""Which devices have gyros, and how they are measured on the rate table."""

from dataclasses import replace

from core.samples.block import Channel
from drivers.profile import Profile
from gui.measuring.device import MeasuredDevice, assembly, roles_of, triad

CLBDUS, CVGCOM = "clbdus", "cvgcom"

EMPTY = MeasuredDevice(CLBDUS, "gyro", "rate.", (), (), "code")
"""No device yet."""


def gyro_device(profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:
    """Return how the gyros of a device are measured; None if it has none."""
    roles = roles_of(channels)
    if profile.kind == "gyro" and any(role.startswith("adc.") for role in roles):
        found = assembly(roles, profile.layout or CLBDUS, "gyro")
        # In an assembly every sensor's own axis is called Z (practicum, model 3.3).
        return replace(found, axes=("z",) * len(found.rows))
    if any(role.startswith("rate.") for role in roles):
        return triad(roles, profile.layout or CLBDUS, "gyro")
    return None
