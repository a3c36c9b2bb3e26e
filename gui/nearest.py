"""The calibration nearest by date and temperature, looked up in the archive of the folder."""

import math
from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from core.archive.nearest import Usable, usable


class NearestCalibrations:
    """Asks the archive; may take as long as its database and its folder take: for a worker.

    Parameters
    ----------
    root : returns the folder of all sessions
    """

    def __init__(self, root: Callable[[], Path]) -> None:
        self._root = root

    def find(
        self, device: str, when: datetime, temperature_c: float = math.nan, sensor: str = ""
    ) -> tuple[Usable, ...]:
        """Return the calibrations of a device whose files stand here, the nearest first.

        Raises
        ------
        LabError
            The archive cannot be opened or read.
        """
        # The database is imported by the first question, not by the start of the window.
        from core.archive.store import Archive
        from gui.archive.raw import RAW_READERS

        root = self._root()
        if not device or not root.is_dir():
            return ()
        with Archive(root, more=RAW_READERS) as archive:
            archive.refresh()
            return usable(archive, device, when, temperature_c, sensor=sensor)
