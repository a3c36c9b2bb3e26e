"""The simulated set of turn-ons."""

import numpy as np
import pytest

from core.procedures.drift.simulated import (
    AMBIENTS,
    HORIZON_S,
    SHARP_NOISE,
    drift,
    simulated_turn_ons,
)


def test_a_set_holds_so_many_turn_ons_at_each_temperature():
    made = simulated_turn_ons(1, rate=20.0, count=2)
    assert len(made) == 2 * len(AMBIENTS)
    assert {one.ambient_c for one in made} == set(AMBIENTS.tolist())
    assert all(len(one.y) == round(20.0 * HORIZON_S) for one in made)
    assert len({one.label for one in made}) == len(made)


def test_the_drift_is_a_devices_own_and_the_noise_is_that_stated():
    t = np.arange(2400) / 20.0
    assert np.ptp(drift(t, 20.0, 0) - drift(t, 20.0, 1)) > 1e-3
    one = simulated_turn_ons(2, rate=400.0, count=1)[0]
    # Differences of neighbours hold the noise alone, twice its variance.
    sd = np.std(np.diff(one.y)) / np.sqrt(2.0)
    assert sd == pytest.approx(SHARP_NOISE * np.sqrt(400.0), rel=0.02)


def test_the_smooth_kind_has_no_bends():
    t = np.arange(1, 120, 1.0)
    bends = [np.abs(np.diff(drift(t, 20.0, 0, kind), 2)).max() for kind in ("sharp", "smooth")]
    assert bends[0] > 3.0 * bends[1]
