"""No bytes break the search, or what is shown of them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from drivers.profile import parse_profile
from drivers.profile_types import FrameSpec
from drivers.teach.analysis import analyse, device_file
from drivers.teach.frames import checks_of, describe
from drivers.teach.rows import frames_in, sheet_of

PIECES = st.lists(
    st.one_of(
        st.binary(max_size=40),
        st.sampled_from(
            [b"\xaa\x55", b"\r\n", b"1.5,2\n", b"\x00" * 30, b"\xff" * 30, b"\x7f\xc0"]
        ),
    ),
    min_size=1,
    max_size=12,
)


@pytest.mark.slow
@settings(max_examples=20)
@given(pieces=PIECES, repeats=st.integers(1, 60), seed=st.integers(0, 99))
def test_whatever_is_proposed_is_a_device_file(pieces: list[bytes], repeats: int, seed: int):
    data = np.frombuffer(b"".join(pieces) * repeats, np.uint8).copy()
    rng = np.random.default_rng(seed)
    if len(data):
        hit = rng.integers(0, len(data), len(data) // 20)
        data[hit] = rng.integers(0, 256, len(hit), np.uint8)
    stream = data.tobytes()
    proposal = analyse(stream, 1000.0)
    assert sheet_of(stream, proposal.stream).share <= 1.0
    if proposal.stream is not None:
        profile = parse_profile(device_file(proposal, "Any"), "any.toml")
        assert profile.stream == proposal.stream


@settings(max_examples=50)
@given(
    data=st.binary(max_size=600), sync=st.binary(min_size=1, max_size=8), more=st.integers(1, 70)
)
def test_any_header_and_length_may_be_tried(data: bytes, sync: bytes, more: int):
    length = len(sync) + more
    stream = data + (sync + data[:more].ljust(more, b"\x05")) * 12
    for fit in checks_of(stream, tuple(sync), length)[:1]:
        assert 0.5 <= fit.share <= 1.0
    found = describe(stream, tuple(sync), length, None)
    if found is not None:
        assert isinstance(found.spec, FrameSpec)
        rows, starts, _ = frames_in(stream, found.spec)
        assert len(rows) == len(starts) == found.frames
