"""Notices that this program stood still: the computer slept, or somebody stopped the process.

The monotonic clock of Linux stands still while the computer sleeps; the one used here goes on.
"""

import time
from collections.abc import Callable

LEAST_S = 3.0
"""Shorter pauses are those of a busy computer; the buffers of the port outlast them."""


def waking_clock() -> float:
    """Seconds that go on through sleep."""
    boot = getattr(time, "CLOCK_BOOTTIME", None)
    return time.monotonic() if boot is None else time.clock_gettime(boot)


class Pauses:
    """To be asked again and again, at least each tenth of a second.

    Parameters
    ----------
    clock : returns seconds
    """

    def __init__(self, clock: Callable[[], float] = waking_clock) -> None:
        self._clock = clock
        self._last = clock()

    def begin(self) -> None:
        """Count from now on."""
        self._last = self._clock()

    def seconds(self) -> float:
        """Seconds since it was asked the last time; 0 if that was no pause."""
        last, self._last = self._last, self._clock()
        since = self._last - last
        return since if since >= LEAST_S else 0.0
