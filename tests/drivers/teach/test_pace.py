"""How fast a board sends, where the clock tells it and where it does not."""

import numpy as np
import pytest

from drivers.profile_types import FrameSpec
from drivers.teach.analysis import analyse
from drivers.teach.pace import Pace, clock_doubt, pace_of, usual_rate
from tests.drivers.teach.layouts import frames_of, invented


@pytest.mark.parametrize(("measured", "told"), [(199.2, 200.0), (1003.0, 1000.0), (33.33, 33.3)])
def test_rates_are_rounded_to_usual_ones(measured: float, told: float):
    assert usual_rate(measured) == told


@pytest.mark.parametrize(
    ("address", "baud", "bytes_per_s", "words"),
    [
        ("/dev/ttyUSB0", 115200, 11_000.0, ""),
        ("COM4", 0, 1e6, ""),
        ("", 9600, 2000.0, "faster than 9600 baud"),
        ("sim://pointer", 115200, 5000.0, ""),
        ("sim://pointer?speed=20&seed=3", 921600, 5000.0, "not run in real time"),
        ("replay:///tmp/a.calrec?speed=max", 0, 0.0, "not run in real time"),
        ("replay:///tmp/a.calrec?speed=1", 0, 0.0, ""),
    ],
)
def test_the_clock_is_believed_where_the_bytes_came_as_they_were_sent(
    address: str, baud: int, bytes_per_s: float, words: str
):
    doubt = clock_doubt(address, baud, bytes_per_s)
    assert words in doubt if words else doubt == ""


def lines(steps: np.ndarray, form: str = "{:.0f}") -> bytes:
    noise = np.random.default_rng(6).integers(-500, 500, len(steps))
    times = np.cumsum(steps)
    rows = (f"{form.format(t)};{n}\r\n" for t, n in zip(times, noise, strict=True))
    return "".join(rows).encode()


@pytest.mark.parametrize(
    ("step", "form", "hz", "unit"),
    [
        (5.0, "{:.0f}", 200.0, "milliseconds"),
        (10_000.0, "{:.0f}", 100.0, "microseconds"),
        (0.02, "{:.3f}", 50.0, "seconds"),
    ],
)
def test_a_time_among_the_numbers_tells_it(step: float, form: str, hz: float, unit: str):
    proposal = analyse(lines(np.full(200, step), form), 9e5, "too fast")
    assert proposal.hz == hz
    assert f"is the time in {unit}" in proposal.pace.why
    assert proposal.pace.why.startswith("too fast; ")


def test_a_time_that_jitters_by_its_last_digit_still_tells_it():
    steps = np.where(np.arange(300) % 3, 3.0, 4.0)
    assert analyse(lines(steps), 0.0).hz == 300.0


@pytest.mark.parametrize("step", [1.0, 230.0])
def test_what_counts_frames_or_fits_no_usual_rate_tells_nothing(step: float):
    proposal = analyse(lines(np.full(200, step)), 0.0)
    assert proposal.found is not None
    assert proposal.hz == 0.0
    assert "none of its numbers is the time" in proposal.pace.why


def test_the_clock_goes_before_a_time_among_the_numbers():
    data = lines(np.full(200, 5.0))
    proposal = analyse(data, len(data) / 200 * 50.0)
    assert proposal.pace == Pace(50.0)


def test_frames_without_a_time_have_none():
    rng = np.random.default_rng(3)
    layout = invented(rng, checked=True)
    data = frames_of(layout, rng, 0, 300).tobytes()
    proposal = analyse(data)
    assert isinstance(proposal.stream, FrameSpec)
    assert pace_of(data, proposal.stream, 0.0).hz == 0.0
