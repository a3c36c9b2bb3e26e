"""The device on the rig, as a tab sees it: is it there, what does it send."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.samples.block import Channel, SampleBlock
from drivers.profile import Profile
from gui.devices.connection import Connection
from gui.devices.link import Link
from gui.measuring.device import MeasuredDevice
from gui.measuring.live import LiveMeans


class Bench(QObject):
    """Follows the current device of the connection.

    Parameters
    ----------
    connection : whose samples are measured
    device_of : how a device is measured in the tab; None if it cannot be
    missing : headline and sentence for a device, by its name, that cannot be measured
    """

    changed = Signal()
    """Another device, or the same with other channels; `device` tells."""
    link_changed = Signal()
    """Samples come again, or no longer."""
    block = Signal(object)
    """`SampleBlock` of `device`."""

    def __init__(
        self,
        connection: Connection,
        device_of: Callable[[Profile, tuple[Channel, ...]], MeasuredDevice | None],
        missing: Callable[[str], tuple[str, str]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._connection = connection
        self._device_of = device_of
        self._missing = missing
        self.device: MeasuredDevice | None = None
        self.channels: tuple[Channel, ...] = ()
        self.rate = 0.0
        self.linked = False
        self.live: LiveMeans | None = None
        connection.blocks.connect(self._on_block)
        connection.changed.connect(self._on_changed)
        connection.interrupted.connect(self._on_interrupted)

    @property
    def link(self) -> Link | None:
        """The link of the device."""
        return self._connection.link

    @property
    def name(self) -> str:
        """Name of the device; empty without one."""
        link = self.link
        return "" if link is None else link.setup.name

    @property
    def profile(self) -> Profile | None:
        """Device file of the device."""
        link = self.link
        return None if link is None else link.profile

    @property
    def raw_path(self) -> Path | None:
        """File of the raw bytes."""
        link = self.link
        return None if link is None else link.raw_path

    @property
    def raw_size(self) -> int:
        """Bytes of that file before the samples to come."""
        link = self.link
        return 0 if link is None else link.raw_size

    @property
    def why_not(self) -> tuple[str, str]:
        """Headline and sentence of why nothing can be measured."""
        if self.link is None:
            return (
                "No device",
                "Open Properties at the top, choose the port, press Scan and OK.",
            )
        if not self.channels:
            return "Waiting for samples", "The port is open. The first frame has not come yet."
        if self.rate <= 0:
            return "Listening", "The sample rate is being measured."
        return self._missing(self.name)

    def catch_up(self) -> None:
        """Take everything that has come: what was measured before an order is not its answer."""
        self._connection.drain()

    def sync(self) -> None:
        """Wait until the raw bytes are on the disk; raises `StorageError`."""
        link = self.link
        if link is not None and link.raw_path is not None:
            link.sync()

    def _on_changed(self) -> None:
        self._forget()
        self.changed.emit()

    def _on_interrupted(self) -> None:
        self.linked = False
        if self.live is not None:
            self.live.clear()
        self.link_changed.emit()

    def _on_block(self, block: SampleBlock) -> None:
        link = self.link
        if link is None:
            return
        rate = block.rate or link.rate_hz
        if block.channels != self.channels or (self.rate <= 0 < rate):
            self.channels, self.rate = block.channels, rate
            self.device = self._device_of(link.profile, block.channels) if rate > 0 else None
            self.live = None if self.device is None else LiveMeans(self.device, rate)
            self.linked = True
            self.changed.emit()
        if not self.linked:
            self.linked = True
            self.link_changed.emit()
        if self.device is not None and self.live is not None:
            self.live.feed(block)
            self.block.emit(block)

    def _forget(self) -> None:
        self.device, self.live = None, None
        self.channels, self.rate, self.linked = (), 0.0, False
