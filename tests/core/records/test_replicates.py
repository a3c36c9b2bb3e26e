import math

from core.records.replicates import replicates


def test_equal_keys_are_counted():
    keys = [("X", 0.0, math.nan), ("X", 90.0, math.nan), ("X", 0.0, math.nan), ("Y", 0.0, 27.0)]
    assert replicates(keys).tolist() == [1, 1, 2, 1]
    assert replicates([]).tolist() == []
