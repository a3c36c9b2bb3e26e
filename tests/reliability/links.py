"""Faults of a link, at a real pseudo-terminal whose every whole frame is known by its number."""

import os
import random
import signal
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from core.arrays import IntArray
from core.records.session.record import read_session
from core.records.session.store import Session
from core.samples.accumulate import Accumulator
from core.samples.block import SampleBlock
from drivers.decoders import make_decoder
from drivers.encode import encode
from drivers.events import Message
from drivers.profile import Profile, load_profiles
from drivers.rawlog import Chunk, RawLog, read_rawlog
from drivers.reader import LinkState, Reader
from drivers.recorder import Recorder, RecordLayout
from drivers.recording import read_recording
from drivers.transport import opener
from drivers.virtual.pty_process import PtyProcess
from tests.benchmarks.soaking import soak
from tests.drivers.links import wait_for
from tests.reliability import seeds
from tests.reliability.fault import Found
from tests.reliability.nursery import Victim, nursery

if sys.platform != "win32":
    import tty

CVG = load_profiles()["cvgx48"]
COUNTED = load_profiles()["pw09_raw"]
_SPLIT = 1 << 15


class Port:
    """A pseudo-terminal that a test writes to, named by a lasting link."""

    def __init__(self, link: Path) -> None:
        self.link = link
        self.sent = 0
        self.plug_in()

    def plug_in(self) -> None:
        """Make the port appear."""
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        self.link.symlink_to(os.ttyname(self._slave))

    def send(self, data: bytes) -> None:
        """Write everything, however long the other end takes."""
        while data:
            taken = os.write(self._master, data[:1024])
            self.sent += taken
            data = data[taken:]

    def offer(self, data: bytes) -> int:
        """Write what finds room at once; return how much did."""
        os.set_blocking(self._master, False)
        try:
            taken = os.write(self._master, data)
        except BlockingIOError:
            taken = 0
        os.set_blocking(self._master, True)
        self.sent += taken
        return taken

    def unplug(self) -> None:
        """Pull the cable."""
        self.link.unlink()
        os.close(self._master)
        os.close(self._slave)


def frames(profile: Profile, numbers: IntArray) -> bytes:
    """Frames that hold their numbers."""
    width = len(make_decoder(profile).channels)
    values = np.zeros((len(numbers), width))
    values[:, 0], values[:, 1] = numbers % _SPLIT, numbers // _SPLIT
    return encode(profile, numbers, values)


def numbers_of(data: np.ndarray) -> np.ndarray:
    """The numbers that samples hold."""
    return (data[:, 1] * _SPLIT + data[:, 0]).astype(np.int64)


def astray(found: np.ndarray, sent: np.ndarray) -> int:
    """Numbers that are missing, doubled or foreign."""
    different = np.setxor1d(found, sent)
    return len(different) + len(found) - len(np.unique(found))


class Bench:
    """Reader, raw log and recorder at a port."""

    def __init__(self, folder: Path, port: Port, profile: Profile) -> None:
        decoder = make_decoder(profile)
        open_it = opener(str(port.link), profile.port)
        self.folder = folder
        header = {"profile_text": profile.text}
        log = RawLog(folder / "raw.calrec", header)
        self.reader = Reader(open_it, decoder, log, open_it)
        layout = RecordLayout(decoder.channels, profile.nominal_hz)
        self.recorder = self.reader.tap = Recorder(folder / "a.calrec", header, layout)
        self.shown: list[np.ndarray] = []
        self.messages: list[Message] = []
        self.reader.start()
        # To open a port empties it.
        wait_for(lambda: self.reader.state is LinkState.WAITING)

    def drain(self) -> Sequence[SampleBlock]:
        """Put on the screen what has come."""
        blocks: list[SampleBlock] = []
        for event in self.reader.drain():
            if isinstance(event, SampleBlock):
                blocks.append(event)
                self.shown.append(numbers_of(event.data))
            elif isinstance(event, Message):
                self.messages.append(event)
        return blocks

    def heard(self, count: int) -> None:
        """Wait until so many bytes were heard."""
        wait_for(lambda: self.reader.counters.bytes >= count, 30.0)

    def close(self) -> None:
        """End everything."""
        self.reader.close()
        self.recorder.close()
        self.drain()

    def astray(self, sent: np.ndarray) -> int:
        """Frames astray on the screen, among the samples of the record, and in its bytes."""
        shown = np.concatenate(self.shown) if self.shown else np.empty(0, dtype=np.int64)
        record = read_recording(self.folder / "a.calrec")
        again = read_recording(self.folder / "raw.calrec")
        _, stored = record.samples()
        _, decoded = again.samples()
        return sum(astray(n, sent) for n in (shown, numbers_of(stored), numbers_of(decoded)))


