"""Blocks, alignment and its noise, the mean of each temperature, turn-ons that were warm."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import FitError
from core.procedures.drift.curves import curves_of
from core.procedures.drift.turn_on import TurnOn


def ramp(label: str, ambient: float, offset: float, chip: float, slope: float = 0.01) -> TurnOn:
    t = (np.arange(400) + 0.5) / 20.0
    return TurnOn(label, ambient, offset + slope * t, 20.0, np.full(400, chip))


def test_offsets_vanish_and_slopes_stay():
    curves = curves_of([ramp("a", 0.0, 5.0, 1.0), ramp("b", 0.0, -3.0, 1.2)])
    assert curves.t[0] == 2.5
    assert curves.t[-1] == 19.5
    assert curves.y == pytest.approx(np.tile(0.01 * (curves.t - 1.75), (2, 1)), abs=1e-12)
    assert curves.temperatures_c == pytest.approx([1.1])
    assert [note.subject for note in curves.notes] == ["one_temperature"]


def test_sets_come_in_any_order():
    made = [ramp("hot", 50.0, 0.0, 51.0, 0.03), ramp("cold", -20.0, 0.0, -19.0, 0.01)]
    curves = curves_of(made)
    assert curves.temperatures_c.tolist() == [-19.0, 51.0]
    assert curves.mean[:, -1] == pytest.approx([0.01 * 17.75, 0.03 * 17.75])


def test_leaving_one_out_keeps_what_has_no_other():
    made = [
        ramp("a", 0.0, 0.0, 1.0, 0.01),
        ramp("b", 0.0, 0.0, 1.0, 0.03),
        ramp("c", 30.0, 0.0, 31.0),
    ]
    curves = curves_of(made)
    assert curves.ranks.tolist() == [0, 1, 0]
    without = curves.mean_without(0)
    assert without[0] == pytest.approx(0.03 * (curves.t - 1.75))
    assert without[1] == pytest.approx(0.01 * (curves.t - 1.75))


def test_a_warm_turn_on_is_left_out_and_named():
    made = [ramp(str(i), 0.0, 0.0, 1.0 + 0.1 * i) for i in range(4)]
    made.append(ramp("hasty", 0.0, 0.0, 8.0, 0.5))
    curves = curves_of(made)
    assert curves.labels == ("0", "1", "2", "3")
    (note,) = (note for note in curves.notes if note.subject == "warm_start")
    assert "hasty began at 8.0 degC" in note.text


def test_the_noise_of_the_alignment_is_stated():
    rng = np.random.default_rng(5)
    noise, rate = 0.02, 100.0
    t = (np.arange(2000) + 0.5) / rate
    made = [
        TurnOn(str(i), 0.0, 0.05 * t + noise * np.sqrt(rate) * rng.standard_normal(2000), rate, t)
        for i in range(40)
    ]
    assert curves_of(made).alignment.u == pytest.approx(noise / np.sqrt(0.5), rel=0.1)


def test_without_the_chip_the_chamber_stands_for_it():
    made = [ramp("a", -10.0, 0.0, np.nan), ramp("b", 40.0, 0.0, np.nan)]
    curves = curves_of(made)
    assert curves.temperatures_c.tolist() == [-10.0, 40.0]
    assert "no_chip_temperature" in [note.subject for note in curves.notes]


def test_what_does_not_fit_is_refused():
    one = ramp("a", 0.0, 0.0, 1.0)
    with pytest.raises(FitError, match=r"window 1\.5 \.\.\. 2 s holds no samples"):
        curves_of([replace(one, start_s=1.8)])
    with pytest.raises(FitError, match="at least 8 are needed"):
        curves_of([one], block_s=3.0)
    with pytest.raises(FitError, match="mislabelled"):
        curves_of([ramp("a", 0.0, 0.0, 30.0), ramp("b", 40.0, 0.0, 1.0)])
