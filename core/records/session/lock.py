"""One program at a time measures into a session.

The operating system holds the lock and lets go of it when the program ends, however it ends, so
that a killed program leaves no stale lock behind.
"""

import contextlib
import json
import os
import socket
import sys
from datetime import UTC, datetime
from pathlib import Path

from core.errors import StorageError
from core.records.atomic import not_stored

if sys.platform == "win32":
    import msvcrt

    # Windows locks bytes against reading too: lock one far behind the text.
    _FAR = 1 << 20

    def _take(handle: int) -> None:
        os.lseek(handle, _FAR, os.SEEK_SET)
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        os.lseek(handle, 0, os.SEEK_SET)

else:
    import fcntl

    def _take(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


class SessionLock:
    """Holds a lock file until `release` or the end of the program.

    Parameters
    ----------
    path : the lock file; made if it does not exist, never removed

    Raises
    ------
    StorageError
        Another program holds it, or the file cannot be made.
    """

    def __init__(self, path: Path) -> None:
        try:
            self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        except OSError as error:
            raise not_stored(path, error, "what the session holds is untouched") from error
        try:
            _take(self._handle)
        except OSError as error:
            os.close(self._handle)
            raise StorageError(
                f"{path.parent}: another program is measuring into this session{_holder(path)};"
                " continue there, or close it and open the session again"
            ) from error
        # Who holds it is only for the message; the lock itself stands.
        with contextlib.suppress(OSError):
            os.ftruncate(self._handle, 0)
            os.write(self._handle, _who())

    def release(self) -> None:
        """Let other programs in."""
        if self._handle >= 0:
            with contextlib.suppress(OSError):
                os.ftruncate(self._handle, 0)
            os.close(self._handle)
            self._handle = -1


def _who() -> bytes:
    who = {
        "process": os.getpid(),
        "computer": socket.gethostname(),
        "since_utc": datetime.now(UTC).isoformat(timespec="seconds"),
    }
    return json.dumps(who).encode()


def _holder(path: Path) -> str:
    try:
        who = json.loads(path.read_bytes())
        return f" (process {who['process']} on {who['computer']} since {who['since_utc']} UTC)"
    except (OSError, ValueError, KeyError, TypeError):
        return ""
