"""The laboratory's file: read when it is first asked for, written a moment after typing ends."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

from core.certificates.laboratory import FILE, Laboratory, read_laboratory, write_laboratory
from core.errors import FormatError, LabError

_KEEP_MS = 1000


class LaboratoryKeeper(QObject):
    """The laboratory of a folder of sessions.

    Parameters
    ----------
    root : returns the folder
    """

    failed = Signal(str, object)
    """``"read"`` or ``"write"``, and the `LabError`."""

    def __init__(self, root: Callable[[], Path], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._root = root
        self._laboratory: Laboratory | None = None
        self._waiting = False
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_KEEP_MS)
        self._timer.timeout.connect(self.flush)

    @property
    def laboratory(self) -> Laboratory:
        """As it is now; an empty one where the file cannot be read, which stays as it is."""
        if self._laboratory is None:
            self._laboratory = Laboratory()
            try:
                self._laboratory = read_laboratory(self._root() / FILE)
            except FormatError as error:
                self.failed.emit("read", error)
        return self._laboratory

    def take(self, laboratory: Laboratory) -> None:
        """Keep another one."""
        self._laboratory = laboratory
        self._waiting = True
        self._timer.start()

    def flush(self) -> None:
        """Write what waits to be written."""
        self._timer.stop()
        if self._waiting and self._laboratory is not None:
            self._waiting = False
            try:
                write_laboratory(self._laboratory, self._root() / FILE)
            except LabError as error:
                self.failed.emit("write", error)
