"""Arrays that nobody can change."""

import numpy as np
import pytest

from core.arrays import frozen, frozen_int


@pytest.mark.parametrize(("make", "dtype"), [(frozen, np.float64), (frozen_int, np.int64)])
def test_the_copy_cannot_be_written_and_does_not_follow_its_source(make, dtype):
    source = np.array([1, 2, 3], dtype=np.int16)
    array = make(source)
    source[0] = 9
    assert array.dtype == dtype
    assert array.tolist() == [1, 2, 3]
    with pytest.raises(ValueError, match="read-only"):
        array[0] = 5


def test_a_narrow_integer_type_cannot_overflow_afterwards():
    assert (frozen(np.array([30000], dtype=np.int16)) * 10).tolist() == [300000.0]
