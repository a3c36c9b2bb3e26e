"""A device file written is a device file read."""

import numpy as np
import pytest

from drivers.profile import load_profiles, parse_profile
from drivers.profile_types import DeviceSection, FrameSpec, LineSpec, PortSettings
from drivers.teach.written import profile_text
from tests.drivers.teach.layouts import invented

DESCRIBED = {
    name: profile
    for name, profile in load_profiles().items()
    if isinstance(profile.stream, FrameSpec | LineSpec)
}


@pytest.mark.parametrize("name", sorted(DESCRIBED))
def test_every_packaged_device_survives(name: str):
    one = DESCRIBED[name]
    assert isinstance(one.stream, FrameSpec | LineSpec)
    text = profile_text(one.device, one.port, one.stream, one.nominal_hz)
    other = parse_profile(text, f"{name}.toml")
    assert (other.device, other.port, other.stream) == (one.device, one.port, one.stream)
    assert other.nominal_hz == one.nominal_hz


def test_words_are_quoted():
    layout = invented(np.random.default_rng(1), checked=True)
    spec = FrameSpec(
        tuple(layout.sync), layout.length, "little", layout.check, None, float("inf"), b"",
        layout.fields,
    )  # fmt: skip
    device = DeviceSection('Плата "Ж" \\ 7', "imu", "", "heard on\ttwo lines\nof notes")
    port = PortSettings((38400, 9600), 8, "E", 2, 250, dtr=True, rts=False)
    other = parse_profile(profile_text(device, port, spec, 33.3), "x.toml")
    assert (other.device, other.port, other.stream) == (device, port, spec)
