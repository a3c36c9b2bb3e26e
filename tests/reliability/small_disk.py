"""One program on a disk that is full or may not be written to; it tells what was lost.

``python -m tests.reliability.small_disk WAY FOLDER ROOM KIND...`` prints for each kind of work what
was lost and the message. The ways: ``tmpfs`` (the folder is a small disk of its own), ``limit``
(files may grow by so many bytes, where nothing can be mounted), ``read-only``.
"""

import contextlib
import json
import os
import resource
import shutil
import signal
import sys
import time
from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.archive.store import Archive
from core.arrays import frozen, frozen_int
from core.certificates.certificate import Certificate, parse_certificate
from core.certificates.register import Register
from core.errors import LabError
from core.records.session.record import read_session
from core.records.session.store import Session
from core.samples.block import SampleBlock
from drivers.recorder import Recorder, RecordLayout
from drivers.recording import read_recording
from gui.settings import Settings
from tests.reliability import seeds
from tests.reliability.victims import CHANNELS, PIECE, YEAR

Room = Callable[[], None]
_MOST = 400
_SOMEBODY = 65534
_SMALL = 1000
_NEW_FILES = ("certificate", "index")
"""Work that makes new files: a limit to growth would never be met."""


@dataclass
class Task:
    """Work that needs room on the disk.

    Attributes
    ----------
    folder : where
    message : what was said when it could not go on
    """

    folder: Path
    message: str = ""

    def prepare(self) -> None:
        """What stands there before, while there is room."""

    def work(self) -> None:
        """Work until the disk refuses; sets `message`."""
        raise NotImplementedError

    def lost(self) -> int:
        """What was promised and is not there."""
        raise NotImplementedError

    def go_on(self) -> int:
        """Work on once there is room; return what of it is not there."""
        raise NotImplementedError


class Measuring(Task):
    """Positions of a session."""

    def prepare(self) -> None:
        self.accepted: list[int] = []
        with Session.create(self.folder / "s", seeds.start()) as session:
            self._accept(session)

    def _accept(self, session: Session) -> None:
        steps = session.record.start.plan.steps
        step = steps[len(self.accepted) % len(steps)]
        self.accepted.append(session.accept(step, seeds.mean(), temperature_c=26.0).id)

    def work(self) -> None:
        try:
            with Session.open(self.folder / "s") as session:
                for _ in range(_MOST):
                    self._accept(session)
        except LabError as error:
            self.message = str(error)

    def lost(self) -> int:
        stored = [position.id for position in read_session(self.folder / "s").positions]
        return int(stored != self.accepted)

    def go_on(self) -> int:
        with Session.open(self.folder / "s") as session:
            self._accept(session)
            assert session.legacy_path is not None
            rows = len(session.legacy_path.read_text("utf-8").splitlines())
            return self.lost() + abs(rows - len(self.accepted))


class Recording(Task):
    """A record: what finds no room waits in memory."""

    writer: Recorder | None = None
    said = 0

    def _begin(self) -> None:
        self.writer = Recorder(self.folder / "a.calrec", {}, RecordLayout(CHANNELS, 1000.0))

    def _say(self) -> None:
        assert self.writer is not None
        index = np.arange(self.said, self.said + PIECE)
        self.writer.take(index.astype("<i8").tobytes(), time.monotonic())
        data = frozen(index[:, None] / 3.0)
        self.writer.say(SampleBlock(CHANNELS, frozen_int(index), data, 1000.0))
        self.said += PIECE

    def work(self) -> None:
        try:
            self._begin()
        except LabError as error:
            self.message = str(error)
            return
        for _ in range(20 * _MOST):
            self._say()
            if not self.said % (20 * PIECE) and not self.writer.flush():
                break
        self.message = str(self.writer.error or "")
        for _ in range(20):
            self._say()

    def lost(self) -> int:
        """Nothing yet: what was refused is still held."""
        return 0

    def go_on(self) -> int:
        if self.writer is None:
            self._begin()
        assert self.writer is not None
        self._say()
        self.writer.close()
        assert self.writer.error is None
        index, data = read_recording(self.folder / "a.calrec").samples()
        wrong = int(np.sum(data[:, 0] != index / 3.0))
        return wrong + len(np.setxor1d(index, np.arange(self.said)))


