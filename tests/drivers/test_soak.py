"""Hours of frames with faults between, through rig, port, reader, raw log and decoder."""

import time

import numpy as np
import pytest

from core.samples.block import SampleBlock
from drivers.decoders import make_decoder
from drivers.events import BadChecksum, Ended
from drivers.rawlog import Chunk, RawLog, read_rawlog
from drivers.reader import Reader
from drivers.transport import opener
from drivers.virtual.address import rig_of

HOURS = 2
URL = (
    "sim://clbacc?speed=max&block=20&seed=8&name=soak"
    "&bit_error=1e-6&drop=2e-4&half=2e-4&garbage=2e-4"
)


def indices(events) -> list[np.ndarray]:
    return [event.index for event in events if isinstance(event, SampleBlock)]


@pytest.mark.slow
def test_every_good_frame_is_there_exactly_once(tmp_path):
    rig = rig_of(URL)
    path = tmp_path / "soak.calrec"
    reader = Reader(opener(URL, rig.profile.port), make_decoder(rig.profile), RawLog(path, {}))
    reader.start()
    parts, bad, frames = [], 0, 0
    wanted = HOURS * 3600 * rig.rate_hz
    events: list = []
    while frames < wanted:
        events = reader.drain()
        parts += indices(events)
        bad += sum(event.count for event in events if isinstance(event, BadChecksum))
        frames = sum(map(len, parts))
        time.sleep(0.002)
    reader.close()
    events = reader.drain()
    assert events[-1] == Ended(None)
    parts += indices(events)
    bad += sum(event.count for event in events if isinstance(event, BadChecksum))
    heard = np.concatenate(parts)
    made = round(rig.state.time_s * rig.rate_hz)
    damaged = rig.damaged()
    assert len(damaged) > 1000
    good = np.setdiff1d(np.arange(made), damaged)
    first = good[0] - heard[0]
    # The last read may have left frames in the port, which nobody was told of.
    assert np.array_equal(heard + first, good[: len(heard)])
    assert len(good) - len(heard) < 25 * rig.rate_hz
    assert bad > 100
    assert reader.counters.frames == len(heard)
    # The recording decodes to the same.
    decoder = make_decoder(rig.profile)
    again = [
        index
        for part in read_rawlog(path)
        if isinstance(part, Chunk)
        for index in indices(decoder.feed(part.data))
    ]
    assert np.array_equal(np.concatenate(again), heard)
