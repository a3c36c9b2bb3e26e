"""A connection that a test feeds with samples: the attitude unit PW09, standing as it is told."""

from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal

from core.arrays import frozen, frozen_int
from core.plans.orientation import specific_force
from core.plans.plan import Step
from core.samples.block import SampleBlock
from drivers.decoders import make_decoder
from drivers.profile import Profile, load_profiles
from gui.devices.setup import DeviceSetup

G = 9.8106
K = np.array([[-1335.0, -12.8, -72.6], [35.7, -1338.8, 11.7], [1.4, 14.4, 1335.0]])
BIAS = np.array([-378.0, -195.0, -230.0])
RATE = 100.0


class FakeLink:
    """What the tab asks of a link."""

    def __init__(self, profile: Profile, name: str, raw_path: Path | None) -> None:
        self.profile = profile
        self.setup = DeviceSetup("fake", 115200, profile.id, name)
        self.raw_path = raw_path
        self.raw_size = 0
        self.rate_hz = RATE
        self.synced = 0

    def sync(self) -> None:
        self.synced += 1


class FakeConnection(QObject):
    """Signals of the real one; samples come when a test says so."""

    blocks = Signal(object)
    changed = Signal()
    interrupted = Signal()
    resumed = Signal()

    def __init__(self, profile_id: str = "pw09_raw", raw_path: Path | None = None) -> None:
        super().__init__()
        self._profile = load_profiles()[profile_id]
        self._raw_path = raw_path
        self._next = 0
        self._rng = np.random.default_rng(11)
        self.channels = make_decoder(self._profile).channels
        self.link: FakeLink | None = None

    def plug(self, name: str = "PW09") -> None:
        """A device is there."""
        self.link = FakeLink(self._profile, name, self._raw_path)
        self.changed.emit()

    def drain(self) -> None:
        """Nothing waits."""

    def stand(self, step: Step, seconds: float = 1.2, *, turn_dps: float = 0.0) -> None:
        """Send samples of a unit that stands in a step, or turns away from it."""
        for _ in range(round(seconds * RATE / 10)):
            self._block(step, turn_dps)

    def _block(self, step: Step, turn_dps: float) -> None:
        index = np.arange(self._next, self._next + 10)
        self._next += 10
        data = np.zeros((10, len(self.channels)))
        roles = [channel.role for channel in self.channels]
        for row, number in enumerate(index):
            angle = step.head_deg + turn_dps * (number % 1000) / RATE
            output = K @ specific_force(step.mount, angle, G) + BIAS
            for place, axis in enumerate("xyz"):
                if f"acc.{axis}" in roles:
                    data[row, roles.index(f"acc.{axis}")] = output[place]
            for number_of, role in enumerate(roles):
                if role.startswith("adc."):
                    data[row, number_of] = output[2] + 10.0 * number_of
        data += self._rng.normal(0.0, 2.0, data.shape)
        self.blocks.emit(SampleBlock(self.channels, frozen_int(index), frozen(np.rint(data)), RATE))
