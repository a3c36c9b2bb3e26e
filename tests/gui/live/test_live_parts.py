"""Parts of the Live tab without a window: settings, traces, tables, CSV."""

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.errors import FormatError
from core.samples.block import Channel, SampleBlock
from gui.live.figures import cursor_table
from gui.live.sample_files import write_csv, write_excel, write_mat
from gui.live.scene import actions
from gui.live.settings import LiveSettings, settings_of
from gui.live.state import Phase
from gui.live.trace import WATCH_S, Excerpt, Trace
from gui.widgets.history import History

TWO = (Channel("a", "V"), Channel("b"))


def block(first, count, rate=100.0):
    index = frozen_int(np.arange(first, first + count))
    return SampleBlock(TWO, index, frozen(np.stack([index * 0.5, -index], axis=1)), rate)


def trace(name="", count=1000):
    made = Trace(History(TWO, 100.0), name)
    made.feed(block(5000, count))
    return made


def test_settings_survive_their_section_and_bad_values_do_not():
    settings = LiveSettings("25-143", False, 3, 0.025, 20, False, 500, 7, 3.0, ("b",))
    assert settings_of(settings.to_section()) == settings
    assert settings_of({"profile": "x", "sampling_hz": 33, "points": -1}) == LiveSettings()


def test_only_samples_of_the_record_are_taken():
    made = Trace(History(TWO, 100.0), "r")
    made.feed(block(0, 100), first=40, stop=90)
    made.feed(block(80, 40), first=40, stop=110)
    assert made.excerpt([(0.0, 9.0)]).samples()[0].tolist() == list(range(40, 110))


def test_what_is_only_watched_is_shortened_and_a_record_never():
    watched, recorded = trace(count=10), trace("r", count=10)
    for made in (watched, recorded):
        made.feed(block(5010, round(WATCH_S * 100)))
    assert watched.shorten()
    assert watched.seconds == pytest.approx(60.0)
    assert watched.newest == 5009 + round(WATCH_S * 100)
    assert not recorded.shorten()


def test_chosen_is_intervals_else_cursors_else_all():
    made = trace()
    assert made.chosen(None, 2.0) == [(0.0, 10.0)]
    assert made.chosen(3.0, 2.0) == [(2.0, 3.0)]
    made.add_interval(-1.0, 1.0)
    made.add_interval(9.0, 99.0)
    assert made.chosen(3.0, 2.0) == [(0.0, 1.0), (9.0, 10.0)]
    made.select_all(False)
    assert made.chosen(3.0, 2.0) == [(2.0, 3.0)]


def test_slope_and_extremes_between_cursors():
    table = cursor_table(trace(), [0], 1.0, 3.0)
    (row,) = table.rows
    assert row[:3] == ("a", "V", "201")
    assert [float(cell) for cell in (row[3], row[5], row[6])] == [2600.0, 2550.0, 2650.0]
    assert float(row[7]) == 100.0
    assert float(row[8]) == 50.0


def test_csv_comes_back_in_both_locales(tmp_path):
    excerpt = trace().excerpt([(0.0, 0.03)])
    write_csv(excerpt, tmp_path / "plain.csv")
    assert (tmp_path / "plain.csv").read_text("utf-8").splitlines() == [
        "index,t [s],a [V],b [code]",
        "5000,0.000000,2500,-5000",
        "5001,0.010000,2500.5,-5001",
        "5002,0.020000,2501,-5002",
    ]
    write_excel(excerpt, tmp_path / "other.csv")
    other = (tmp_path / "other.csv").read_bytes()
    assert other.startswith(b"\xef\xbb\xbf")
    assert other.decode("utf-8-sig").splitlines()[2] == "5001;0,010000;2500,5;-5001"


def test_matlab_has_names_times_and_samples(tmp_path):
    from scipy.io import loadmat

    excerpt = trace().excerpt([(0.0, 0.03)])
    write_mat(excerpt, tmp_path / "r.mat")
    record = loadmat(tmp_path / "r.mat", squeeze_me=True)["record"]
    assert np.array_equal(record["data"].item(), excerpt.samples()[1])
    assert record["t"].item() == pytest.approx([0.0, 0.01, 0.02])
    assert record["names"].item().tolist() == ["a", "b"]


def test_more_than_matlab_holds_is_refused(tmp_path):
    huge = Excerpt(trace().history, ((0, 200_000_000),))
    with pytest.raises(FormatError, match="2 GB"):
        write_mat(huge, tmp_path / "r.mat")


def test_an_excerpt_stays_as_it_was_and_comes_in_bounded_pieces():
    made = trace(count=150_000)
    excerpt = made.excerpt([(0.0, 1e9), (1.0, 2.0)])
    made.feed(block(155_000, 5000))
    parts = list(excerpt.pieces())
    assert max(len(index) for index, _ in parts) <= 1 << 16
    index, data = excerpt.samples()
    assert index.tolist() == [*range(5000, 155_000), *range(5100, 5200)]
    assert np.array_equal(data[:, 0], 0.5 * index)


@pytest.mark.parametrize(
    ("phase", "first", "enabled"),
    [
        (Phase.OFFLINE, "start", {"load"}),
        (Phase.WATCHING, "start", {"start", "load"}),
        (Phase.RECORDING, "stop", {"stop", "export"}),
        (Phase.STOPPED, "start", {"start", "resume", "discard", "watch", "load", "export"}),
    ],
)
def test_buttons_of_each_phase(phase, first, enabled):
    items = actions(
        phase,
        linked=phase is not Phase.OFFLINE,
        resumable=phase is Phase.STOPPED,
        samples=phase in (Phase.RECORDING, Phase.STOPPED),
    ).items
    assert items[0].key == first
    assert {item.key for item in items if item.enabled} == enabled
    assert all(item.why_not for item in items if not item.enabled)
