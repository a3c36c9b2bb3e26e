"""Which decoder a profile needs."""

from collections.abc import Callable, Mapping
from typing import Protocol

from core.samples.block import Channel
from drivers.events import Event
from drivers.frame import FrameDecoder
from drivers.line import LineDecoder
from drivers.profile import Profile
from drivers.profile_types import FrameSpec, LineSpec
from drivers.protocols.cvg12 import Cvg12Decoder
from drivers.protocols.inertial import InertialDecoder
from drivers.protocols.stim300 import Stim300Decoder
from drivers.protocols.vectornav import VectorNavDecoder
from drivers.protocols.vectornav_ascii import VectorNavAsciiDecoder
from drivers.protocols.xsens import XsensDecoder


class Decoder(Protocol):
    """Bytes to events; what came out does not depend on how the bytes were cut into pieces."""

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The columns of the next block; may be empty, and may grow, while a device is heard."""
        ...

    @property
    def rate(self) -> float:
        """Samples per second of one step of the index; 0 while unknown."""
        ...

    def feed(self, data: bytes) -> list[Event]:
        """Return what these bytes complete; any bytes are allowed, none raise."""
        ...

    def flush(self) -> list[Event]:
        """Return what is left when nothing more will come."""
        ...


DECODERS: Mapping[str, Callable[[Profile], Decoder]] = {
    "cvgx12": Cvg12Decoder,
    "inertial_labs": InertialDecoder,
    "stim300": Stim300Decoder,
    "vectornav_ascii": VectorNavAsciiDecoder,
    "vectornav_binary": VectorNavDecoder,
    "xsens_mtdata2": XsensDecoder,
}
"""Decoders of [protocol] sections by their name."""


def make_decoder(profile: Profile) -> Decoder:
    """Return a new decoder for a device."""
    stream = profile.stream
    if isinstance(stream, FrameSpec):
        return FrameDecoder(stream, profile.nominal_hz)
    if isinstance(stream, LineSpec):
        return LineDecoder(stream, profile.nominal_hz)
    return DECODERS[stream.name](profile)
