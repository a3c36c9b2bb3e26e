"""Python's cyclic garbage is collected in the window's thread alone.

Python collects in whichever thread happens to allocate. A reader or a worker that comes upon a
dead widget or timer in a reference cycle would destroy it in its own thread, and Qt crashes.
"""

import gc

from PySide6.QtCore import QObject, QTimer

_PERIOD_MS = 500


class Collector(QObject):
    """Collects by Python's own thresholds, on a timer of the thread that it is made in.

    Nothing is collected while the program starts, when hardly anything dies. What exists when
    `settle` is called is looked at no more, so that a full collection does not stop the window for
    a tenth of a second.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self.collect)

    def settle(self) -> None:
        """The program has started: what is there now stays, and what comes is collected."""
        gc.collect()
        gc.freeze()
        self._timer.start(_PERIOD_MS)

    def collect(self) -> None:
        """Collect the oldest generation whose time has come."""
        due = (
            count > limit for count, limit in zip(gc.get_count(), gc.get_threshold(), strict=True)
        )
        oldest = max((number for number, is_due in enumerate(due) if is_due), default=None)
        if oldest is not None:
            gc.collect(oldest)

    def close(self) -> None:
        """Leave collecting to Python again; may be called again."""
        self._timer.stop()
        gc.unfreeze()
        gc.enable()
