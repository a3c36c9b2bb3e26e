"""What the [protocol] section of a device file may say: options of each decoder."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Option:
    """A whole number with its default and what it may be; the first allowed one is the default."""

    allowed: tuple[int, ...]

    @property
    def usual(self) -> int:
        """Value where the file does not say."""
        return self.allowed[0]


_DATAGRAMS = (
    0x93, 0x90, 0x91, 0x92, 0x94, 0xA5, 0xA6, 0xA7, *range(0xF0, 0xF8),
    *range(0x98, 0x9D), 0xAD, 0xAE, 0xAF,
)  # fmt: skip

PROTOCOL_OPTIONS: Mapping[str, Mapping[str, Option]] = {
    "inertial_labs": {"message": Option((0x33, 0x80, 0x83, 0x8D, 0x8F))},
    "xsens_mtdata2": {},
    "vectornav_ascii": {},
    "vectornav_binary": {},
    "stim300": {"datagram": Option(_DATAGRAMS), "acc_range_g": Option((10, 5, 30, 80))},
    "cvgx12": {"controller": Option(tuple(range(16))), "gyro": Option(tuple(range(16)))},
}

PROTOCOL_PARAMS: Mapping[str, tuple[str, ...]] = {"inertial_labs": ("KG", "KA")}
"""Constants that the [params] of a device file must give for a decoder."""