def pulled_while_recording(folder: Path, rng: random.Random, trials: int) -> Found:
    """The cable is pulled in the middle of a frame, again and again in one record."""
    port = Port(folder / "port")
    bench = Bench(folder, port, CVG)
    sent: list[np.ndarray] = []
    first, why = 0, ""
    for trial in range(trials + 1):
        numbers = np.arange(first, first + rng.randint(50, 900))
        data = frames(CVG, numbers)
        size = len(data) // len(numbers)
        cut = len(data) - rng.randrange(1, size) if trial < trials else len(data)
        port.send(data[:cut])
        sent.append(numbers[:-1] if trial < trials else numbers)
        bench.heard(port.sent)
        if trial < trials:
            port.unplug()
            wait_for(lambda: bench.reader.state is LinkState.RECONNECTING)
            port.plug_in()
            wait_for(lambda: bench.reader.state is not LinkState.RECONNECTING)
        first = int(numbers[-1]) + 1
        bench.drain()
    bench.close()
    why = next((m.fields["why"] for m in bench.messages if m.kind == "link lost"), "")
    lost = bench.astray(np.concatenate(sent))
    lost += abs(sum(m.kind == "link lost" for m in bench.messages) - trials)
    lost += abs(bench.reader.counters.reconnections - trials)
    port.unplug()
    return Found(trials, lost, why)


def pulled_while_accumulating(folder: Path, rng: random.Random, trials: int) -> Found:
    """The cable is pulled in mid-accumulation: that one is begun anew, all before are stored."""
    port = Port(folder / "port")
    bench = Bench(folder, port, CVG)
    rate, wanted = CVG.nominal_hz, 100
    profile = seeds.start()
    channels = make_decoder(CVG).channels
    start = seeds.start_of(channels, rate)
    accepted: list[tuple[int, float]] = []
    at = 0
    with Session.create(folder / "session", start) as session:
        for trial in range(trials):
            step = profile.plan.steps[trial % len(profile.plan.steps)]
            for whole in (False, True):
                accumulator = Accumulator(wanted / rate, rate)
                count = wanted if whole else rng.randint(1, wanted - 1)
                numbers = np.arange(at, at + count)
                at += count
                port.send(frames(CVG, numbers))
                bench.heard(port.sent)
                _show(bench, at, accumulator)
                if not whole:
                    port.unplug()
                    wait_for(lambda: bench.reader.state is LinkState.RECONNECTING)
                    port.plug_in()
                    wait_for(lambda: bench.reader.state is not LinkState.RECONNECTING)
                    continue
                assert accumulator.progress >= 1.0
                position = session.accept(step, accumulator.result())
                accepted.append((position.id, float(numbers.mean())))
    bench.close()
    port.unplug()
    stored = {
        p.id: _number(p.accumulation.mean) for p in read_session(folder / "session").positions
    }
    lost = sum(stored.get(number) != mean for number, mean in accepted)
    lost += abs(len(stored) - len(accepted)) + bench.astray(np.arange(at))
    return Found(trials, lost, "the accumulation is begun anew; all accepted positions are stored")


def _show(bench: Bench, count: int, accumulator: Accumulator) -> None:
    """Wait until so many samples are on the screen; accumulate them."""

    def shown() -> bool:
        for block in bench.drain():
            accumulator.feed(block)
        return sum(map(len, bench.shown)) >= count

    wait_for(shown)


