"""Hours of frames with faults between: every good frame is in the record exactly once."""

import time

import numpy as np
import pytest

from drivers.decoders import make_decoder
from drivers.reader import Reader
from drivers.recorder import Recorder, RecordLayout, wire_item
from drivers.recording import read_recording
from drivers.records import open_record, record_means
from drivers.transport import opener
from drivers.virtual.address import rig_of
from tests.drivers.links import samples

HOURS = 1
CLEAN = "sim://cvg25?speed=max&block=20&seed=9"
URL = f"{CLEAN}&bit_error=1e-6&drop=2e-4&half=2e-4&garbage=2e-4&name=recorder_soak"


def sent(count):
    """The frames of the same unit on a line without faults."""
    rig = rig_of(CLEAN)
    decoder = make_decoder(rig.profile)
    events = [event for _ in range(0, count, 4000) for event in decoder.feed(rig.produce(4000))]
    return samples(events)[1][:count]


@pytest.mark.slow
def test_every_good_frame_is_in_the_record_exactly_once(tmp_path):
    rig = rig_of(URL)
    decoder = make_decoder(rig.profile)
    writer = Recorder(
        tmp_path / "soak.calrec",
        {"profile_text": rig.profile.text},
        RecordLayout(decoder.channels, rig.rate_hz, wire_item(rig.profile)),
    )
    reader = Reader(opener(URL, rig.profile.port), decoder)
    reader.tap = writer
    reader.start()
    while reader.counters.frames < HOURS * 3600 * rig.rate_hz:
        reader.drain()
        time.sleep(0.002)
    reader.close()
    writer.close()
    record = read_recording(tmp_path / "soak.calrec")
    index = record.index()
    made = round(rig.state.time_s * rig.rate_hz)
    damaged = rig.damaged()
    assert len(damaged) > 500
    good = np.setdiff1d(np.arange(made), damaged)
    # The last read may have left frames in the port, which nobody was told of.
    assert len(good) - len(index) < 25 * rig.rate_hz
    # The frame has no counter: what was sent is told by its values.
    assert np.array_equal(record.samples()[1], sent(made)[good[: len(index)]])
    assert reader.counters.frames == len(index) == len(record)
    assert sum(gap.count for gap in record.gaps) == int(index[-1] - index[0]) + 1 - len(index)
    again = read_recording(tmp_path / "soak.calrec", from_bytes=True)
    assert np.array_equal(again.index(), index)
    assert np.array_equal(again.column(0), record.column(0))
    (mean,) = record_means(open_record(tmp_path / "soak.calrec"))
    assert mean.n == len(index)
    assert mean.mean[0] == pytest.approx(record.column(0).mean(), rel=1e-12)
    assert 0.0 < mean.se[0] < 1e-4
