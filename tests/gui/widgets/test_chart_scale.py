import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gui.widgets.chart_scale import HeldRange, nice_step, tick_text, ticks, time_step, time_text


@given(st.floats(1e-9, 1e9), st.integers(1, 30))
def test_steps_are_round_and_few(span, count):
    step = nice_step(span, count)
    assert span / step <= count * (1 + 1e-6)
    assert span / step > count / 2.6
    leading = step / 10 ** math.floor(math.log10(step) + 1e-9)
    assert min(abs(leading - nice) for nice in (1, 2, 5)) < 1e-6


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6), st.integers(2, 12))
def test_ticks_lie_inside_and_have_labels_of_their_own(low, span, count):
    step = nice_step(span, count)
    found = ticks(low, low + span, step)
    assert len(found) <= count + 1
    assert all(low - 1e-6 * step <= tick <= low + span + 1e-6 * step for tick in found)
    labels = [tick_text(tick, step) for tick in found]
    assert len(set(labels)) == len(labels)


@pytest.mark.parametrize(
    ("value", "step", "text"),
    [
        (-0.0205, 0.0005, "\N{MINUS SIGN}0.0205"),
        (0.1 + 0.2 - 0.3, 0.1, "0.0"),
        (-0.0, 1.0, "0"),
        (13000.0, 500.0, "13000"),
        (2.5e-10, 5e-11, "2.5e\N{MINUS SIGN}10"),
        (3e9, 1e9, "3e+09"),
    ],
)
def test_labels(value, step, text):
    assert tick_text(value, step) == text


def test_times():
    assert time_step(7.0, 8) == 1.0
    assert time_step(100.0, 8) == 15.0
    assert time_step(3700.0, 7) == 600.0
    assert time_step(30 * 86400.0, 10) == 5 * 86400.0
    assert time_text(12.5, 0.5, 20.0) == "12.5"
    assert time_text(200.0, 10.0, 300.0) == "3:20"
    assert time_text(3800.0, 600.0, 4000.0) == "1:03:20"
    assert time_text(-5.0, 1.0, 300.0) == "\N{MINUS SIGN}0:05"
    assert time_text(61.96, 0.1, 300.0) == "1:02.0"


def test_range_is_held_until_data_leave_it():
    held = HeldRange()
    assert held.fit(-1.0, 1.0)
    limits = (held.low, held.high)
    assert limits == pytest.approx((-1.2, 1.2))
    assert not held.fit(-1.19, 1.1)
    assert not held.fit(-0.7, 0.7)
    assert (held.low, held.high) == limits
    assert held.fit(-1.3, 1.0)
    assert held.fit(-0.2, 0.3)
    assert held.low < -0.2 < 0.3 < held.high


@given(st.floats(-1e9, 1e9), st.floats(0, 1e6))
def test_range_always_holds_what_it_was_given(low, span):
    held = HeldRange()
    held.fit(low, low + span)
    assert held.low < held.high
    assert held.low <= low
    assert low + span <= held.high
    assert not held.fit(low, low + span)


def test_nothing_shown_changes_nothing():
    held = HeldRange()
    assert not held.fit(math.nan, math.nan)
    held.fit(5.0, 5.0)
    assert held.low < 5.0 < held.high
    fine = 23.733621597
    held = HeldRange()
    held.fit(fine, fine)
    held.fit(fine - 1e-6, fine + 1e-6)
    assert held.high - held.low < 1e-5
