"""Which devices have accelerometers, and how they are measured on the head."""

from core.samples.block import Channel
from drivers.profile import Profile
from gui.measuring.device import MeasuredDevice, assembly, roles_of, triad

CLBACC, POINTER = "clbacc", "pointer"

EMPTY = MeasuredDevice(POINTER, "accelerometer", "acc.", (), (), "code")
"""No device yet: the Pointer layout, empty."""


def head_device(profile: Profile, channels: tuple[Channel, ...]) -> MeasuredDevice | None:
    """Return how a device is measured on the dividing head; None if it has no accelerometers."""
    roles = roles_of(channels)
    if profile.kind != "gyro" and any(role.startswith("adc.") for role in roles):
        return assembly(roles, CLBACC, "accelerometer")
    if any(role.startswith("acc.") for role in roles):
        layout = profile.layout if profile.layout in (CLBACC, POINTER) else POINTER
        return triad(roles, layout, "accelerometer")
    return None
