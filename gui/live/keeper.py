"""The record on the disk: started, stopped, resumed, discarded."""

import math
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from core.errors import FormatError, LabError, Severity, StorageError
from core.records.atomic import make_folder
from core.records.cvgcom import CvgcomHead
from core.records.cvgcom_name import SUFFIX as TEXT_SUFFIX
from core.records.cvgcom_name import folder_of, next_name
from core.records.cvgcom_writer import CvgcomWriter
from core.records.names import safe_name
from core.samples.block import Channel
from drivers.recorder import Recorder, RecordLayout, wire_item
from drivers.recording import SUFFIX
from gui.devices.link import Link
from gui.jobs import Jobs
from gui.live.settings import LiveSettings
from gui.live.space import enough, growth, lasting, room, warning
from gui.messages import Messages

DISCARDED = "discarded"
SOURCE = "record"
DISK = "disk"
_LOOK_S = 5.0


class Keeper(QObject):
    """One record at a time.

    Parameters
    ----------
    root : returns the folder of all sessions
    jobs : moves what is discarded, after its file is closed
    messages : where troubles are told
    """

    discarded = Signal(str)
    """Name of a record that was put aside."""

    def __init__(
        self,
        root: Callable[[], Path],
        jobs: Jobs,
        messages: Messages,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._root = root
        self._jobs = jobs
        self._messages = messages
        self.recorder: Recorder | None = None
        self.link: Link | None = None
        self._files: tuple[Path, ...] = ()
        self._told = ""
        self._ending: list[Recorder] = []
        self._growth = 0.0
        self._looked = -math.inf
        self.lasting = ""
        """How long the disk lasts while recording, in words."""

    @property
    def recording(self) -> bool:
        """Whether samples go to the disk now."""
        return self.recorder is not None and not self.recorder.held

    def folder(self, serial: str) -> Path:
        """Where records of a device stand."""
        return folder_of(self._root(), serial)

    def propose(self, serial: str, settings: LiveSettings) -> str:
        """Name of the next record, without suffix."""
        return next_name(
            self.folder(serial), serial, static=settings.static, profile=settings.profile
        ).stem

    def start(
        self,
        link: Link,
        channels: tuple[Channel, ...],
        serial: str,
        stem: str,
        settings: LiveSettings,
    ) -> None:
        """Begin a record.

        Raises
        ------
        StorageError
            A file exists or cannot be made, or the disk is full within a minute.
        """
        self.end()
        folder = self.folder(serial)
        self._growth = growth(link, channels, settings)
        enough(room(folder, self._growth))
        self._looked = -math.inf
        make_folder(folder)
        path = folder / f"{safe_name(stem)}{SUFFIX}"
        rate = link.rate_hz
        text = self._text(path.with_name(path.stem + TEXT_SUFFIX), channels, rate, settings)
        header = {
            **link.header,
            "device": serial,
            "settings": {
                "static": settings.static,
                "profile": settings.profile,
                "scale_factor": settings.scale_factor,
                "sampling_hz": settings.sampling_hz,
            },
        }
        layout = RecordLayout(channels, rate, wire_item(link.profile))
        self.recorder = Recorder(path, header, layout, text)
        self._files = (path,) if text is None else (path, text.path)
        self._told = ""
        self.link = link
        link.tap(self.recorder)

    def _text(
        self, path: Path, channels: tuple[Channel, ...], rate: float, settings: LiveSettings
    ) -> CvgcomWriter | None:
        if not settings.text:
            return None
        frames = max(1, round(rate / settings.sampling_hz))
        return CvgcomWriter(
            path, CvgcomHead(frames / rate, settings.scale_factor, channels), frames
        )

    def stop(self) -> None:
        """Stop at once; the record can be resumed."""
        if self.recorder is not None:
            self.recorder.hold()

    def resume(self) -> None:
        """Go on with the stopped record."""
        if self.recorder is not None:
            self.recorder.go_on()

    def end(self) -> None:
        """End the record for good; its thread closes the file."""
        if self.recorder is None:
            return
        if self.link is not None:
            self.link.tap(None)
        self.recorder.end()
        self._ending.append(self.recorder)
        self.recorder, self.link = None, None
        self._messages.clear(DISK)

    def close(self) -> None:
        """End the record and wait for it."""
        recorder = self.recorder
        self.end()
        if recorder is not None:
            recorder.close()

    def discard(self) -> None:
        """Put the stopped record aside, into a folder of discarded ones; nothing is deleted."""
        recorder, files = self.recorder, self._files
        self.end()
        if recorder is not None:
            self._jobs.start(
                "discard", lambda: _put_aside(recorder, files), self._on_done, self._on_failed
            )

    def mark(self, number: int, note: str) -> None:
        """Note an event in the record."""
        if self.recorder is not None:
            self.recorder.mark(number, note)

    def watch(self) -> None:
        """Tell of a disk that refuses or will; what was written stays readable."""
        self._look_at_ended()
        recorder = self.recorder
        if recorder is None:
            self.lasting = ""
            return
        self._look_at_disk(recorder.path.parent)
        error = recorder.error or recorder.text_error
        told = "" if error is None else str(error)
        if told == self._told:
            return
        self._told = told
        if error is None:
            self._messages.clear(SOURCE)
        else:
            what = "Samples are not recorded" if recorder.error else "CVGCom's file ends here"
            self._messages.tell_error(SOURCE, what, error)

    def _look_at_ended(self) -> None:
        """Tell what of an ended record found no room; its thread writes the last of it."""
        for recorder in [one for one in self._ending if one.closed]:
            self._ending.remove(recorder)
            error = recorder.error or recorder.text_error
            if error is not None:
                what = "The end of the record is not stored"
                self._messages.tell_error(SOURCE, what, error)

    def _look_at_disk(self, folder: Path) -> None:
        now = time.monotonic()
        if now - self._looked < _LOOK_S:
            return
        self._looked = now
        try:
            left = room(folder, self._growth)
        except StorageError as error:
            self._messages.log(Severity.WARNING, str(error), DISK)
            return
        self.lasting = lasting(left.seconds)
        banner = warning(left) if self.recording else None
        if banner is None:
            self._messages.clear(DISK)
        else:
            self._messages.show(DISK, banner)

    def _on_done(self, name: object) -> None:
        self.discarded.emit(str(name))

    def _on_failed(self, error: LabError) -> None:
        self._messages.tell_error(SOURCE, "The record stays where it was", error)


def _put_aside(recorder: Recorder, files: tuple[Path, ...]) -> str:
    recorder.close()
    folder = recorder.path.parent / DISCARDED
    try:
        folder.mkdir(exist_ok=True)
        for path in files:
            target = folder / path.name
            number = 2
            while target.exists():
                target = folder / f"{path.stem}_{number}{path.suffix}"
                number += 1
            path.rename(target)
    except OSError as error:
        raise FormatError(folder, f"cannot take the record: {error.strerror}") from error
    return recorder.path.name
