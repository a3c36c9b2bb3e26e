"""Reading measurements of any kind, and what to ask where a file leaves a choice."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from core.errors import FormatError, LabError, Severity
from core.records.legacy.reader import read_legacy
from core.records.open import read_any
from core.samples.run import Run
from gui.widgets.states import BannerAction, BannerState

_MOUNTS = ("X_from", "Y_from", "X_from,Y_from")


@dataclass(frozen=True, slots=True)
class Choice:
    """A file that holds several devices."""

    path: Path
    devices: tuple[str, ...]

    def banner(self) -> BannerState:
        """The question."""
        return BannerState(
            Severity.INFO,
            f"{self.path.name} holds {len(self.devices)} devices",
            "",
            "Which one shall be processed?",
            tuple(BannerAction(f"device {name}", name) for name in self.devices),
        )


def load(
    path: Path, device: str | None, mounts: Sequence[str] | None, sensor: str | None = None
) -> Run | Choice:
    """Read a session's folder, a run file or a legacy file; raises `FormatError`."""
    try:
        return read_any(path, sensor=sensor, device=device, mounts=mounts)
    except FormatError:
        names = _devices_of(path) if device is None else ()
        if len(names) > 1:
            return Choice(path, names)
        raise


def mounts_asked(error: LabError) -> tuple[BannerAction, ...]:
    """Buttons that tell how the unit stood, where a file does not."""
    if "give the mounts" not in str(error):
        return ()
    return tuple(
        BannerAction(f"mounts {mounts}", f"It stood {mounts.replace(',', ', then ')}")
        for mounts in _MOUNTS
    )


def _devices_of(path: Path) -> tuple[str, ...]:
    try:
        return tuple(dict.fromkeys(read_legacy(path).devices))
    except FormatError:
        return ()
