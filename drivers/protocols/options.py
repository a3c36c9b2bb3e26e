"""What the [protocol] section of a device file may say: option and default of each decoder."""

from collections.abc import Mapping

PROTOCOL_OPTIONS: Mapping[str, Mapping[str, int]] = {
    "inertial_labs": {"message": 0x33},
    "xsens_mtdata2": {},
    "vectornav_ascii": {},
    "vectornav_binary": {},
    "stim300": {"datagram": 0x93, "acc_range_g": 10},
    "cvgx12": {"gyro": 0},
}

PROTOCOL_PARAMS: Mapping[str, tuple[str, ...]] = {"inertial_labs": ("KG", "KA")}
"""Constants that the [params] of a device file must give for a decoder."""