class Certifying(Task):
    """Certificates."""

    def prepare(self) -> None:
        self.register = Register(self.folder / "certificates")
        self.one = parse_certificate(seeds.certificate().decode(), "seed")
        self.given: list[str] = []
        self._issue()

    def _issue(self) -> None:
        def made(number: str) -> Certificate:
            return replace(self.one, number=number)

        issued, _ = self.register.issue(self.one.laboratory, YEAR, made)
        self.given.append(issued.number)

    def work(self) -> None:
        try:
            for _ in range(_MOST):
                self._issue()
        except LabError as error:
            self.message = str(error)

    def lost(self) -> int:
        files = sorted(self.register.folder.iterdir())
        return int([self.register.read(path).number for path in files] != self.given)

    def go_on(self) -> int:
        self._issue()
        hole = self.given[-1] != f"{YEAR}-{len(self.given):04d}"
        return self.lost() + int(hole)


class Saving(Task):
    """Preferences, which grow."""

    def prepare(self) -> None:
        self.size = 0
        self.settings = Settings(self.folder / "settings.json")
        self._save()

    def _save(self) -> None:
        self.settings.store("a", {"text": "x" * (self.size + 500)})
        self.settings.save()
        self.size += 500

    def work(self) -> None:
        try:
            for _ in range(_MOST):
                self._save()
        except LabError as error:
            self.message = str(error)

    def lost(self) -> int:
        text = Settings(self.folder / "settings.json").section("a").get("text")
        return int(text != "x" * self.size)

    def go_on(self) -> int:
        self._save()
        return self.lost() + len(list(self.folder.glob(".*.tmp")))


class Indexing(Task):
    """The index of an archive."""

    def prepare(self) -> None:
        self._write(range(20))
        with Archive(self.folder) as archive:
            archive.refresh()
        self._write(range(20, 40))
        self.files = self._files()

    def _write(self, numbers: range) -> None:
        for number in numbers:
            content = seeds.calibration() + b"\n" * number
            (self.folder / f"{number}.cal.json").write_bytes(content)

    def _files(self) -> dict[str, bytes]:
        return {path.name: path.read_bytes() for path in self.folder.glob("*.cal.json")}

    def work(self) -> None:
        try:
            with Archive(self.folder) as archive:
                archive.refresh()
                self.message = "".join(note.text for note in archive.notes)
        except LabError as error:
            self.message = str(error)

    def lost(self) -> int:
        return int(self._files() != self.files)

    def go_on(self) -> int:
        with Archive(self.folder) as archive:
            archive.refresh()
            return self.lost() + abs(40 - archive.search().total)


TASKS: dict[str, type[Task]] = {
    "session": Measuring,
    "record": Recording,
    "certificate": Certifying,
    "file": Saving,
    "index": Indexing,
}


@contextlib.contextmanager
def filled_up(folder: Path, room: int) -> Generator[None, None, None]:
    """A small disk on which so many bytes are left."""
    ballast = folder / ".ballast"
    with ballast.open("wb", buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(4096))
    os.truncate(ballast, max(0, ballast.stat().st_size - room))
    yield
    ballast.unlink()


@contextlib.contextmanager
def limited(folder: Path, room: int) -> Generator[None, None, None]:
    """Files that may grow by so many bytes."""
    sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
    largest = max(sizes, default=0)
    whole = resource.getrlimit(resource.RLIMIT_FSIZE)
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    limit = _SMALL if folder.name in _NEW_FILES else largest + room
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, whole[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, whole)


@contextlib.contextmanager
def read_only(folder: Path, _: int) -> Generator[None, None, None]:
    """A folder that may be looked into; root may write anywhere and becomes somebody else."""
    everything = [folder, *folder.rglob("*")]
    for path in everything:
        path.chmod(0o555 if path.is_dir() else 0o444)
    root = os.geteuid() == 0
    if root:
        os.setresuid(_SOMEBODY, _SOMEBODY, 0)
    yield
    if root:
        os.setresuid(0, 0, 0)
    for path in everything:
        path.chmod(0o755 if path.is_dir() else 0o644)


WAYS = {"tmpfs": filled_up, "limit": limited, "read-only": read_only}


def tried(kind: str, way: str, folder: Path, room: int) -> tuple[int, str]:
    """Do the task; return what was lost, and the message."""
    folder.mkdir()
    task = TASKS[kind](folder)
    task.prepare()
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    with WAYS[way](folder, room):
        task.work()
        lost = task.lost()
        message = task.message.replace(str(folder), "FOLDER")
        after = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        changed = way == "read-only" and before != after
    lost += task.go_on() + int(not message) + int(changed)
    shutil.rmtree(folder)
    return lost, message


def main(way: str, folder: Path, room: int, *kinds: str) -> None:
    """Do the tasks and print what came of them."""
    for kind in kinds:
        lost, message = tried(kind, way, folder / kind, room)
        print(json.dumps({"kind": kind, "lost": lost, "message": message}))  # noqa: T201


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]), *sys.argv[4:])
