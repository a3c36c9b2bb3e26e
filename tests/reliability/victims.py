"""Programs that measure until something happens to them, in processes of their own.

``python -m tests.reliability.victims`` loads everything once and then makes a child of itself for
each line of JSON that it is given, so that a hundred kills take seconds. What a victim has been
promised, the way the screen would say it, it writes into a file of its own before it goes on.
"""

import ctypes
import json
import os
import signal
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.archive.store import Archive
from core.arrays import frozen, frozen_int
from core.certificates.certificate import parse_certificate
from core.certificates.register import Register
from core.errors import LabError
from core.records.atomic import write_text_atomic
from core.records.session.record import START_NAME
from core.records.session.store import Session
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel, SampleBlock
from drivers.decoders import make_decoder
from drivers.profile import load_profiles
from drivers.rawlog import RawLog
from drivers.reader import LinkState, Reader
from drivers.recorder import Recorder, RecordLayout
from drivers.transport import opener
from tests.reliability import seeds

CHANNELS = (Channel("number", "", "rate.z"),)
PIECE = 25
YEAR = 2026


class Promises:
    """What was said to be safe, a line each; whole lines survive a kill."""

    def __init__(self, path: Path) -> None:
        self._fd = os.open(path, os.O_CREAT | os.O_WRONLY | os.O_APPEND, 0o644)

    def add(self, text: object) -> None:
        """Say it."""
        os.write(self._fd, f"{text}\n".encode())


def promised(path: Path) -> list[str]:
    """What a victim was promised."""
    return path.read_text("utf-8").splitlines() if path.exists() else []


def measure(folder: Path, promises: Promises) -> None:
    """Accept positions of a session, also of one that another victim left."""
    begun = (folder / START_NAME).exists()
    session = Session.open(folder) if begun else Session.create(folder, seeds.start())
    rng = np.random.default_rng(len(session.positions))
    while True:
        for step in session.record.start.plan.steps:
            data = rng.normal(step.number, 1.0, (64, len(seeds.CHANNELS)))
            mean = accumulation_of(seeds.CHANNELS, np.arange(64) / 100.0, data)
            position = session.accept(step, mean, temperature_c=26.0)
            promises.add(f"{position.id} {float(mean.mean[0])!r}")


def record(folder: Path, promises: Promises) -> None:
    """Record numbered samples; promise those of which the recorder says that they are stored."""
    writer = Recorder(folder / "a.calrec", {}, RecordLayout(CHANNELS, 1000.0))
    for first in range(0, 10**9, PIECE):
        index = np.arange(first, first + PIECE)
        block = SampleBlock(CHANNELS, frozen_int(index), frozen(index[:, None] / 3.0), 1000.0)
        writer.take(index.astype("<i8").tobytes(), time.monotonic())
        writer.say(block)
        if first % (8 * PIECE) == 0 and writer.flush():
            promises.add(first + PIECE)


def certify(folder: Path, promises: Promises) -> None:
    """Issue certificates; each victim in turn withdraws nothing and numbers on."""
    register = Register(folder)
    one = parse_certificate(seeds.certificate().decode(), "seed")
    while True:
        issued, _ = register.issue(one.laboratory, YEAR, lambda n: replace(one, number=n))
        promises.add(issued.number)


def overwrite(folder: Path, promises: Promises) -> None:
    """Save a file again and again, a larger text each time."""
    for size in range(1, 10**6):
        write_text_atomic(folder / "a.cal.json", f"{size}\n" * size)
        promises.add(size)


def index(folder: Path, promises: Promises) -> None:
    """Read a folder of files into its index again and again."""
    while True:
        with Archive(folder) as archive:
            promises.add(archive.rebuild().taken)


def listen(folder: Path, promises: Promises) -> None:
    """Record what a port gives, until the file ``stop`` appears."""
    profile = load_profiles()[(folder / "profile").read_text("utf-8")]
    port = (folder / "port").read_text("utf-8")
    decoder = make_decoder(profile)
    reader = Reader(opener(port, profile.port), decoder, RawLog(folder / "raw.calrec", {}))
    header = {"profile_text": profile.text}
    layout = RecordLayout(decoder.channels, profile.nominal_hz)
    writer = reader.tap = Recorder(folder / "a.calrec", header, layout)
    reader.start()
    while reader.state is LinkState.OPENING:
        time.sleep(0.002)
    promises.add("open")
    told = 0
    while not (folder / "stop").exists():
        reader.drain()
        if reader.counters.frames != told:
            told = reader.counters.frames
            promises.add(f"heard {reader.counters.bytes} {told} {reader.counters.lost}")
        time.sleep(0.01)
    reader.close()
    writer.close()
    promises.add("ended")


VICTIMS: dict[str, Callable[[Path, Promises], None]] = {
    "measure": measure,
    "record": record,
    "certify": certify,
    "overwrite": overwrite,
    "index": index,
    "listen": listen,
}


def _child(order: dict[str, str]) -> None:
    """Be a victim; what it could not do stands behind its promises."""
    if sys.platform == "linux":
        # Its parent may be killed by the test's time limit: it must not stay behind.
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)
    promises = Promises(Path(order["promises"]))
    try:
        VICTIMS[order["victim"]](Path(order["folder"]), promises)
    except LabError as error:
        promises.add(f"refused: {error}")
    os._exit(0)


def main() -> None:
    """Serve orders until the end of standard input."""
    sys.stdout.write("ready\n")
    sys.stdout.flush()
    for line in sys.stdin:
        order = json.loads(line)
        if "wait" in order:
            os.waitpid(order["wait"], 0)
            answer = 0
        else:
            answer = os.fork()
            if answer == 0:
                _child(order)
        sys.stdout.write(f"{answer}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
