"""Conversion factors against figures from elsewhere."""

import pytest

from core import units


def test_angles():
    assert units.DEG_PER_RAD == pytest.approx(57.29577951308232)
    assert units.RAD_PER_DEG * units.DEG_PER_RAD == pytest.approx(1.0, abs=1e-15)
    assert 1 / units.RAD_PER_ARCSEC == pytest.approx(206264.80624709636)


def test_rates():
    # The Earth turns by 360 degrees against the stars in 86164.0989 s.
    assert units.EARTH_RATE_DPS == pytest.approx(360.0 / 86164.0989, rel=1e-7)
    assert units.EARTH_RATE_DPS * units.DPH_PER_DPS == pytest.approx(15.041067, abs=1e-6)
    # deg/sqrt(s) to deg/sqrt(h): an hour has 3600 s.
    assert units.DEG_PER_RT_H_PER_DEG_PER_RT_S == pytest.approx(3600**0.5)
