"""What the operator sets before a record, as in CVGCom's Device and Port Settings."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import cast

from gui.settings import Section, number_of, text_of

RATES_HZ = (1, 5, 10, 20, 50, 100, 200)
"""Sampling frequencies of CVGCom."""


@dataclass(frozen=True, slots=True)
class LiveSettings:
    """The panel of settings.

    Parameters
    ----------
    serial : Device #; empty for the name that the device has
    static : at rest, else on the moving table
    profile : Profile #
    scale_factor : V per deg/s, for the head of CVGCom's file
    sampling_hz : rows a second of CVGCom's file; the record keeps every sample
    text : whether CVGCom's file is written beside the record
    points : most samples that Full time scale shows
    decimation : the table shows every so many-th sample
    tail_s : what Auto tracking shows
    hidden : names of channels that are not shown
    """

    serial: str = ""
    static: bool = True
    profile: int = 1
    scale_factor: float = 0.024
    sampling_hz: int = 100
    text: bool = True
    points: int = 1_000_000
    decimation: int = 1
    tail_s: float = 10.0
    hidden: tuple[str, ...] = field(default=())

    def to_section(self) -> Section:
        """As plain values."""
        return {**asdict(self), "hidden": list(self.hidden)}


def settings_of(section: Section) -> LiveSettings:
    """The settings in a section; defaults where there are none."""
    usual = LiveSettings()
    hidden = section.get("hidden")
    names = cast(Sequence[object], hidden) if isinstance(hidden, list) else ()
    sampling = round(number_of(section, "sampling_hz", usual.sampling_hz, 1, 200))
    return LiveSettings(
        serial=text_of(section, "serial"),
        static=section.get("static") is not False,
        profile=round(number_of(section, "profile", usual.profile, 0, 999)),
        scale_factor=number_of(section, "scale_factor", usual.scale_factor, -1e6, 1e6),
        sampling_hz=sampling if sampling in RATES_HZ else usual.sampling_hz,
        text=section.get("text") is not False,
        points=round(number_of(section, "points", usual.points, 100, 1e9)),
        decimation=round(number_of(section, "decimation", usual.decimation, 1, 1e6)),
        tail_s=number_of(section, "tail_s", usual.tail_s, 0.1, 1e5),
        hidden=tuple(str(name) for name in names),
    )
