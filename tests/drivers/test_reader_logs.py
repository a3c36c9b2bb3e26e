"""What the reader leaves on the disk: replay, a failing disk, a killed recorder."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from core.errors import StorageError
from drivers.decoders import Decoder, make_decoder
from drivers.events import BadChecksum, Ended, Event, Garbage, Lost
from drivers.framing import BlockWriter
from drivers.rawlog import Chunk, RawLog, read_rawlog
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.address import rig_of
from tests.drivers.links import CVG, Letters, finish, samples, sim_reader, wait_for


def test_replay_gives_the_same_events(tmp_path):
    path = tmp_path / "run.calrec"
    url = "name=recorded&speed=10&bit_error=1e-4&garbage=0.01&half=0.01"
    reader = sim_reader(url, raw_log=RawLog(path, {"profile": "cvgx48"}))
    reader.start()
    wait_for(lambda: reader.counters.frames > 3000)
    reader.close()
    original = reader.drain()
    again = Reader(opener(f"replay://{path}?speed=max"), make_decoder(CVG))
    replayed = finish(again)
    assert replayed[-1] == Ended(None)
    for one, other in zip(samples(original), samples(replayed), strict=True):
        assert np.array_equal(one, other)
    for kind in (Garbage, BadChecksum, Lost):
        counts = [sum(e.count for e in events if isinstance(e, kind)) for events in
                  (original, replayed)]  # fmt: skip
        assert counts[0] == counts[1] > 0


def test_replay_keeps_the_recorded_times(tmp_path):
    path = tmp_path / "run.calrec"
    log = RawLog(path, {})
    zero = time.monotonic()
    for step in range(5):
        log.write(b"abcd", zero + step * 0.2)
    log.close()
    for speed, expected in ((1.0, 0.8), (4.0, 0.2)):
        began = time.monotonic()
        events = finish(Reader(opener(f"replay://{path}?speed={speed}"), Letters()))
        assert time.monotonic() - began == pytest.approx(expected, abs=0.15)
        assert len(samples(events)[0]) == 20


def test_replay_of_what_is_no_log(tmp_path):
    path = tmp_path / "x.calrec"
    path.write_bytes(b"no log at all" * 100)
    (ended,) = finish(Reader(opener(f"replay://{path}"), Letters()))
    assert isinstance(ended, Ended)
    assert "CALREC1" in str(ended.error)
    (ended,) = finish(Reader(opener(f"replay://{path}.none"), Letters()))
    assert isinstance(ended, Ended)
    assert "no such port" in str(ended.error)


def test_a_failing_disk_does_not_stop_the_samples(tmp_path, monkeypatch):
    log = RawLog(tmp_path / "run.calrec", {})
    reader = sim_reader("name=disk&speed=5", raw_log=log)
    reader.start()
    wait_for(lambda: reader.counters.frames > 50)
    assert reader.storage_error is None
    reader.sync()

    def full(_self, _tag, _payload):
        raise StorageError("cannot be written: No space left on device")

    with monkeypatch.context() as broken:
        broken.setattr(BlockWriter, "append", full)
        wait_for(lambda: reader.storage_error is not None)
        frames = reader.counters.frames
        wait_for(lambda: reader.counters.frames > frames + 200)
        with pytest.raises(StorageError, match="No space left"):
            reader.sync()
    wait_for(lambda: reader.storage_error is None)
    reader.close()
    raw = b"".join(part.data for part in read_rawlog(log.path) if isinstance(part, Chunk))
    assert len(raw) == reader.counters.bytes


RECORDER = """
import sys, time
from pathlib import Path
from drivers.decoders import make_decoder
from drivers.rawlog import RawLog
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.address import rig_of
url = "sim://cvg25?speed=20&seed=9"
profile = rig_of(url).profile
log = RawLog(Path(sys.argv[1]), {})
reader = Reader(opener(url, profile.port), make_decoder(profile), log)
reader.start()
while True:
    seen = sum(len(e.index) for e in reader.drain() if hasattr(e, "index"))
    sys.stdout.write(f"{seen}\\n")
    sys.stdout.flush()
    time.sleep(0.02)
"""


def test_killed_recorder_has_stored_every_sample_that_it_showed(tmp_path):
    path = tmp_path / "run.calrec"
    process = subprocess.Popen(
        [sys.executable, "-c", RECORDER, str(path)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    shown = 0
    while shown < 3000:
        shown += int(process.stdout.readline())
    process.send_signal(signal.SIGKILL)
    shown += sum(map(int, process.stdout.read().split()))
    process.wait()
    process.stdout.close()
    decoder: Decoder = make_decoder(CVG)
    events: list[Event] = []
    for part in read_rawlog(Path(path)):
        if isinstance(part, Chunk):
            events += decoder.feed(part.data)
    index, data = samples(events)
    assert len(index) >= shown
    assert np.all(np.diff(index) == 1)
    same = make_decoder(CVG).feed(rig_of("sim://cvg25?speed=max&seed=9").produce(len(data)))
    assert np.array_equal(data, samples(same)[1])
