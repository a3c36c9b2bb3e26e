"""Random boards are understood from their bytes alone."""

import numpy as np
import pytest

from drivers.profile import parse_profile
from drivers.profile_types import FrameSpec
from drivers.teach.analysis import FEWEST, Proposal, analyse, device_file
from drivers.teach.rows import frames_in
from tests.drivers.teach.layouts import Layout, frames_of, invented, stream_of

BOARDS = 150
FOUND = 0.95
FIELDS = 0.85


def understood(layout: Layout, proposal: Proposal, rng: np.random.Generator) -> bool:
    """Whether frames sent later, whose values were never seen, are all cut out right."""
    if not isinstance(proposal.stream, FrameSpec) or proposal.stream.length != layout.length:
        return False
    profile = parse_profile(device_file(proposal, "Invented"), "invented.toml")
    later = frames_of(layout, rng, 50_000, 300)
    _, starts, _ = frames_in(later.tobytes(), profile.stream)
    at_their_places = np.count_nonzero(starts % layout.length == 0)
    return bool(at_their_places >= 0.99 * len(later) and at_their_places == len(starts))


@pytest.mark.slow
def test_nearly_all_random_layouts_are_found():
    found = right = fields = 0
    for seed in range(BOARDS):
        rng = np.random.default_rng([20, seed])
        layout = invented(rng)
        proposal = analyse(stream_of(layout, rng, 100, 400))
        found += understood(layout, proposal, rng)
        told = proposal.stream.fields if isinstance(proposal.stream, FrameSpec) else ()
        # Of numbers that never change their sign either sign is right.
        have = {(field.at, field.type.replace("u", "i")) for field in told}
        want = {(field.at, field.type.replace("u", "i")) for field in layout.fields}
        fields += len(want)
        right += len(want & have)
    assert found >= FOUND * BOARDS, f"{found} of {BOARDS}"
    assert right >= FIELDS * fields, f"{right} of {fields} fields"


@pytest.mark.parametrize("checked", [True, False])
def test_garbage_between_frames_does_not_hide_them(checked: bool):
    rng = np.random.default_rng(8)
    layout = invented(rng, checked=checked)
    data = stream_of(layout, rng, 0, 400)
    noise = rng.integers(0, 256, 3000, np.uint8).tobytes()
    assert understood(layout, analyse(noise + data), rng)


def test_noise_is_no_board():
    noise = np.random.default_rng(5).integers(0, 256, 20_000, np.uint8).tobytes()
    assert analyse(noise).found is None


def test_too_few_bytes_say_nothing():
    assert analyse(bytes(FEWEST - 1)).found is None
    with pytest.raises(ValueError, match="nothing was found"):
        device_file(analyse(b""), "Nothing")


def test_silence_of_one_byte_is_no_board():
    assert analyse(bytes(4000)).found is None


def test_the_rate_comes_from_the_bytes():
    rng = np.random.default_rng(3)
    layout = invented(rng, checked=True)
    data = frames_of(layout, rng, 0, 500).tobytes()
    assert analyse(data, layout.length * 200.0).hz == 200.0
