"""Hours of frames with faults between: every good frame is in the record exactly once."""

import numpy as np
import pytest

from drivers.recording import read_recording
from drivers.records import open_record, record_means
from tests.benchmarks.soaking import soak

HOURS = 1
CUTS = 2


@pytest.mark.slow
def test_every_good_frame_is_in_the_record_exactly_once(tmp_path):
    path = tmp_path / "soak.calrec"
    found = soak(HOURS, path, cuts=CUTS)
    record = found.record
    assert found.damaged > 500
    assert (found.missing, found.doubled, found.foreign) == (0, 0, 0)
    assert found.heard == len(record) == found.sent - found.damaged
    assert found.reconnections == CUTS
    assert [event.kind for event in record.events].count("link lost") == CUTS
    index = record.index()
    assert sum(gap.count for gap in record.gaps) == int(index[-1] - index[0]) + 1 - len(index)
    again = read_recording(path, from_bytes=True)
    assert np.array_equal(again.column(0), record.column(0))
    assert abs(int(again.index()[-1]) - int(index[-1])) < 0.5 * CUTS * record.rate
    (mean,) = record_means(open_record(path))
    assert mean.n == len(index)
    assert mean.mean[1] == pytest.approx(record.column(1).mean(), rel=1e-12)
