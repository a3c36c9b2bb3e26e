"""Short sounds that say which: start tick, two tones for done, a low tone for an error.

Made with the standard library at first use and played by the system's own player, so that four
beeps need no multimedia package. Nothing here waits.
"""

import array
import hashlib
import io
import math
import shutil
import sys
import wave
from enum import Enum
from pathlib import Path

from PySide6.QtCore import QObject, QProcess, QStandardPaths
from PySide6.QtGui import QGuiApplication

from core.errors import StorageError
from core.records.atomic import make_folder, write_bytes_atomic

RATE = 22_050
_FADE_S = 0.006
_PLAYERS = ("pw-play", "paplay", "aplay")
_QUIET = {"aplay": ["-q"]}


class Cue(Enum):
    """What is told; the value is the tones, Hz and s."""

    START = ((1400.0, 0.05),)
    DONE = ((880.0, 0.13), (1318.5, 0.22))
    ERROR = ((220.0, 0.35), (196.0, 0.35))


class Sounds(QObject):
    """Plays cues.

    Parameters
    ----------
    folder : where the sound files are kept; the user's cache by default
    """

    def __init__(self, folder: Path | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._folder = folder or _cache_folder()
        self._volume = 0.6
        self._player = _player()
        self._process: QProcess | None = None

    @property
    def volume(self) -> float:
        """Loudness, 0 (off) to 1."""
        return self._volume

    def set_volume(self, volume: float) -> None:
        """Set the loudness, 0 (off) to 1."""
        self._volume = min(1.0, max(0.0, volume))

    def play(self, cue: Cue) -> None:
        """Begin to play a cue and return; a cue that is still heard is cut off."""
        if self._volume <= 0.0:
            return
        try:
            path = sound_file(self._folder, cue, self._volume)
        except StorageError:
            # A full disk must not silence the operator's only cue across the room.
            self._beep()
            return
        if sys.platform == "win32":
            import winsound

            winsound.PlaySound(str(path), winsound.SND_FILENAME | winsound.SND_ASYNC)
        elif self._player:
            self._run(path)
        else:
            self._beep()

    def _run(self, path: Path) -> None:
        self.stop()
        process = QProcess(self)
        process.errorOccurred.connect(self._on_error)
        process.finished.connect(self._on_finished)
        self._process = process
        process.start(self._player, [*_QUIET.get(Path(self._player).name, []), str(path)])

    def stop(self) -> None:
        """End what is being played; call it before the program ends."""
        process, self._process = self._process, None
        if process is None:
            return
        process.errorOccurred.disconnect(self._on_error)
        process.finished.disconnect(self._on_finished)
        if process.state() is not QProcess.ProcessState.NotRunning:
            process.kill()
            process.waitForFinished(200)
        process.deleteLater()

    def _on_finished(self) -> None:
        process, self._process = self._process, None
        if process is not None:
            process.deleteLater()

    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart:
            self._player = ""
            self._beep()

    def _beep(self) -> None:
        beep = getattr(QGuiApplication.instance(), "beep", None)
        if beep is not None:
            beep()


def sound_file(folder: Path, cue: Cue, volume: float) -> Path:
    """Return the file of a cue at a loudness, made if it is not there yet.

    Raises
    ------
    StorageError
        It could not be written.
    """
    # The name holds what the sound is made of, so that a new version makes its own files.
    made_of = repr((cue.value, RATE, _FADE_S)).encode()
    mark = hashlib.sha256(made_of).hexdigest()[:8]
    path = folder / f"{cue.name.lower()}-{round(100 * volume)}-{mark}.wav"
    if not path.exists():
        make_folder(folder)
        write_bytes_atomic(path, wave_bytes(cue, volume))
    return path


def wave_bytes(cue: Cue, volume: float) -> bytes:
    """Return a cue as a WAV file: 16 bit, one channel."""
    samples = array.array("h")
    for frequency, seconds in cue.value:
        count = round(seconds * RATE)
        fade = _FADE_S * RATE
        for k in range(count):
            # Faded in and out, or each tone would begin and end with a click.
            envelope = min(1.0, k / fade, (count - k) / fade)
            tone = math.sin(2.0 * math.pi * frequency * k / RATE)
            samples.append(round(32767 * volume * envelope * tone))
    if sys.byteorder == "big":
        samples.byteswap()
    out = io.BytesIO()
    with wave.open(out, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(samples.tobytes())
    return out.getvalue()


def _cache_folder() -> Path:
    place = QStandardPaths.StandardLocation.CacheLocation
    return Path(QStandardPaths.writableLocation(place)) / "sounds"


def _player() -> str:
    """Path of the first player that the system has; empty for none."""
    return next((found for found in map(shutil.which, _PLAYERS) if found), "")
