"""The small parts: progress, visits, devices, live means."""

from dataclasses import replace

import numpy as np
import pytest

from core.arrays import frozen, frozen_int
from core.plans.plan import load_plans
from core.procedures.recognise import Nominal
from core.records.session.events import Position
from core.samples.accumulate import accumulation_of
from core.samples.block import Channel, SampleBlock
from drivers.decoders import make_decoder
from drivers.profile import load_profiles
from gui.dividing_head.device import head_device
from gui.dividing_head.processing import mg_per_unit
from gui.measuring.counts import progress_of, visits_of
from gui.measuring.live import LiveMeans
from tests.gui.desk import Desk
from tests.gui.fake_bench import BIAS, K

STEPS = load_plans()["accelerometer_4"].steps
CHANNELS = (Channel("acc_x", "code", "acc.x"),)


def position(number: int, step: int, set_c: float = float("nan")) -> Position:
    t = np.linspace(0.0, 1.0, 32)
    mean = accumulation_of(CHANNELS, t, t[:, None])
    return Position(number, 1, STEPS[step - 1], "", mean, float("nan"), set_c, None)


def test_progress_counts_passes():
    here = [position(i + 1, step) for i, step in enumerate((1, 2, 3, 4, 1))]
    first = progress_of(STEPS, here, [], 1)
    assert first.finished
    second = progress_of(STEPS, here, [], 2)
    assert not second.finished
    assert [p.id for p in second.done] == [5]
    assert [p.id for p in second.before] == [1, 2, 3, 4]
    assert dict(second.counts) == {1: 2, 2: 1, 3: 1, 4: 1}
    assert not progress_of(STEPS, [], [], 1).finished


def test_the_same_temperature_twice_is_two_visits():
    cycle = (27.0, -10.0, 27.0)
    kept = [
        position(1, 1, 27.0),
        position(2, 2, 27.0),
        position(3, 1, -10.0),
        position(4, 1, 27.0),
        position(5, 2, 27.0),
    ]
    assert visits_of(kept, cycle) == {1: 0, 2: 0, 3: 1, 4: 2, 5: 2}
    assert visits_of([position(1, 1, 99.0)], cycle) == {1: 0}
    assert visits_of([position(1, 1)], ()) == {1: 0}


@pytest.mark.parametrize(
    ("profile", "layout", "rows"),
    [("pw09_raw", "pointer", 3), ("adc_board9", "clbacc", 9), ("adxrs_board9", "", 0)],
)
def test_what_a_profile_is_on_the_head(profile: str, layout: str, rows: int):
    found = load_profiles()[profile]
    device = head_device(found, make_decoder(found).channels)
    if not layout:
        assert device is None
        return
    assert device is not None
    assert (device.layout, len(device.rows), len(device.axes)) == (layout, rows, rows)
    assert all(row.main_temp for row in device.rows)


def test_live_means_are_of_the_last_second():
    profile = load_profiles()["pw09_raw"]
    channels = make_decoder(profile).channels
    device = head_device(profile, channels)
    assert device is not None
    live = LiveMeans(device, 100.0)
    for start, level in ((0, 500.0), (100, -3.0)):
        for k in range(10):
            index = frozen_int(np.arange(start + 10 * k, start + 10 * k + 10))
            live.feed(
                SampleBlock(channels, index, frozen(np.full((10, len(channels)), level)), 100)
            )
    assert {row.mean for row in live.state({}, "mg").rows} == {"−3.0"}
    live.clear()
    assert {row.mean for row in live.state({}, "mg").rows} == {""}


def test_milli_g_of_a_code():
    scale = mg_per_unit(np.array([[1000.0], [0.0]]), ("acc.x", "acc.y"), 9.81)
    assert scale == {"acc.x": pytest.approx(1e3 / 9810.0)}


def test_what_is_known_of_a_device_is_used_and_what_does_not_fit_is_not(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
):
    known = Nominal(frozen(K), frozen(BIAS), "last year")
    asked: list[str] = []

    def nominal_of(name: str) -> Nominal | None:
        asked.append(name)
        return known

    monkeypatch.setattr(desk.sitting.guide, "nominal", lambda root, name: nominal_of(name))
    desk.presenter.new_session()
    assert asked == ["PW09"]
    # With the signs known, the very first position can be wrong.
    desk.measure(desk.sitting.plan.step(2))
    assert desk.numbers == []
    assert "looks like position 2" in desk.what
    desk.presenter.act("discard")
    desk.set(accumulation_s=1.5)
    assert asked == ["PW09"]
    known = replace(known, k=frozen(K[:2]), bias=frozen(BIAS[:2]))
    desk.presenter.new_session()
    desk.set(accumulation_s=1.0)
    desk.measure()
    assert desk.numbers == [1]