def _number(mean: np.ndarray) -> float:
    return float(mean[1]) * _SPLIT + float(mean[0])


def wrong_baud(folder: Path, rng: random.Random, trials: int) -> Found:
    """Wrong speeds one after the other, then the right one: no frame is made up, none missed."""
    lost, said = 0, ""
    bauds = [9600, 19200, 38400, 57600, 230400, 460800]
    with PtyProcess("sim://cvg25?rate=1000&seed=5") as rig:
        for trial in range(trials):
            baud = bauds[trial % len(bauds)]
            log = folder / f"wrong {trial}.calrec"
            for speed in (baud, 0):
                path = log if speed else folder / f"right {trial}.calrec"
                decoder = make_decoder(CVG)
                reader = Reader(opener(rig.port, CVG.port, speed), decoder, RawLog(path, {}))
                reader.start()
                wait_for(lambda reader=reader: reader.counters.bytes > 6000, 30.0)
                time.sleep(rng.uniform(0.0, 0.1))
                reader.close()
                counters = reader.counters
                stored = sum(len(p.data) for p in read_rawlog(path) if isinstance(p, Chunk))
                lost += abs(stored - counters.bytes)
                if speed:
                    lost += counters.frames
                    heard = counters.garbage + counters.bad_checksum * 48
                    said = f"0 frames, {heard} of {counters.bytes} bytes belong to no frame"
                else:
                    lost += int(counters.frames < 100)
    return Found(trials, lost, said)


def garbage(folder: Path, rng: random.Random, trials: int) -> Found:
    """Flipped bits, halved and dropped frames, noise between, the cable pulled: minutes of it."""
    found = Found()
    for trial in range(trials):
        soaked = soak(0.05, folder / f"{trial}.calrec", cuts=1, seed=rng.randrange(10**6))
        lost = soaked.missing + soaked.doubled + soaked.foreign
        text = f"{soaked.damaged} damaged frames of {soaked.sent} counted and left out"
        found += Found(1, lost, text)
    return found


def suspended(folder: Path, rng: random.Random, trials: int) -> Found:
    """The program is stopped and goes on: what the port could keep is stored, the rest is told."""
    found = Found()
    for trial in range(trials):
        place = folder / f"{trial}"
        place.mkdir()
        port = Port(place / "tty")
        (place / "port").write_text(str(port.link), "utf-8")
        (place / "profile").write_text(COUNTED.id, "utf-8")
        victim = nursery().start("listen", place, place / "promises.txt")
        victim.wait_for(1)
        found += _stop_and_go(victim, port, place, rng)
    return found


def _stop_and_go(victim: Victim, port: Port, place: Path, rng: random.Random) -> Found:
    at = 0
    whole: list[np.ndarray] = []
    stops = rng.randint(40, 60)
    for turn in range(120):
        if turn == stops:
            victim.signal(signal.SIGSTOP)
        numbers = np.arange(at, at + 10)
        at += 10
        data = frames(COUNTED, numbers)
        size = len(data) // 10
        if turn < stops or turn >= stops + 30:
            port.send(data)
            whole.append(numbers)
        else:
            taken = port.offer(data)
            whole.append(numbers[: taken // size])
        if turn == stops + 30 - 1:
            victim.signal(signal.SIGCONT)
        time.sleep(0.004)
    until = time.monotonic() + 20.0
    while not any(line.startswith(f"heard {port.sent} ") for line in victim.told()):
        assert time.monotonic() < until, (port.sent, victim.told()[-1:])
        time.sleep(0.01)
    (place / "stop").touch()
    victim.wait()
    port.unplug()
    sent = np.concatenate(whole)
    record = read_recording(place / "a.calrec")
    index, data = record.samples()
    lost = astray(numbers_of(data), sent) + int(victim.told()[-1] != "ended")
    told = sum(gap.count for gap in record.gaps)
    # The numbers of the samples run with the device's counter, over the gap as well.
    lost += int(np.sum(np.diff(index) != np.diff(numbers_of(data))))
    lost += abs(told - (at - len(sent)))
    return Found(1, lost, f"{told} samples lost, told by the device's counter")
