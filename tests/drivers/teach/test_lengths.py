"""A byte that tells a length is shown with both readings."""

import numpy as np

from drivers.teach.lengths import length_readings


def stream(value: int) -> tuple[np.ndarray, np.ndarray]:
    rows = np.random.default_rng(0).integers(0, 256, (50, 20), np.uint8)
    rows[:, :3] = 0xAA, 0x55, value
    return rows.ravel(), np.arange(50) * 20


def test_a_payload_length_is_told_from_a_total_one_by_the_headers():
    # Behind the byte 15 bytes of payload and two of checksum.
    total, payload = length_readings(*stream(15), 20, 2)
    assert (total.meaning, total.length, total.share) == ("total", 15, 0.0)
    assert (payload.meaning, payload.length, payload.share, payload.add) == ("payload", 20, 1.0, 5)


def test_a_total_length_is_told_too():
    total, payload = length_readings(*stream(20), 20, 2)
    assert (total.length, total.share, total.add) == (20, 1.0, 0)
    assert (payload.length, payload.share) == (25, 0.0)


def test_a_byte_that_is_no_length_is_left_out():
    assert length_readings(*stream(99), 20, 2) == []
    assert length_readings(*stream(20)[:1], np.array([3]), 20, 2) == []
