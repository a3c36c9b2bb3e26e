"""The latest bytes of a port, kept on disk as they come, or of a file."""

from datetime import datetime
from pathlib import Path

from core.errors import FormatError, LinkError, StorageError
from core.records.atomic import make_folder
from core.version import SOFTWARE
from drivers.events import Ended
from drivers.profile_types import PortSettings
from drivers.rawlog import Chunk, RawLog, rawlog_header, read_rawlog
from drivers.reader import Reader
from drivers.records import is_recording
from drivers.teach.ear import KEPT, Ear, Heard
from drivers.transport import opener

_SUFFIX = ".calrec"


class Listening:
    """One port that is listened to; nothing is sent.

    Parameters
    ----------
    url, baud : where
    folder : of the raw logs
    """

    def __init__(self, url: str, baud: int, folder: Path) -> None:
        self.ear = Ear(port=url)
        self.error: LinkError | None = None
        """Why nothing more will come; None while it may."""
        self.raw_doubt: StorageError | None = None
        """Why nothing is recorded; None while it is."""
        self.ended = False
        port = PortSettings((baud,), 8, "N", 1, 0, dtr=False, rts=False)
        self._log = self._open_log(url, baud, folder)
        self._reader = Reader(opener(url, port, baud), self.ear, self._log)
        self._reader.start()

    @property
    def heard(self) -> Heard:
        """What has come."""
        for event in self._reader.drain():
            if isinstance(event, Ended):
                self.ended, self.error = True, event.error
        return self.ear.heard

    def close(self) -> None:
        """Let go of the port; raises `LinkError` if the driver does not."""
        self._reader.close()

    def _open_log(self, url: str, baud: int, folder: Path) -> RawLog | None:
        header = {"device": "unknown board", "port": url, "baud": baud, "software": SOFTWARE}
        stem = f"{datetime.now():%Y%m%d-%H%M%S-%f}_teach"
        try:
            make_folder(folder)
            return RawLog(folder / f"{stem}{_SUFFIX}", header)
        except StorageError as error:
            self.raw_doubt = error
        return None


def heard_in(path: Path) -> Heard:
    """Return what a file holds: a raw log, a recording, or plain bytes; for a worker thread.

    Raises
    ------
    FormatError
        It cannot be read, or holds nothing.
    """
    if not is_recording(path):
        try:
            with path.open("rb") as file:
                size = path.stat().st_size
                file.seek(max(0, size - KEPT))
                heard = Heard(file.read(), size)
        except OSError as error:
            raise FormatError(path, f"cannot be read: {error.strerror}") from error
    else:
        chunks = (item for item in read_rawlog(path) if isinstance(item, Chunk))
        first = next(chunks, Chunk(0.0, b""))
        tail, total, last = first.data, len(first.data), first.t
        for chunk in chunks:
            last = chunk.t
            total += len(chunk.data)
            tail = (tail + chunk.data)[-KEPT:]
        header = rawlog_header(path)
        baud = header.get("baud")
        heard = Heard(
            tail,
            total,
            last - first.t,
            total - len(first.data),
            str(header.get("port", "")),
            baud if isinstance(baud, int) else 0,
        )
    if not heard.tail:
        raise FormatError(path, "holds no bytes of a device")
    return heard
