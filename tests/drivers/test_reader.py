"""The reader on the simulated rig, on real pseudo-terminals and on sources made for the purpose."""

import threading
import time
from pathlib import Path

import numpy as np
import pytest

from core.errors import LinkError
from drivers.decoders import make_decoder
from drivers.events import BadChecksum, Ended, Garbage, Lost, Message
from drivers.rawlog import Mark, RawLog, read_rawlog
from drivers.reader import LinkState, Reader
from drivers.transport import EndOfStream, opener
from drivers.virtual.address import rig_of
from drivers.virtual.pty_process import PtyProcess
from tests.drivers.links import CVG, Letters, Script, finish, samples, sim_reader, wait_for


def test_events_come_in_order_and_ended_is_the_last():
    script = Script([b"ab", b"12", b"c", 0.01, EndOfStream()])
    events = finish(Reader(lambda: script, Letters()))
    assert [type(event).__name__ for event in events] == [
        "SampleBlock",
        "Garbage",
        "SampleBlock",
        "Ended",
    ]
    assert events[-1] == Ended(None)
    assert script.closed == 1
    assert samples(events)[0].tolist() == [0, 1, 2]


@pytest.mark.parametrize("end", [EndOfStream(), LinkError("script", "the port vanished")])
def test_half_a_frame_at_the_end_is_accounted_for(end):
    frames = rig_of("sim://cvg25?name=end&speed=max").produce(3)
    events = finish(Reader(lambda: Script([frames[:100], frames[100:120], end]), make_decoder(CVG)))
    assert len(samples(events)[0]) == 2
    assert sum(event.count for event in events if isinstance(event, Garbage)) == 24
    assert isinstance(events[-1], Ended)


def test_a_vanished_port_ends_with_the_reason():
    lost = LinkError("script", "the port vanished")
    events = finish(Reader(lambda: Script([b"ab", lost]), Letters()))
    assert events[-1] == Ended(lost)


def test_a_port_that_does_not_open_ends_with_the_reason():
    error = LinkError("COM9", "the port is busy")

    def refuse():
        raise error

    assert finish(Reader(refuse, Letters(), reopener=refuse)) == [Ended(error)]


def test_an_error_of_ours_ends_the_link_and_is_not_hidden(monkeypatch):
    seen = []
    monkeypatch.setattr(threading, "excepthook", lambda args: seen.append(args.exc_type))
    script = Script([b"ab", b"!"])
    events = finish(Reader(lambda: script, Letters()))
    ended = events[-1]
    assert isinstance(ended, Ended)
    assert "ZeroDivisionError" in str(ended.error)
    assert seen == [ZeroDivisionError]
    assert script.closed == 1


def test_close_is_idempotent_and_from_any_state():
    never = Reader(lambda: Script([]), Letters())
    never.close()
    never.close()
    script = Script([b"ab"])
    reader = Reader(lambda: script, Letters())
    reader.start()
    wait_for(lambda: reader.counters.frames == 2)
    reader.write(b"last words")
    wait_for(lambda: script.written == b"last words")
    closers = [threading.Thread(target=reader.close) for _ in range(4)]
    for closer in closers:
        closer.start()
    for closer in closers:
        closer.join()
    reader.close()
    assert reader.state is LinkState.ENDED
    assert script.closed == 1
    assert [event for event in reader.drain() if isinstance(event, Ended)] == [Ended(None)]


def test_counters_and_states(monkeypatch):
    reader = sim_reader("name=counters&drop=0.02&bit_error=2e-4&speed=5")
    assert reader.state is LinkState.OPENING
    reader.start()
    wait_for(lambda: reader.state is LinkState.STREAMING)
    wait_for(lambda: reader.counters.frames > 2000)
    counters = reader.counters
    assert counters.bytes > counters.frames * 48
    assert counters.bad_checksum > 0
    assert counters.lost > 0
    assert counters.silent_s < 0.5
    assert counters.measured_hz == pytest.approx(1000.0, rel=0.05)
    reader.close()
    events = reader.drain()
    count = {kind: sum(e.count for e in events if isinstance(e, kind)) for kind in
             (BadChecksum, Lost, Garbage)}  # fmt: skip
    final = reader.counters
    assert final.bad_checksum == count[BadChecksum]
    assert (final.lost, final.garbage) == (count[Lost], count[Garbage])
    assert final.frames == len(samples(events)[0])


def test_silence_is_no_data_and_not_the_end():
    url = "sim://pointer?name=silence"
    profile = rig_of(url).profile
    reader = Reader(opener(url, profile.port), make_decoder(profile))
    reader.start()
    wait_for(lambda: reader.state is LinkState.STREAMING)
    reader.write(profile.commands["stop"].data)
    wait_for(lambda: reader.state is LinkState.NO_DATA, 3.0)
    assert reader.counters.silent_s > 1.0
    reader.close()


def test_a_patient_source_waits_for_its_listener():
    reader = sim_reader("name=patient&speed=max")
    reader.start()
    wait_for(lambda: reader.counters.frames > 300)
    time.sleep(0.3)
    stalled = reader.counters.frames
    time.sleep(0.2)
    assert reader.counters.frames == stalled
    reader.drain()
    wait_for(lambda: reader.counters.frames > stalled)
    reader.close()
    index, _ = samples(reader.drain())
    assert np.all(np.diff(index) == 1)


