"""Free lists of rates, as the operator types them."""

from collections.abc import Sequence

from core.plans.plan import Step

MOUNTINGS: dict[str, tuple[str, ...]] = {
    "Z": ("Z_from",),
    "Y": ("Y_from",),
    "X": ("X_from",),
    "Z down": ("Z_to",),
    "X, Y, Z": ("X_from", "Y_from", "Z_from"),
}
"""Which axes stand upright in turn, by the word of the choice."""
_MOST_DPS = 1e5


def free_steps(
    rates: Sequence[float], mounts: Sequence[str], *, both_ways: bool
) -> tuple[Step, ...]:
    """Steps of a free list of rates.

    Parameters
    ----------
    rates : deg/s, in the order of measuring
    mounts : how the unit stands, one after another; all rates in each
    both_ways : whether the list is gone through backwards too, so that hysteresis shows
    """
    steps: list[Step] = []
    for mount in mounts:
        axis = mount[0]
        sweeps = [("rising" if both_ways else "", list(rates))]
        if both_ways:
            sweeps.append(("falling", list(reversed(rates))))
        for name, sweep in sweeps:
            group = f"Rotation Around {axis}, own list{f', {name}' if name else ''}"
            steps += [
                Step(len(steps) + place, group, mount, 0.0, rate, axis.lower())
                for place, rate in enumerate(sweep, start=1)
            ]
    return tuple(steps)


def usable(rates: Sequence[float]) -> bool:
    """Whether a list of rates can be measured and determines a line."""
    return len(set(rates)) >= 2 and all(abs(rate) <= _MOST_DPS for rate in rates)
