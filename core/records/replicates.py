"""Which pass of the same position a row is."""

from collections.abc import Hashable, Sequence

from core.arrays import IntArray, frozen_int


def replicates(keys: Sequence[Hashable]) -> IntArray:
    """Count for each row (n,) how often its key has come so far, from 1."""
    seen: dict[str, int] = {}
    counts: list[int] = []
    for key in keys:
        # NaN is not equal to itself; as text every missing value is the same.
        text = repr(key)
        seen[text] = seen.get(text, 0) + 1
        counts.append(seen[text])
    return frozen_int(counts)