def test_nothing_is_lost_while_the_window_stands_still_for_two_seconds():
    with PtyProcess("sim://cvg25?rate=1000&seed=5") as rig:
        reader = Reader(opener(rig.port, CVG.port), make_decoder(CVG))
        reader.start()
        wait_for(lambda: reader.counters.frames > 100)
        until = time.monotonic() + 2.0
        while time.monotonic() < until:
            sum(range(20000))  # the window computes and never drains
        reader.close()
        events = reader.drain()
        index, _ = samples(events)
        assert len(index) > 2000
        assert np.all(np.diff(index) == 1)
        assert not [event for event in events if isinstance(event, Lost | BadChecksum)]
        assert sum(event.count for event in events if isinstance(event, Garbage)) < 2 * 48
        assert rig.order(state=True)["overrun"] == 0


def test_unplugging_in_the_middle():
    with PtyProcess("sim://cvg25") as rig:
        reader = Reader(opener(rig.port, CVG.port), make_decoder(CVG))
        reader.start()
        wait_for(lambda: reader.counters.frames > 50)
        rig.order(unplug=True)
        wait_for(lambda: reader.state is LinkState.ENDED)
        *_, ended = reader.drain()
        assert isinstance(ended, Ended)
        assert "vanished" in str(ended.error)
        reader.close()


def test_the_same_adapter_is_taken_up_again_with_a_gap(tmp_path):
    link = tmp_path / "ttyGYRO"
    with PtyProcess("sim://cvg25", link) as rig:
        path = tmp_path / "run.calrec"
        opening = opener(rig.port, CVG.port)
        reader = Reader(opening, make_decoder(CVG), RawLog(path, {}), reopener=opening)
        reader.start()
        wait_for(lambda: reader.counters.frames > 100)
        rig.order(unplug=True)
        wait_for(lambda: reader.state is LinkState.RECONNECTING)
        time.sleep(1.5)
        rig.order(plug_in=True)
        wait_for(lambda: reader.state is LinkState.STREAMING)
        frames = reader.counters.frames
        wait_for(lambda: reader.counters.frames > frames + 100)
        reader.close()
    events = reader.drain()
    kinds = [event.kind for event in events if isinstance(event, Message)]
    assert kinds == ["link lost", "reconnected"]
    index, _ = samples(events)
    jumps = np.diff(index)
    (gap,) = jumps[jumps > 1]
    # 1.5 s and the wait for the next attempt, at 200 Hz, by the clock.
    assert 300 < gap < 900
    assert reader.counters.reconnections == 1
    lost = [event for event in events if isinstance(event, Lost)]
    assert sum(event.count for event in lost) == pytest.approx(gap - 1, abs=3)
    marks = [part.kind for part in read_rawlog(path) if isinstance(part, Mark)]
    assert marks == ["link lost", "reconnected"]


def test_numbers_never_go_back_after_a_reconnection():
    scripts = [Script([b"abcd", LinkError("script", "gone")]), Script([b"efgh", EndOfStream()])]
    reader = Reader(lambda: scripts.pop(0), Letters(100.0), reopener=lambda: scripts.pop(0))
    events = finish(reader)
    index, data = samples(events)
    assert data.ravel().tolist() == list(b"abcdefgh")
    assert index[:4].tolist() == [0, 1, 2, 3]
    # One second between the attempts at 100 Hz.
    assert 80 < index[4] < 200
    assert np.diff(index)[4:].tolist() == [1, 1, 1]
    (lost,) = [event for event in events if isinstance(event, Lost)]
    assert lost.before == index[4]
    assert lost.count == index[4] - 4


def test_wrong_baud_rate_gives_no_sample():
    with PtyProcess("sim://cvg25") as rig:
        reader = Reader(opener(rig.port, CVG.port, 57600), make_decoder(CVG))
        reader.start()
        wait_for(lambda: reader.counters.bytes > 5000)
        reader.close()
        assert reader.counters.frames == 0
        assert reader.counters.garbage > 4000
        assert reader.state is LinkState.ENDED


def test_half_frames_cost_only_themselves():
    reader = sim_reader("name=half&half=0.05&speed=20")
    reader.start()
    wait_for(lambda: reader.counters.frames > 4000)
    reader.close()
    rig = rig_of("sim://cvg25?name=half&half=0.05&speed=20")
    events = reader.drain()
    _, data = samples(events)
    whole = rig_of("sim://cvg25?name=whole&speed=max")
    reference = make_decoder(CVG).feed(whole.produce(len(data) + len(rig.damaged())))
    _, expected = samples(reference)
    kept = np.delete(expected, rig.damaged()[rig.damaged() < len(expected)], axis=0)
    assert len(rig.damaged()) > 100
    assert np.array_equal(data, kept[: len(data)])


def test_busy_port_is_said():
    with PtyProcess("sim://cvg25") as rig:
        first = Reader(opener(rig.port, CVG.port), make_decoder(CVG))
        first.start()
        wait_for(lambda: first.counters.frames > 10)
        (ended,) = finish(Reader(opener(rig.port, CVG.port), make_decoder(CVG)))
        assert isinstance(ended, Ended)
        assert "busy" in str(ended.error)
        first.close()


def test_a_hundred_openings_leave_nothing_behind():
    def open_files() -> int:
        return len(list(Path("/proc/self/fd").iterdir()))

    with PtyProcess("sim://cvg25?rate=1000") as rig:
        for turn in range(100):
            if turn == 1:
                files, threads = open_files(), threading.active_count()
            reader = Reader(opener(rig.port, CVG.port), make_decoder(CVG))
            reader.start()
            if turn % 10 == 0:
                wait_for(lambda reader=reader: reader.counters.frames > 10)
            reader.close()
            assert isinstance(reader.drain()[-1], Ended)
        assert open_files() == files
        assert threading.active_count() == threads
