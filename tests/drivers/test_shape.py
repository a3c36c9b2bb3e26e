"""Gathering frames as matrices."""

import numpy as np
import pytest

from drivers.shape import Batch, among, gather

BUFFER = np.arange(60, dtype=np.uint8)


@pytest.mark.parametrize("starts", [[], [57], [0, 57], [0, 10, 20], [5, 8, 11, 14], [3, 4, 9, 40]])
def test_rows_are_the_bytes_at_each_place(starts: list[int]):
    rows = gather(BUFFER, np.array(starts, dtype=np.int64), 3)
    assert rows.shape == (len(starts), 3)
    assert rows.tolist() == [[s, s + 1, s + 2] for s in starts]


def test_evenly_spaced_rows_are_a_view():
    assert np.shares_memory(gather(BUFFER, np.array([0, 10, 20]), 3), BUFFER)


def test_a_row_beyond_the_end_is_refused():
    with pytest.raises((TypeError, IndexError, ValueError)):
        gather(BUFFER, np.array([58]), 3)


def test_rows_of_a_selection():
    nothing = np.zeros(3, dtype=np.int64)
    batch = Batch(BUFFER, np.array([1, 7, 30]), nothing + 4, nothing, 0, b"", 0)
    assert batch.rows(np.array([0, 2]), 2).tolist() == [[1, 2], [30, 31]]
    assert batch.rows(slice(1, None), 2).tolist() == [[7, 8], [30, 31]]


def test_among():
    assert among(BUFFER[:4], (2,)).tolist() == [False, False, True, False]
    assert among(BUFFER[:4], (0, 3)).tolist() == [True, False, False, True]
