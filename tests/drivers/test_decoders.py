"""What holds for every decoder: the pieces do not matter, nothing raises, nothing is made up."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.profile import Profile, load_profile, load_profiles
from drivers.profile_types import LineSpec
from tests.drivers.streams import (
    FRAMES,
    bytewise,
    damaged,
    decode,
    randomly,
    same,
    stored,
)

PROFILES = load_profiles()
STORED = {
    "aceinna_s1": ("aceinna", "dmu_S1"), "openimu_z1": ("aceinna", "openimu_z1"),
    "openimu_s1": ("aceinna", "openimu_s1"), "cvgx12": ("cvg_innalabs", "cvgx12"),
    "cvgx48": ("cvg_innalabs", "cvgx48"), "dmu30": ("silicon_sensing_dmu", "dmu30"),
    "dmu11": ("silicon_sensing_dmu", "dmu11"), "inertiallabs_ahrs": ("inertiallabs", ""),
    "stim300": ("stim300", ""), "vectornav_ascii": ("vectornav", ""),
    "vectornav_binary": ("vectornav", "bin"), "xsens_mti": ("xsens_mti", ""),
    "arduino_mpu6050": ("ascii_streams", ""), "adxl345_text": ("ascii_streams", ""),
    "generic_csv": ("ascii_streams", ""), "kvh_dsp3000": ("ascii_streams", ""),
}  # fmt: skip
"""For each profile the file of its stored frames and how their ids begin."""


def stream(name: str, rng: np.random.Generator) -> bytes:
    """A stream of this device: stored frames in any order, or encoded ones."""
    if name in STORED:
        file, begin = STORED[name]
        frames = [frame["bytes"] for key, frame in stored(file).items() if key.startswith(begin)]
        return b"".join(frames[int(n)] for n in rng.integers(0, len(frames), 60))
    profile = PROFILES[name]
    columns = len(make_decoder(profile).channels)
    return encode(profile, np.arange(60), rng.uniform(0, 50, (60, columns)))


def test_every_profile_is_tried():
    assert {file for file, _ in STORED.values()} == {path.stem for path in FRAMES.glob("*.json")}


@pytest.mark.parametrize("name", PROFILES)
def test_whole_or_byte_by_byte_or_in_any_pieces_with_damage_between(name: str):
    rng = np.random.default_rng(11)
    for places in (0, 4, 25):
        data = damaged(stream(name, rng), rng, places)
        whole = decode(make_decoder(PROFILES[name]), [data])
        same(decode(make_decoder(PROFILES[name]), bytewise(data)), whole)
        for _ in range(3):
            same(decode(make_decoder(PROFILES[name]), randomly(data, rng)), whole)


@pytest.mark.parametrize("name", PROFILES)
def test_undamaged_frames_come_out_as_they_went_in(name: str):
    """Between damage, each sample is one that the undamaged stream has too."""
    rng = np.random.default_rng(12)
    data = stream(name, rng)
    clean = decode(make_decoder(PROFILES[name]), [data])
    hurt = decode(make_decoder(PROFILES[name]), [damaged(data, rng, 6)])
    assert len(hurt.data) >= 0.5 * len(clean.data)
    if isinstance(PROFILES[name].stream, LineSpec) or name in ("xsens_mti", "cvgx12", "stim300"):
        return  # no checksum, columns by order of appearance, or settings that may be lost
    if hurt.names == clean.names:
        known = {row.tobytes() for row in clean.data}
        assert sum(row.tobytes() in known for row in hurt.data) >= len(hurt.data) - 1


@pytest.mark.parametrize("name", PROFILES)
@given(data=st.binary(max_size=1500))
def test_random_bytes_never_raise(name: str, data: bytes):
    decoder = make_decoder(PROFILES[name])
    decoder.feed(data)
    decoder.flush()
    decoder.feed(data)


@pytest.mark.parametrize("name", PROFILES)
def test_much_noise_is_refused_and_kept_nowhere(name: str):
    rng = np.random.default_rng(13)
    decoder = make_decoder(PROFILES[name])
    found = decode(decoder, (rng.bytes(5000) for _ in range(40)))
    # One byte of sync and one of checksum let a frame pass in 65536 places.
    assert len(found.data) <= 12
    assert decoder.feed(b"") == []


@pytest.mark.parametrize("name", PROFILES)
def test_after_noise_the_next_frames_are_found(name: str):
    rng = np.random.default_rng(14)
    data = stream(name, rng)
    clean = decode(make_decoder(PROFILES[name]), [data])
    noisy = decode(make_decoder(PROFILES[name]), [rng.bytes(3000) + b"\n" + data])
    assert len(noisy.data) >= len(clean.data) - 2


@pytest.mark.parametrize("name", PROFILES)
def test_decoders_share_nothing(name: str):
    rng = np.random.default_rng(15)
    data = stream(name, rng)
    one, two = make_decoder(PROFILES[name]), make_decoder(PROFILES[name])
    for piece in randomly(data, rng):
        one.feed(piece)
    same(decode(two, [data]), decode(make_decoder(PROFILES[name]), [data]))


def test_ranges_of_a_unit_reach_its_decoder(packaged_path: Callable[[str], Profile]):
    frame = stored("inertiallabs")["imu_orientation_0x33_kg50_ka2000"]
    got = decode(make_decoder(packaged_path("inertiallabs_ahrs")), [frame["bytes"]])
    assert got.row()["gyro_x"] == pytest.approx(frame["expected"]["gyro_dps"][0], rel=1e-12)


@pytest.fixture
def packaged_path() -> Callable[[str], Profile]:
    """Load a packaged profile for a unit with its own ranges."""
    from importlib import resources
    from pathlib import Path

    folder = Path(str(resources.files("resources"))) / "devices"
    return lambda name: load_profile(folder / f"{name}.toml", {"KG": 50, "KA": 2000})
