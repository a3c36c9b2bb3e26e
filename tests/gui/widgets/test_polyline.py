"""Nothing of a record is lost between the pyramid and the pixels."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.arrays import frozen
from core.samples.block import Channel
from gui.widgets.history import History
from gui.widgets.polyline import polygon, polygons
from gui.widgets.pyramid import Columns


def points(lines):
    return np.array([(point.x(), point.y()) for line in lines for point in line.toList()])


@settings(max_examples=50)
@given(
    seed=st.integers(0, 2**32 - 1),
    size=st.integers(2, 30_000),
    pixels=st.integers(20, 1500),
    start=st.floats(0, 0.9),
)
def test_extremes_reach_the_screen_at_their_place(seed, size, pixels, start):
    rng = np.random.default_rng(seed)
    values = rng.normal(size=size)
    history = History((Channel("a"),), 1.0)
    history.append(np.arange(size), frozen(values[:, None]))
    first = int(start * size)
    per_sample = pixels / (size - first)
    drawn = points(
        line
        for columns in history.columns(0, first, size, pixels)
        for line in polygons(columns, -first * per_sample, per_sample, 100.0, -10.0)
    )
    for pick in (np.argmin, np.argmax):
        place = first + int(pick(values[first:]))
        wanted = 100.0 - 10.0 * values[place]
        at = drawn[np.isclose(drawn[:, 1], wanted, atol=1e-9), 0]
        # Within the bin that holds it: at most two pixels, or the sample's own place.
        assert np.abs(at - (place - first) * per_sample).min() <= 2.5


def test_lines_break_where_samples_are_missing():
    values = np.array([1.0, 2.0, np.nan, np.nan, 3.0, np.nan, 4.0, 5.0])
    lines = polygons(Columns(10, 1, values, values), 0.0, 1.0, 0.0, 1.0)
    assert [[(p.x(), p.y()) for p in line.toList()] for line in lines] == [
        [(10, 1), (11, 2)],
        [(14, 3)],
        [(16, 4), (17, 5)],
    ]


def test_nothing_gives_no_lines():
    empty = np.empty(0)
    assert polygons(Columns(0, 1, empty, empty), 0.0, 1.0, 0.0, 1.0) == []
    lost = np.full(3, np.nan)
    assert polygons(Columns(0, 4, lost, lost), 0.0, 1.0, 0.0, 1.0) == []


def test_what_is_far_outside_stays_drawable():
    made = polygon(np.array([0.0, 1.0]), np.array([1e300, -1e300]))
    assert max(abs(point.y()) for point in made.toList()) == pytest.approx(3e4)
